// A pool of child processes that run plans, each with a prepared run of its own.
#pragma once

#include <sys/types.h>

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "openr/explore/fork_server.h"

namespace openr_host {

// The choice of memory addresses for a child process.
enum class Memory {
  kAsItComes,
  kElsewhere,  // heap, stacks and images have other addresses than in kAsItComes
};

class ExplorerProcesses {
 public:
  // Starts the processes and waits until each has its prepared run.  A plan with "twice" is run a
  // second time in a process with kElsewhere and another length of time slices; `twice` says that
  // such plans will come.  If state or trace differ, it is run a third time at the addresses of the
  // first run.  In the answer, "depends_on_addresses" says that the third run was like the first,
  // "differs" that it was not.  The child processes close `outer_channel`.  Throws
  // std::runtime_error when a process cannot make its prepared run.  REQUIRES: this process has one
  // thread.
  ExplorerProcesses(const PrepareRun& prepare_run, const RunOptions& options,
                    const ForkLimits& limits, int count, bool twice = false,
                    Memory memory = Memory::kAsItComes, int outer_channel = -1);
  ~ExplorerProcesses();  // ends the processes
  ExplorerProcesses(const ExplorerProcesses&) = delete;
  ExplorerProcesses& operator=(const ExplorerProcesses&) = delete;

  // Calls `next` until it returns nothing, gives each plan to an idle process, and calls `take` for
  // each answer as it comes, with the number of its plan, from 0.  Throws std::runtime_error when a
  // plan has a problem or a process has ended.
  void Run(const std::function<std::optional<nlohmann::ordered_json>()>& next,
           const std::function<void(size_t number, nlohmann::ordered_json answer)>& take);

  nlohmann::ordered_json RunOne(const nlohmann::ordered_json& plan);

 private:
  struct Child {
    pid_t pid = -1;
    int channel = -1;
    bool is_busy = false;
    size_t number = 0;  // number of its plan
    std::string heard;  // start of the next line
  };
  struct Job;  // options of a child process
  void Start(const Job& job);
  // Returns the next line of a process if one is there, without waiting.
  std::optional<std::string> ReadLine(Child* child);
  std::string WaitForLine(Child* child);

  std::vector<Child> children_;
};

}  // namespace openr_host

// A pool of child processes that make runs.  Each child process assembles a run once, and then
// makes a run for each plan (run_plan.h) that it gets.
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
  kAsItComes,  // the addresses that this program usually has
  kElsewhere,  // heap, stacks and images have other addresses than in kAsItComes
};

class ExplorerProcesses {
 public:
  // Starts `count` child processes and waits until each has assembled its run.  Throws
  // std::runtime_error when a process cannot do so.  `memory` chooses the memory addresses in these
  // processes.  `outer_channel` is a descriptor that the child processes inherit and do not use, so
  // they close it (-1: none).  REQUIRES: this process has one thread, because fork() copies no
  // other thread.
  //
  // If `twice` is true, plans may have the field "twice", which tests whether a run gives the same
  // result again.  The plan is then run a second time, in a process with Memory::kElsewhere and in
  // time slices of another length.  If a hash (of state or trace) differs from the first run, a
  // third run shows the reason: it has the slices of the second run and the addresses of the first.
  // The answer gets three more fields: "differs" is true if the third run differs from the first,
  // "depends_on_addresses" if only the second run does, and "not_compared" if a run was killed and
  // so has no hashes.
  ExplorerProcesses(const PrepareRun& prepare_run, const RunOptions& options,
                    const ForkLimits& limits, int count, bool twice = false,
                    Memory memory = Memory::kAsItComes, int outer_channel = -1);
  ~ExplorerProcesses();  // ends the processes
  ExplorerProcesses(const ExplorerProcesses&) = delete;
  ExplorerProcesses& operator=(const ExplorerProcesses&) = delete;

  // Calls `next` for a plan whenever a child process is idle, until `next` returns nothing.  Calls
  // `take` for each answer as soon as it comes; `number` is the number of its plan, counted from 0.
  // Throws std::runtime_error when a plan does not fit the objects of the runs, or when a child
  // process has ended.
  void Run(const std::function<std::optional<nlohmann::ordered_json>()>& next,
           const std::function<void(size_t number, nlohmann::ordered_json answer)>& take);

  nlohmann::ordered_json RunOne(const nlohmann::ordered_json& plan);

 private:
  struct Child {
    pid_t pid = -1;
    int channel = -1;
    bool is_busy = false;
    size_t number = 0;  // number of the plan that the child process runs now
    std::string heard;  // received part of the child's next line
  };
  struct Job;  // options with which a child process works
  void Start(const Job& job);
  // Reads the bytes that `child` has sent, and does not wait for more.  Returns the next line if it
  // is complete, else nullopt.
  std::optional<std::string> ReadLine(Child* child);
  std::string WaitForLine(Child* child);

  std::vector<Child> children_;
};

}  // namespace openr_host

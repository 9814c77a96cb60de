// Worker processes, each with a prepared run of its own, that run the plans they are given.
#pragma once

#include <sys/types.h>

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "openr/explore/fork_server.h"

namespace openr_host {

// Where a worker's memory lies.
enum class Memory {
  kAsItComes,
  kElsewhere,  // heap, stacks and images at other addresses than in workers as they come
};

class WorkerPool {
 public:
  // Starts `workers` processes and waits until each has its prepared run.  A plan with "twice" is
  // run a second time by a process with its memory elsewhere, sliced differently, and a third time
  // here when state or trace differ.  In the answer "depends_on_addresses" says that the third run
  // was like the first, "differs" that it was not; `twice` says that such plans will come.
  // `outer_channel` is closed in the workers.  Throws std::runtime_error when a worker cannot make
  // its prepared run. REQUIRES: the process has one thread.
  WorkerPool(const PrepareRun& prepare_run, const RunOptions& options, const ForkLimits& limits,
             int workers, bool twice = false, Memory memory = Memory::kAsItComes,
             int outer_channel = -1);
  ~WorkerPool();  // ends them
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  // Gives every plan of `next` (until it returns nothing) to the next idle worker, and every answer
  // to `take` as it comes, with the number of its plan, from 0.  Throws std::runtime_error when a
  // plan has a problem or a worker is lost.
  void Run(const std::function<std::optional<nlohmann::ordered_json>()>& next,
           const std::function<void(size_t number, nlohmann::ordered_json answer)>& take);

  nlohmann::ordered_json RunOne(const nlohmann::ordered_json& plan);

 private:
  struct Worker {
    pid_t pid = -1;
    int channel = -1;
    bool is_busy = false;
    size_t number = 0;  // of its plan
    std::string heard;  // not a whole line yet
  };
  struct Job;  // what a worker process is made with
  void Start(const Job& job);
  // The next line of a worker, when there is one without waiting.
  std::optional<std::string> ReadLine(Worker* worker);
  std::string WaitForLine(Worker* worker);

  std::vector<Worker> workers_;
};

}  // namespace openr_host

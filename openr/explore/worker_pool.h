// Worker processes, each with the scene of its own, that run what they are told.
#pragma once

#include <sys/types.h>

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "openr/explore/fork_server.h"

namespace openr_host {

class WorkerPool {
 public:
  // Starts `workers` processes and waits until each has its scene.  Throws std::runtime_error when
  // one cannot make it.  REQUIRES: the process has one thread.
  WorkerPool(const MakeScene& make_scene, const RunOptions& options, const ForkLimits& limits,
             int workers);
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
  void Start(const MakeScene& make_scene, const RunOptions& options, const ForkLimits& limits);
  // The next line of a worker, when there is one without waiting.
  std::optional<std::string> ReadLine(Worker* worker);
  std::string WaitForLine(Worker* worker);

  std::vector<Worker> workers_;
};

}  // namespace openr_host

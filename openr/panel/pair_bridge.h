// PairBridge, through which one page controls a robot of its run together with a second robot.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>

#include "openr/live/live_folder.h"
#include "openr/panel/outbox.h"

namespace openr_host {

class PairControl;

// Connects both robots and serves them in a thread of its own, because a robot may not answer
// (docs/panel-server.md, "Both dogs").  The answer to the request that has made the bridge, and
// events "pair", go into an outbox.
class PairBridge {
 public:
  // Number of threads of all bridges of this process.
  static constexpr int kThreadsMax = 16;

  // `request` has the address of the second robot.  Throws std::runtime_error if it has none, or
  // there are too many threads.
  PairBridge(const LiveRun& run, size_t robot, const nlohmann::json& request,
             std::shared_ptr<Outbox> outbox);
  // Lets the thread disconnect both robots.  Does not wait for that.
  ~PairBridge();
  PairBridge(const PairBridge&) = delete;
  PairBridge& operator=(const PairBridge&) = delete;

  // Changes what the robots do, as `request` says.  Throws std::runtime_error for another value.
  void Set(const nlohmann::json& request);

  // Returns whether the connection has failed or was lost.
  bool is_over() const;

  // Returns whether a bridge of this process has a thread.
  static bool HasThreads();

  struct Work;  // what the thread and the bridge share

 private:
  const std::shared_ptr<Work> work_;
};

}  // namespace openr_host

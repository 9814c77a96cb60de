// PairBridge, through which one page controls a robot of its run together with a second robot.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "openr/live/live_folder.h"
#include "openr/panel/answer_queue.h"

namespace openr_host {

class PairControl;

// Connects both robots and serves them in a thread of its own, because a robot may not answer
// (docs/panel-server.md, "Both dogs").  Queues events "pair" for the page, and also the answer to
// the request that has made the bridge.
class PairBridge {
 public:
  // The largest number of threads that all PairBridge objects of this process together may have.
  static constexpr int kThreadsMax = 16;

  // Makes the bridge and its thread.  `request` has the address of the second robot.  Throws
  // std::runtime_error if the address is missing, if there are too many threads, or if this
  // computer cannot make another thread.
  PairBridge(const LiveRun& run, size_t robot, const nlohmann::json& request,
             std::shared_ptr<AnswerQueue> answers);
  // Makes the thread disconnect both robots, and does not wait until it has done so.
  ~PairBridge();
  PairBridge(const PairBridge&) = delete;
  PairBridge& operator=(const PairBridge&) = delete;

  // Changes what the two robots do, as `request` says.  Throws std::runtime_error if a value in
  // `request` is not allowed.
  void Set(const nlohmann::json& request);

  // Returns whether the connection of the two robots could not be made or was lost.
  bool is_over() const;

  // Returns whether the thread of any PairBridge of this process still runs.
  static bool HasThreads();

  struct Work;  // data that the bridge shares with its thread

 private:
  const std::shared_ptr<Work> work_;
};

}  // namespace openr_host

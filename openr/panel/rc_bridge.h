// RcBridge, through which one page uses the remote control of one robot.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "openr/panel/outbox.h"
#include "openr/panel/rc_calls.h"

namespace openr_host {

// Carries out the remote-control calls of a page in a thread of its own, because each call waits
// for the robot.  Answers and events go into an outbox.
class RcBridge {
 public:
  // Limits of the calls that may wait.  A call beyond is answered with an error.
  static constexpr size_t kCallsMax = 64;
  static constexpr size_t kBytesMax = size_t{16} << 20;
  // Number of threads of all bridges of this process.
  static constexpr int kThreadsMax = 64;

  // Throws std::runtime_error if there are too many threads.
  RcBridge(RcCalls::FindAddress find_address, std::shared_ptr<Outbox> outbox);
  // Ends the thread after the call that it does now.  Does not wait for that.
  ~RcBridge();
  RcBridge(const RcBridge&) = delete;
  RcBridge& operator=(const RcBridge&) = delete;

  // Adds a call, which has `size` bytes.  A command for the value of a joint takes the place of one
  // for the same value that still waits: the older one is not sent, and both get the same answer.
  void Add(nlohmann::json request, size_t size);

  // Returns whether a bridge of this process has a thread.
  static bool HasThreads();

  struct Queue;  // what the thread and the bridge share

 private:
  const std::shared_ptr<Outbox> outbox_;
  const std::shared_ptr<Queue> queue_;
};

}  // namespace openr_host

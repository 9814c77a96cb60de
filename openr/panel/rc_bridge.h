// RcBridge, through which one page uses the remote control of one robot.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "openr/panel/answer_queue.h"
#include "openr/panel/rc_calls.h"

namespace openr_host {

// Carries out the remote-control calls of a page in a thread of its own, because each call waits
// for the robot.  Queues the answers and events for the page.
class RcBridge {
 public:
  // The largest number of remote-control calls of the page that may wait.  If more calls come, they
  // are answered with an error.
  static constexpr size_t kCallsMax = 64;
  // The largest number of bytes of remote-control calls of the page that may wait.  If more bytes
  // come, their calls are answered with an error.
  static constexpr size_t kBytesMax = size_t{16} << 20;
  // The largest number of threads that all RcBridge objects of this process together may have.
  static constexpr int kThreadsMax = 64;

  // Makes the bridge and its thread.  Throws std::runtime_error if there are too many threads, or
  // if this computer cannot make another thread.
  RcBridge(RcCalls::FindAddress find_address, std::shared_ptr<AnswerQueue> answers);
  // Makes the bridge's thread end after its present remote-control call, and does not wait until it
  // has ended.
  ~RcBridge();
  RcBridge(const RcBridge&) = delete;
  RcBridge& operator=(const RcBridge&) = delete;

  // Adds a remote-control call of the page, which has `size` bytes.  A command that sets a value of
  // a joint replaces a waiting command for the same value: the older command is not sent, and both
  // get the same answer.
  void Add(nlohmann::json request, size_t size);

  // Returns whether the thread of any RcBridge of this process still runs.
  static bool HasThreads();

  struct Queue;  // data that the bridge shares with its thread

 private:
  const std::shared_ptr<AnswerQueue> answers_;
  const std::shared_ptr<Queue> queue_;
};

}  // namespace openr_host

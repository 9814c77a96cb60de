#include "openr/panel/rc_bridge.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "cli/json_text.h"
#include "openr/live/request_reader.h"

namespace openr_host {
namespace {

std::atomic<int> g_bridge_threads = 0;

// Returns the name of the value that a remote-control command sets for a joint.  Commands that set
// the same value give the same name.
std::string JointValueOf(const nlohmann::json& request) {
  const std::string call = RequestReader(request).TextOr("call", "");
  if (call != "move" && call != "speed" && call != "accel") return "";
  const auto joint = request.find("joint");
  return joint == request.end() ? "" : call + " " + JsonText(*joint);
}

void Answer(AnswerQueue* answers, RcCalls::Json answer, const std::vector<nlohmann::json>& ids) {
  for (const nlohmann::json& id : ids) {
    if (!id.is_null()) answer["id"] = id;
    answers->Add(JsonText(answer));
  }
}

}  // namespace

struct RcBridge::Queue {
  // A remote-control call of the page that waits to be sent to the robot.  Its member `ids` has the
  // ids of all requests that get its answer: of its own request and of the requests that it has
  // replaced.
  struct Call {
    nlohmann::json request;
    size_t size;
    // Name of the joint's value that this remote-control call sets (JointValueOf()); "": it sets
    // none.
    std::string joint_value;
    std::vector<nlohmann::json> ids;
  };

  std::mutex mutex;
  std::condition_variable changed;
  std::deque<Call> calls;
  size_t bytes = 0;
  bool is_ended = false;

  // Waits for a remote-control call of the page and takes it.  Returns false when the bridge does
  // not exist any more.
  bool WaitForCall(Call* call) {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return is_ended || !calls.empty(); });
    if (is_ended) return false;
    *call = std::move(calls.front());
    calls.pop_front();
    bytes -= call->size;
    return true;
  }
};

namespace {

void DoCalls(RcBridge::Queue* queue, RcCalls* calls, AnswerQueue* answers) {
  RcBridge::Queue::Call call;
  while (queue->WaitForCall(&call)) {
    const auto progress = [&](size_t sent, size_t size) {
      answers->Add(JsonText(
          RcCalls::Json{{"event", "upload"}, {"id", call.ids[0]}, {"sent", sent}, {"size", size}}));
    };
    Answer(answers, calls->Do(call.request, progress), call.ids);
  }
}

}  // namespace

RcBridge::RcBridge(RcCalls::FindAddress find_address, std::shared_ptr<AnswerQueue> answers)
    : answers_(std::move(answers)), queue_(std::make_shared<Queue>()) {
  if (g_bridge_threads >= kThreadsMax)
    throw std::runtime_error("too many connections to robots are being closed; try again soon");
  ++g_bridge_threads;
  try {
    // Detaches the thread, because the event loop must not wait for it: a call to a robot that does
    // not answer takes seconds.
    std::thread([find_address = std::move(find_address), answers = answers_, queue = queue_] {
      {
        RcCalls calls(find_address);
        DoCalls(queue.get(), &calls, answers.get());
      }
      --g_bridge_threads;
    }).detach();
  } catch (const std::system_error&) {
    --g_bridge_threads;  // this computer cannot make a thread
    throw;
  }
}

RcBridge::~RcBridge() {
  const std::lock_guard lock(queue_->mutex);
  queue_->is_ended = true;
  queue_->changed.notify_one();
}

void RcBridge::Add(nlohmann::json request, size_t size) {
  std::vector<nlohmann::json> ids = {request.value("id", nlohmann::json())};
  const std::string joint_value = JointValueOf(request);
  const std::lock_guard lock(queue_->mutex);
  auto& calls = queue_->calls;
  const auto older = std::find_if(calls.begin(), calls.end(), [&](const Queue::Call& call) {
    return !joint_value.empty() && call.joint_value == joint_value;
  });
  // Replaces the older command for the same value of the joint, because a slider that is dragged
  // makes commands faster than a robot takes them.
  if (older != calls.end()) {
    ids.insert(ids.begin(), older->ids.begin(), older->ids.end());
    queue_->bytes -= older->size;
    calls.erase(older);
  }
  if (calls.size() >= kCallsMax || queue_->bytes + size > kBytesMax || ids.size() > kCallsMax) {
    Answer(answers_.get(), {{"error", "too many commands wait for the robot; is it busy?"}}, ids);
    return;
  }
  queue_->bytes += size;
  calls.push_back({std::move(request), size, joint_value, std::move(ids)});
  queue_->changed.notify_one();
}

bool RcBridge::HasThreads() { return g_bridge_threads > 0; }

}  // namespace openr_host

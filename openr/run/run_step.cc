#include "openr/run/run_step.h"

#include <algorithm>
#include <string>

#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// The longest virtual time of a step to the next message, or to the next message with sensor
// values.  The step ends after this time even if no such message has come.
constexpr int64_t kStepMaxUs = 1'000'000;

// Returns whether `message` gives an object new sensor values.
bool IsSensorVector(System& system, const TraceRecord& record, const Message& message) {
  if (message.kind != PayloadKind::kNotify) return false;
  const Object* const receiver = system.object(record.target);
  return receiver != nullptr &&
         receiver->EntryName(record.selector).find("OSensorFrameVectorData") != std::string::npos;
}

}  // namespace

void MakeStep(Simulation* simulation, RunClock::Step step, int64_t frame_end_us,
              const std::function<void(int64_t time_us)>& run_one) {
  System& system = simulation->system();
  const bool is_frame = step == RunClock::Step::kFrame;
  bool has_come = false;
  const int sink = system.trace().AddSink([&](const TraceRecord& record, const Message& message) {
    has_come = has_come || step == RunClock::Step::kMessage ||
               (!is_frame && IsSensorVector(system, record, message));
  });
  const int64_t end_us = is_frame ? frame_end_us : system.now_us() + kStepMaxUs;
  for (bool goes_on = true; goes_on && !has_come;) {
    const int64_t before_us = system.now_us();
    const uint64_t messages = system.message_count();
    const int64_t next_frame_us = (before_us / kFrameUs + 1) * kFrameUs;
    // Runs at most to end_us.  At end_us, virtual time does not advance any more, but `run_one`
    // still delivers the messages that are due at end_us.
    run_one(std::max(before_us, std::min(next_frame_us, end_us)));
    goes_on = system.now_us() != before_us || system.message_count() != messages;
  }
  system.trace().RemoveSink(sink);
}

}  // namespace openr_host

// The functions of Bench that run the robot, and that check the test's expectations.
#include <fmt/format.h>

#include "openr/decode/decode_message.h"
#include "testing/bench.h"
#include "virtualrobot/virtual_robot.h"

namespace openr::testing {

using openr_host::Finding;
using openr_host::Message;
using openr_host::SensorSource;
using openr_host::Severity;

namespace {

constexpr int64_t kBootUsMax = 60'000'000;
constexpr int64_t kStepToMessageUsMax = 3'600'000'000;
// The longest time that the bench waits for the next frame.  Each body begins a frame every
// kFrameUs, so a longer wait means that the body has stopped.
constexpr int64_t kFrameUsMax = 10 * openr_host::kFrameUs;

std::string Seconds(Duration duration) {
  return fmt::format("{} s", static_cast<double>(duration.count()) * 1e-6);
}

const char* HintFor(std::string_view what) {
  return what.ends_with("thread")
             ? "An object is woken by messages and timers, one handler at a time."
             : "The network of a bench is the robot's IPStack, with AddClient() at the other end.";
}

}  // namespace

bool Bench::ReportFailure(const Place& place, const std::string& what) {
  Fail(place, what + "\n" + Story());
  return false;
}

bool Bench::IsRunning(const Place& place) {
  if (system_->message_count() > 0 || system_->queue().size() > 0) return true;
  return ReportFailure(place, "The robot is off: Boot() the bench first");
}

bool Bench::RunControlled(const Place& place, const std::function<void()>& run) {
  if (const int threads = options_.allow_threads ? 1 : ThreadCount(); threads > 1) {
    return ReportFailure(
        place, fmt::format("This process has {} threads, and no two runs beside others are "
                           "alike.  End them first, or say {{.allow_threads = true}} if they "
                           "never touch the bench.",
                           threads));
  }
  std::vector<std::string> refused;
  {
    const ControlledScope scope;
    run();
    refused = scope.refused();
  }
  for (const std::string& what : refused)
    ReportFailure(place,
                  fmt::format("{}: refused, no two runs would be alike.  {}", what, HintFor(what)));
  return ReportFindings(place) && refused.empty();
}

bool Bench::ReportFindings(const Place& place) {
  bool good = true;
  for (; findings_seen_ < findings().size(); ++findings_seen_) {
    const Finding& finding = findings()[findings_seen_];
    bool is_expected = findings_allowed_ || finding.severity != Severity::kError ||
                       thrown_findings_.contains(findings_seen_);
    for (ExpectedFinding& expected : expected_findings_) {
      if (!expected.text.Matches(finding.text)) continue;
      expected.seen = true;
      is_expected = true;
    }
    if (is_expected) continue;
    good = ReportFailure(
        place, fmt::format("The runtime found an error{}: {}{}",
                           finding.object.empty() ? "" : " of " + finding.object, finding.text,
                           openr_host::MessageInParentheses(finding.message, finding.said)));
  }
  return good;
}

void Bench::HandleMessage(const Message& message) {
  const SeenMessage seen(*system_, message);
  history_.Add(seen);
  expectations_.Check(
      seen, [this](const Place& place, const std::string& text) { ReportFailure(place, text); });
  if (goal_ && goal_->Matches(seen)) goal_reached_ = true;
  if (seen.number() == goal_number_) goal_reached_ = true;
  for (const auto& see : see_) see(seen);
}

bool Bench::Boot(Place place) {
  if (system_->booted()) throw std::logic_error("Boot: the bench is booted already");
  const bool good = RunControlled(place, [&] {
    system_->Boot();
    system_->RunUntil([&] { return system_->booted(); }, kBootUsMax);
  });
  if (!system_->booted()) return ReportFailure(place, "Boot: the robot did not boot");
  for (const UncheckedNames& each : std::exchange(unchecked_, {}))
    CheckNames(each.spec, each.place, each.on_wrong);
  return good;
}

bool Bench::Step(Place place) {
  if (!IsRunning(place)) return false;
  bool stepped = false;
  return RunControlled(place, [&] { stepped = system_->Step(); }) && stepped;
}

bool Bench::StepTo(const std::string& end, Duration budget, Place place) {
  return StepTo(AnyMessage().To(end), budget, place);
}

bool Bench::StepTo(const MessageSpec& spec, Duration budget, Place place) {
  if (!IsRunning(place)) return false;
  CheckNames(spec, place);
  goal_ = spec;
  goal_reached_ = false;
  const bool good = RunControlled(
      place, [&] { system_->RunUntil([this] { return goal_reached_; }, budget.count()); });
  goal_.reset();
  if (goal_reached_) return good;
  return ReportFailure(place, fmt::format("StepTo: no {} within {}", spec.Text(), Seconds(budget)));
}

bool Bench::StepToMessage(uint64_t number, Place place) {
  goal_number_ = number;
  goal_reached_ = false;
  const bool good = RunControlled(
      place, [&] { system_->RunUntil([this] { return goal_reached_; }, kStepToMessageUsMax); });
  goal_number_ = 0;
  return goal_reached_
             ? good
             : ReportFailure(place, fmt::format("StepToMessage: #{} does not come", number));
}

bool Bench::RunFor(Duration duration, Place place) {
  if (duration < Duration::zero())
    return ReportFailure(place, "RunFor: " + Seconds(duration) + "; time does not run backwards");
  if (!IsRunning(place)) return false;
  return RunControlled(place, [&] { system_->RunFor(duration.count()); });
}

bool Bench::RunUntil(const std::function<bool()>& predicate, Duration budget, Place place) {
  if (!IsRunning(place)) return false;
  bool holds = false;
  const bool good =
      RunControlled(place, [&] { holds = system_->RunUntil(predicate, budget.count()); });
  if (holds) return good;
  return ReportFailure(place,
                       fmt::format("RunUntil: it does not hold within {}{}", Seconds(budget),
                                   system_->powered_off() && system_->end()
                                       ? "; the robot is off, " + DescribeEnd(*system_->end())
                                       : ""));
}

bool Bench::RunUntilMet(Duration budget, Place place) {
  const bool good = RunControlled(
      place, [&] { system_->RunUntil([this] { return expectations_.met(); }, budget.count()); });
  if (expectations_.met()) return good;
  expectations_.Verify([&](const Place& expected, const std::string& text) {
    ReportFailure(expected, text + "\nwithin " + Seconds(budget));
  });
  return false;
}

bool Bench::Frame(int count, Place place) {
  if (!IsRunning(place)) return false;
  const int64_t frame_us = system_->frame_us();
  const int64_t end_us = (system_->now_us() / frame_us + count) * frame_us;
  return RunControlled(place, [&] { system_->RunUntil(end_us); });
}

bool Bench::SensorVector(int count, Place place) {
  constexpr int kFrames = SensorSource::kFramesPerVector;
  const int64_t wanted = (dog().frame() / kFrames + count) * kFrames;
  const bool good = RunControlled(place, [&] {
    system_->RunUntil([&] { return dog_->frame() >= wanted; }, count * kFrames * kFrameUsMax);
    system_->RunUntil(system_->now_us());  // delivers everything else that is due now
  });
  if (dog_->frame() >= wanted) return good;
  return ReportFailure(place, "SensorVector: the body stands still; is the robot booted?");
}

bool Bench::PhysicsStep(Place place) {
  const int64_t wanted = dog().frame() + 1;
  const bool good = RunControlled(
      place, [&] { system_->RunUntil([&] { return dog_->frame() >= wanted; }, kFrameUsMax); });
  if (dog_->frame() >= wanted) return good;
  return ReportFailure(place, "PhysicsStep: the body stands still; is the robot booted?");
}

void Bench::Verify() {
  const ReportAt report = [this](const Place& place, const std::string& text) {
    ReportFailure(place, text);
  };
  expectations_.Verify(report);
  gate_.Verify(report);
  schedule_.Verify(report);
  ReportFindings(place_);
  for (const ExpectedFinding& expected : std::exchange(expected_findings_, {})) {
    bool seen = expected.seen;
    for (const Finding& finding : findings()) seen = seen || expected.text.Matches(finding.text);
    if (seen) continue;
    std::ostringstream text;
    expected.text.DescribeTo(&text);
    ReportFailure(expected.place,
                  "No finding has a text that " + text.str() + ".  Findings:\n" + Findings());
  }
  for (TcpClient* client : clients_) {
    if (client->done()) continue;
    ReportFailure(client->place(),
                  fmt::format("{} still waits {}", client->host().name, client->WaitsFor()));
    client->DropScript();
  }
}

}  // namespace openr::testing

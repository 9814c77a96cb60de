// The functions of Bench that post, hold, drop, repeat, refuse and delay messages, that expect
// messages, and that act as a person on the dog.
#include <fmt/format.h>

#include <cstring>
#include <stdexcept>
#include <utility>

#include "runtime/base/spelling.h"
#include "runtime/core/post_as_object.h"
#include "testing/bench.h"

namespace openr::testing {

using openr_host::CurrentScope;
using openr_host::Message;
using openr_host::NamesService;
using openr_host::Object;
using openr_host::OwnedMessage;
using openr_host::ServiceEnd;
using openr_host::ServiceSide;

void Bench::CheckNames(const MessageSpec& spec, const Place& place,
                       const std::function<void()>& on_wrong) {
  if (!system_->booted()) {
    unchecked_.push_back({spec, place, on_wrong});
    return;
  }
  const bool from = CheckName(spec.from(), place), to = CheckName(spec.to(), place);
  if ((!from || !to) && on_wrong) on_wrong();
}

bool Bench::CheckName(const std::string& name, const Place& place) {
  if (name.empty()) return true;
  std::vector<std::string> known;
  if (name.find('.') == std::string::npos) {
    for (const auto& object : system_->objects()) known.push_back(object->name);
  } else {
    for (const auto& [service, entry] : system_->robot(0).directory) {
      if (NamesService(name, service)) return true;
      known.push_back(ShortName({"", service}));
    }
  }
  if (std::find(known.begin(), known.end(), name) != known.end()) return true;
  Fail(place, fmt::format("There is no {} '{}' on this bench{}",
                          name.find('.') == std::string::npos ? "object" : "service", name,
                          openr_host::DidYouMean(name, known)));
  return false;
}

// ---- Messages that the test itself sends

std::optional<ServiceEnd> Bench::FindEnd(const std::string& name, ServiceSide side,
                                         const Caller& caller) {
  const std::optional<ServiceEnd> end = openr_host::FindService(*system_, 0, name, side);
  if (!end) {
    Fail(caller.place, fmt::format("{}: '{}' is no {} of an object", caller.function, name,
                                   side == ServiceSide::kSubject ? "subject" : "observer"));
  }
  return end;
}

bool Bench::InjectBytes(const MessageSpec& spec, std::string_view bytes, Place place) {
  return PostBytes(spec, bytes, {"Inject", place});
}

bool Bench::PostBytes(const MessageSpec& spec, std::string_view bytes, const Caller& caller) {
  using enum MessageKind;
  const MessageKind kind = spec.kind().value_or(kOther);
  if (kind == kNotify) return PostNotify(spec, bytes, caller);
  if (kind == kReady || kind == kNotReady) return PostReadiness(spec, caller);
  return PostEntry(spec, bytes, caller);
}

bool Bench::MissPost(const Caller& caller, const std::string& problem) {
  return ReportFailure(caller.place, fmt::format("{}: {}", caller.function, problem));
}

bool Bench::PostNotify(const MessageSpec& spec, std::string_view bytes, const Caller& caller) {
  const auto from = FindEnd(spec.from(), ServiceSide::kSubject, caller);
  const auto to = FindEnd(spec.to(), ServiceSide::kObserver, caller);
  if (!from || !to) return false;
  const std::string problem = PostNotification(system_.get(), *from, *to, bytes);
  return problem.empty() || MissPost(caller, problem);
}

bool Bench::PostReadiness(const MessageSpec& spec, const Caller& caller) {
  const auto from = FindEnd(spec.from(), ServiceSide::kObserver, caller);
  const auto to = FindEnd(spec.to(), ServiceSide::kSubject, caller);
  if (!from || !to) return false;
  const bool is_ready = spec.kind() == MessageKind::kReady;
  const std::string problem = PostReady(system_.get(), *from, *to, is_ready);
  return problem.empty() || MissPost(caller, problem);
}

bool Bench::PostEntry(const MessageSpec& spec, std::string_view bytes, const Caller& caller) {
  constexpr uint32_t kSelectors = 64;  // largest number of entries that an object can have
  const Object& target = object(spec.to());
  uint32_t selector = 0;
  while (selector < kSelectors && target.EntryName(selector) != spec.entry()) ++selector;
  if (selector == kSelectors || bytes.size() > Message::kPayloadMax) {
    Fail(caller.place,
         selector == kSelectors
             ? fmt::format("{}: {} has no entry '{}'", caller.function, target.name, spec.entry())
             : fmt::format("{}: a message holds {} bytes at most, these are {}", caller.function,
                           Message::kPayloadMax, bytes.size()));
    return false;
  }
  const CurrentScope scope(system_.get(), spec.from().empty() ? nullptr : &object(spec.from()));
  OwnedMessage message = system_->NewMessage(target.id, selector);
  std::memset(message->payload, 0, sizeof message->payload);
  std::memcpy(message->payload, bytes.data(), bytes.size());
  message->size = static_cast<uint32_t>(bytes.size());
  return system_->Post(std::move(message)) == sSUCCESS ||
         MissPost(caller, "the queue of the receiver is full");
}

// ---- Actions of a person on the dog

bool Bench::Do(std::string_view input, Place place) {
  const std::string problem = system_->inputs().Add(0, input);
  return problem.empty() || ReportFailure(place, "Input refused: " + problem);
}

bool Bench::Press(std::string_view sensor, Duration duration, Place place) {
  if (duration <= 0s) return Do(fmt::format("press {}", sensor), place);
  return Do(fmt::format("press {} for {}us", sensor, duration.count()), place);
}

bool Bench::Release(std::string_view sensor, Place place) {
  return Do(fmt::format("release {}", sensor), place);
}

bool Bench::SetSensor(std::string_view sensor, int32_t value, Place place) {
  return Do(fmt::format("set {} {}", sensor, value), place);
}

bool Bench::Push(const Force& force, Duration duration, Place place) {
  return Do(fmt::format("push {} {} {} for {}us", force.x, force.y, force.z, duration.count()),
            place);
}

bool Bench::Lift(double metres, Place place) { return Do(fmt::format("lift {}", metres), place); }

bool Bench::SetBattery(int percent, Place place) {
  return Do(fmt::format("battery {}%", percent), place);
}

bool Bench::SetCharger(bool on, Place place) {
  return Do(on ? "charger on" : "charger off", place);
}

// ---- Order and delivery of messages

void Bench::Reorder(std::vector<std::string> objects, Place place) {
  for (const std::string& name : objects) CheckNames(AnyMessage().To(name), place);
  schedule_.Prefer(std::move(objects));
}

HeldMessages& Bench::Hold(const MessageSpec& spec, Place place) {
  HeldMessages& held = gate_.Hold(spec, place);
  // If a name in `spec` is wrong, CheckNames() reports a failure.  Optional() then prevents a
  // second failure, which would say that no message was held.
  CheckNames(spec, place, [&held] { held.Optional(); });
  return held;
}

DroppedMessages& Bench::Drop(const MessageSpec& spec, int count, Place place) {
  DroppedMessages& dropped = gate_.Drop(spec, count, place);
  CheckNames(spec, place, [&dropped] { dropped.Optional(); });
  return dropped;
}

RepeatedMessage& Bench::Repeat(const MessageSpec& spec, uint64_t nth, Place place) {
  if (nth < 1) throw std::invalid_argument("Repeat: messages are counted from 1");
  RepeatedMessage& repeated = gate_.Repeat(spec, nth, place);
  CheckNames(spec, place, [&repeated] { repeated.Optional(); });
  return repeated;
}

void Bench::PostAgain(const SeenMessage& message, const Place& place) {
  const std::string from = ShortName(message.from()), to = ShortName(message.to());
  const Caller caller = {"Repeat", place};
  switch (message.kind()) {
    case MessageKind::kNotify:
      for (int i = 0; i < message.data_count(); ++i)
        PostBytes(Notify(from, to), message.data(i), caller);
      return;
    case MessageKind::kReady:
      PostBytes(Ready(from, to), {}, caller);
      return;
    case MessageKind::kNotReady:
      PostBytes(NotReady(from, to), {}, caller);
      return;
    case MessageKind::kReply:
      MissPost(caller, "a reply cannot come twice: " + message.Text());
      return;
    case MessageKind::kOther:
      PostBytes(ToEntry(to, message.entry()).From(from),
                message.data_count() == 0 ? std::string_view() : message.data(0), caller);
      return;
  }
}

RefusedMessage& Bench::Refuse(const MessageSpec& spec, uint64_t nth, Place place) {
  RefusedMessage& refused = schedule_.Refuse(spec, nth, place);
  CheckNames(spec, place, [&refused] { refused.Optional(); });
  return refused;
}

void Bench::Delay(const MessageSpec& spec, Duration extra, Place place) {
  CheckNames(spec, place);
  schedule_.Delay(spec, extra.count());
}

// ---- Expected messages

void Bench::Expect(const MessageSpec& spec, Place place) {
  CheckNames(spec, place);
  expectations_.Expect(spec, place);
}

void Bench::Allow(const MessageSpec& spec, Place place) {
  CheckNames(spec, place);
  expectations_.Allow(spec);
}

void Bench::Disallow(const MessageSpec& spec, Place place) {
  CheckNames(spec, place);
  expectations_.Disallow(spec, place);
}

void Bench::ExpectFinding(::testing::Matcher<const std::string&> text, Place place) {
  expected_findings_.push_back({std::move(text), place});
}

}  // namespace openr::testing

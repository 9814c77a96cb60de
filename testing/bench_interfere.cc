// Bench: changes to messages, and expectations about them.
#include <fmt/format.h>

#include <cstring>
#include <stdexcept>
#include <utility>

#include "runtime/base/spelling.h"
#include "runtime/core/post_in_name.h"
#include "testing/bench.h"

namespace openr::testing {

using openr_host::CurrentScope;
using openr_host::Message;
using openr_host::NamesService;
using openr_host::Object;
using openr_host::OwnedMessage;
using openr_host::ServiceEnd;
using openr_host::ServiceSide;

bool Bench::CheckNames(const MessageSpec& spec, const Place& place) {
  if (!system_->booted()) {
    unchecked_.emplace_back(spec, place);
    return true;
  }
  const bool from = CheckName(spec.from(), place);
  return CheckName(spec.to(), place) && from;
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
                                         const Place& place) {
  const std::optional<ServiceEnd> end = openr_host::FindService(*system_, 0, name, side);
  if (!end) {
    Fail(place, fmt::format("Inject: '{}' is no {} of a connection", name,
                            side == ServiceSide::kSubject ? "subject" : "observer"));
  }
  return end;
}

bool Bench::InjectBytes(const MessageSpec& spec, std::string_view bytes, Place place) {
  using enum MessageKind;
  const MessageKind kind = spec.kind().value_or(kOther);
  if (kind == kNotify) return InjectNotify(spec, bytes, place);
  if (kind == kReady || kind == kNotReady) return InjectReady(spec, place);
  return InjectEntry(spec, bytes, place);
}

bool Bench::InjectNotify(const MessageSpec& spec, std::string_view bytes, const Place& place) {
  const auto from = FindEnd(spec.from(), ServiceSide::kSubject, place);
  const auto to = FindEnd(spec.to(), ServiceSide::kObserver, place);
  if (!from || !to) return false;
  const std::string problem = PostNotification(system_.get(), *from, *to, bytes);
  return problem.empty() || Miss(place, "Inject: " + problem);
}

bool Bench::InjectReady(const MessageSpec& spec, const Place& place) {
  const auto from = FindEnd(spec.from(), ServiceSide::kObserver, place);
  const auto to = FindEnd(spec.to(), ServiceSide::kSubject, place);
  if (!from || !to) return false;
  const bool is_ready = spec.kind() == MessageKind::kReady;
  const std::string problem = PostReady(system_.get(), *from, *to, is_ready);
  return problem.empty() || Miss(place, "Inject: " + problem);
}

bool Bench::InjectEntry(const MessageSpec& spec, std::string_view bytes, const Place& place) {
  constexpr uint32_t kSelectors = 64;  // largest number of entries that an object can have
  const Object& target = object(spec.to());
  uint32_t selector = 0;
  while (selector < kSelectors && target.EntryName(selector) != spec.entry()) ++selector;
  if (selector == kSelectors || bytes.size() > Message::kPayloadMax) {
    Fail(place, selector == kSelectors
                    ? fmt::format("Inject: {} has no entry '{}'", target.name, spec.entry())
                    : fmt::format("Inject: a message holds {} bytes at most, these are {}",
                                  Message::kPayloadMax, bytes.size()));
    return false;
  }
  const CurrentScope scope(system_.get(), spec.from().empty() ? nullptr : &object(spec.from()));
  OwnedMessage message = system_->NewMessage(target.id, selector);
  std::memset(message->payload, 0, sizeof message->payload);
  std::memcpy(message->payload, bytes.data(), bytes.size());
  message->size = static_cast<uint32_t>(bytes.size());
  return system_->Post(std::move(message)) == sSUCCESS ||
         Miss(place, "Inject: the queue of the receiver is full");
}

// ---- Actions of a person on the dog

bool Bench::Do(std::string_view input, Place place) {
  const std::string problem = system_->inputs().Add(0, input);
  return problem.empty() || Miss(place, "Input refused: " + problem);
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
  const bool is_good = CheckNames(spec, place);
  HeldMessages& held = doors_.Hold(spec, place);
  return is_good ? held : held.Optional();  // CheckNames() has reported a wrong name already
}

DroppedMessages& Bench::Drop(const MessageSpec& spec, int count, Place place) {
  const bool is_good = CheckNames(spec, place);
  DroppedMessages& dropped = doors_.Drop(spec, count, place);
  return is_good ? dropped : dropped.Optional();
}

RepeatedMessage& Bench::Repeat(const MessageSpec& spec, uint64_t nth, Place place) {
  if (nth < 1) throw std::invalid_argument("Repeat: messages are counted from 1");
  const bool is_good = CheckNames(spec, place);
  RepeatedMessage& repeated = doors_.Repeat(spec, nth, place);
  return is_good ? repeated : repeated.Optional();
}

void Bench::PostAgain(const SeenMessage& message, const Place& place) {
  const std::string from = ShortName(message.from()), to = ShortName(message.to());
  switch (message.kind()) {
    case MessageKind::kNotify:
      for (int i = 0; i < message.data_count(); ++i)
        InjectBytes(Notify(from, to), message.data(i), place);
      return;
    case MessageKind::kReady:
      InjectBytes(Ready(from, to), {}, place);
      return;
    case MessageKind::kNotReady:
      InjectBytes(NotReady(from, to), {}, place);
      return;
    case MessageKind::kReply:
      Miss(place, "Repeat: an answer cannot come twice: " + message.Text());
      return;
    case MessageKind::kOther:
      InjectBytes(ToEntry(to, message.entry()).From(from),
                  message.data_count() == 0 ? std::string_view() : message.data(0), place);
      return;
  }
}

RefusedMessage& Bench::Refuse(const MessageSpec& spec, uint64_t nth, Place place) {
  const bool is_good = CheckNames(spec, place);
  RefusedMessage& refused = schedule_.Refuse(spec, nth, place);
  return is_good ? refused : refused.Optional();
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

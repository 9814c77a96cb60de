// Bench: changes to messages, and expectations about them.
#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <fmt/format.h>

#include <cstring>
#include <new>
#include <utility>

#include "runtime/base/spelling.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_state.h"
#include "testing/bench.h"

namespace openr::testing {

using openr_host::CurrentScope;
using openr_host::Message;
using openr_host::Object;
using openr_host::OidOf;
using openr_host::OwnedMessage;
using openr_host::PayloadKind;

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

// ---- Injecting

// Returns whether `subject` is connected with `observer`; reports a failure at `place` if not.  An
// end of a connection is stored as the number of its handler: Ready of a subject, Notify of an
// observer.  ServiceEnd::selector holds this number.
bool Bench::AreConnected(const ServiceEnd& subject, const ServiceEnd& observer,
                         const Place& place) {
  const OServiceEntry observer_id(OidOf(observer.object), observer.selector);
  for (const auto& each : system_->object(subject.object)->subjects) {
    if (each->id.selector != subject.selector) continue;
    if (each->Find(observer_id) != nullptr) return true;
    Fail(place, fmt::format("Inject: {} is not connected with {}", each->service,
                            system_->object(observer.object)->EntryName(observer.selector)));
    return false;
  }
  return true;
}

std::optional<Bench::ServiceEnd> Bench::FindService(const std::string& name, const char* kind,
                                                    const Place& place) {
  for (const auto& object : system_->objects()) {
    for (const auto& [selector, entry] : object->entry_names) {
      const size_t end = entry.rfind(" (");
      if (end == std::string::npos || entry.substr(end) != kind) continue;
      if (NamesService(name, std::string_view(entry).substr(0, end)))
        return ServiceEnd{object->id, selector};
    }
  }
  Fail(place, fmt::format("Inject: '{}' is no {} of a connection", name,
                          std::string_view(kind) == " (Ready)" ? "subject" : "observer"));
  return std::nullopt;
}

bool Bench::InjectBytes(const MessageSpec& spec, std::string_view bytes, Place place) {
  using enum MessageKind;
  const MessageKind kind = spec.kind().value_or(kOther);
  if (kind == kNotify) return InjectNotify(spec, bytes, place);
  if (kind == kReady || kind == kNotReady) return InjectReady(spec, place);
  return InjectEntry(spec, bytes, place);
}

bool Bench::InjectNotify(const MessageSpec& spec, std::string_view bytes, const Place& place) {
  const auto from = FindService(spec.from(), " (Ready)", place);
  const auto to = FindService(spec.to(), " (Notify)", place);
  if (!from || !to || !AreConnected(*from, *to, place)) return false;
  const CurrentScope scope(system_.get(), system_->object(from->object));
  RCRegion* const region = new RCRegion(bytes.size());
  std::memcpy(region->Base(), bytes.data(), bytes.size());
  OwnedMessage message = system_->NewMessage(to->object, to->selector);
  auto& notify = *new (message->payload) ONotifyMessage;
  notify.msgType = omsgNOTIFY_V22;
  notify.subjectID = OServiceEntry(OidOf(from->object), from->selector);
  notify.numOfData = 1;
  notify.numOfNotify = 1;
  notify.data[0].srcRCR = region;
  notify.data[0].memID = region->MemID();
  notify.data[0].offset = region->Offset();
  notify.data[0].size = region->Size();
  message->size = sizeof notify;
  message->kind = PayloadKind::kNotify;
  if (system_->Post(std::move(message)) == sSUCCESS) return true;
  region->RemoveReference();
  return Miss(place, "Inject: the queue of the receiver is full");
}

bool Bench::InjectReady(const MessageSpec& spec, const Place& place) {
  const auto from = FindService(spec.from(), " (Notify)", place);
  const auto to = FindService(spec.to(), " (Ready)", place);
  if (!from || !to || !AreConnected(*to, *from, place)) return false;
  const CurrentScope scope(system_.get(), system_->object(from->object));
  OwnedMessage message = system_->NewMessage(to->object, to->selector);
  auto& ready = *new (message->payload) OReadyMessage;
  ready.msgType = omsgREADY_V22;
  ready.command =
      spec.kind() == MessageKind::kReady ? objcommCMD_ASSERT_READY : objcommCMD_DEASSERT_READY;
  ready.observerID = OServiceEntry(OidOf(from->object), from->selector);
  ready.numOfData = 0;
  message->size = sizeof ready;
  message->kind = PayloadKind::kReady;
  return system_->Post(std::move(message)) == sSUCCESS ||
         Miss(place, "Inject: the queue of the receiver is full");
}

bool Bench::InjectEntry(const MessageSpec& spec, std::string_view bytes, const Place& place) {
  constexpr uint32_t kSelectors = 64;  // most entries that an object can have
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

// ---- Changing the order of messages, holding and dropping messages

void Bench::Reorder(std::vector<std::string> objects, Place place) {
  for (const std::string& name : objects) CheckNames(AnyMessage().To(name), place);
  schedule_.Prefer(std::move(objects));
}

HeldMessages& Bench::Hold(const MessageSpec& spec, Place place) {
  const bool is_good = CheckNames(spec, place);
  HeldMessages& held = doors_.Hold(spec, place);
  return is_good ? held : held.Optional();  // a wrong name has failed the test already
}

DroppedMessages& Bench::Drop(const MessageSpec& spec, int count, Place place) {
  const bool is_good = CheckNames(spec, place);
  DroppedMessages& dropped = doors_.Drop(spec, count, place);
  return is_good ? dropped : dropped.Optional();
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

// ---- Expecting

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

#include "testing/seen_message.h"

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <fmt/format.h>

#include "openr/decode/decode_message.h"
#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr::testing {
namespace {

using openr_host::Message;
using openr_host::Object;
using openr_host::ObjectId;
using openr_host::PayloadKind;
using openr_host::System;

const ONotifyMessage& AsNotify(const Message& message) {
  return *reinterpret_cast<const ONotifyMessage*>(message.payload);
}

const OReadyMessage& AsReady(const Message& message) {
  return *reinterpret_cast<const OReadyMessage*>(message.payload);
}

MessageKind KindOf(const Message& message) {
  if (message.is_reply) return MessageKind::kReply;
  if (message.kind == PayloadKind::kNotify) return MessageKind::kNotify;
  if (message.kind != PayloadKind::kReady) return MessageKind::kOther;
  return AsReady(message).command == objcommCMD_ASSERT_READY ? MessageKind::kReady
                                                             : MessageKind::kNotReady;
}

uint32_t SizeOf(const Message& message) {
  if (message.kind != PayloadKind::kNotify) return message.size;
  size_t size = 0;
  for (int i = 0; i < AsNotify(message).numOfData; ++i) size += AsNotify(message).data[i].size;
  return static_cast<uint32_t>(size);
}

// Returns the name of the service with the handler number `selector`; "" if that handler is not the
// Ready or Notify handler of a service.
std::string_view ServiceOf(const Object& object, uint32_t selector) {
  const std::string* const found = object.entry_names().FindName(selector);
  if (found == nullptr) return "";
  const std::string_view name = *found;
  const size_t end = name.rfind(" (");
  if (end == std::string_view::npos) return "";
  const std::string_view kind = name.substr(end);
  return kind == " (Ready)" || kind == " (Notify)" ? name.substr(0, end) : "";
}

SeenMessage::End EndOf(const System& system, ObjectId id, uint32_t selector, bool has_service) {
  const Object* const object = system.object(id);
  if (object == nullptr) return {};
  return {object->name, has_service ? ServiceOf(*object, selector) : std::string_view()};
}

}  // namespace

SeenMessage::SeenMessage(const System& system, const Message& message)
    : system_(&system),
      message_(&message),
      kind_(KindOf(message)),
      number_(message.number),
      cause_(message.cause),
      time_us_(system.now_us()),
      sender_(message.sender),
      target_(message.target),
      selector_(message.selector),
      size_(SizeOf(message)) {
  const auto comes_from = [this](const OServiceEntry& entry) {
    sender_ = openr_host::ObjectIdOf(entry.GetOID());
    sender_entry_ = entry.GetSelector();
  };
  if (kind_ == MessageKind::kNotify) comes_from(AsNotify(message).subjectID);
  if (kind_ == MessageKind::kReady || kind_ == MessageKind::kNotReady)
    comes_from(AsReady(message).observerID);
}

SeenMessage SeenMessage::Past() const {
  SeenMessage past = *this;
  past.content_ = Content();
  past.message_ = nullptr;
  return past;
}

// Returns the first bytes of the message's data, as many as Text() may need.
std::string SeenMessage::Content() const {
  if (message_ == nullptr) return content_;
  std::string copy;
  return std::string(
      openr_host::ContentView(*message_, &copy).substr(0, openr_host::kDecodedBytesMax));
}

SeenMessage::End SeenMessage::from() const {
  return EndOf(*system_, sender_, sender_entry_, sender_entry_ != 0);
}

SeenMessage::End SeenMessage::to() const {
  return EndOf(*system_, target_, selector_, kind_ != MessageKind::kReply);
}

const char* WordFor(MessageKind kind) {
  switch (kind) {
    case MessageKind::kNotify:
      return "notify";
    case MessageKind::kReady:
      return "ready";
    case MessageKind::kNotReady:
      return "not ready";
    case MessageKind::kReply:
      return "reply";
    case MessageKind::kOther:
      break;
  }
  return nullptr;
}

std::string SeenMessage::entry() const {
  if (const char* const word = WordFor(kind_)) return word;
  const Object* const object = system_->object(target_);
  return object == nullptr ? fmt::format("selector {}", selector_) : object->EntryName(selector_);
}

int SeenMessage::data_count() const {
  if (message_ == nullptr) return 0;
  if (message_->kind == PayloadKind::kNotify) return AsNotify(*message_).numOfData;
  return message_->kind == PayloadKind::kBytes ? 1 : 0;
}

std::string_view SeenMessage::data(int i) const {
  ASSERT(0 <= i && i < data_count(), "i={} of {}", i, data_count());
  if (message_->kind != PayloadKind::kNotify)
    return {reinterpret_cast<const char*>(message_->payload), message_->size};
  const auto& datum = AsNotify(*message_).data[i];
  return {datum.srcRCR->Base(), datum.size};
}

std::string SeenMessage::Text() const {
  std::string text =
      fmt::format("t={:.6f} {} -> {} {}, {} bytes", static_cast<double>(time_us_) * 1e-6,
                  ShortName(from()), ShortName(to()), entry(), size_);
  if (number_ != 0) text = fmt::format("#{} {}", number_, text);
  if (cause_ != 0) text += fmt::format(", caused by #{}", cause_);
  // The text about a ready ends here: it already says "ready" or "not ready".
  if (kind_ == MessageKind::kReady || kind_ == MessageKind::kNotReady) return text;
  const std::string content = openr_host::OneLineOf(openr_host::DecodeReceived(
      *system_, target_, kind_ == MessageKind::kReply ? UNDEF : selector_, Content()));
  if (!content.empty()) text += ": " + content;
  return text;
}

std::string ShortName(const SeenMessage::End& end) {
  if (end.service.empty()) return end.object.empty() ? "(outside)" : std::string(end.object);
  const size_t second = end.service.find('.', end.service.find('.') + 1);
  return std::string(end.service.substr(0, second));
}

}  // namespace openr::testing

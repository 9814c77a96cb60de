#include "distribution/courier.h"

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <antEnvMsg.h>
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <vector>

#include "runtime/core/api.h"
#include "runtime/core/hasher.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/objcomm/state.h"

namespace openr_host {
namespace {

bool IsStack(const System& system, ObjectId id) {
  const Object* const object = system.object(id);
  return object != nullptr && object->name == IpStack::kName;
}

openr_wire_PayloadKind KindOf(const System& system, const Message& message) {
  switch (message.kind) {
    case PayloadKind::kNotify:
      return openr_wire_PAYLOAD_NOTIFY;
    case PayloadKind::kReady:
      return openr_wire_PAYLOAD_READY;
    case PayloadKind::kHashed:
      return IsStack(system, message.sender) || IsStack(system, message.target)
                 ? openr_wire_PAYLOAD_ANT
                 : openr_wire_PAYLOAD_BYTES;
    case PayloadKind::kBytes:
      break;
  }
  return openr_wire_PAYLOAD_BYTES;
}

}  // namespace

void Courier::DropStandIn(RCRegion* region) {
  system_->regions().DropCopy(region->MemID());
  borrowed_.erase(region);
  region->RemoveReference();
}

void Courier::Encode(const Message& message, const HasMemory& other_has, WireArena* arena,
                     openr_wire_Message* out) {
  out->number = message.number;
  out->cause = message.cause;
  out->sender = message.sender;
  out->target = message.target;
  out->selector = message.selector;
  out->reply_box = message.reply_box;
  out->is_reply = message.is_reply;
  out->is_hashed = message.kind == PayloadKind::kHashed;
  out->payload_hash = message.payload_hash;
  out->payload._d = KindOf(*system_, message);
  switch (out->payload._d) {
    case openr_wire_PAYLOAD_BYTES:
      out->payload._u.bytes = arena->Bytes(message.payload, message.size);
      break;
    case openr_wire_PAYLOAD_NOTIFY:
      EncodeNotify(message, other_has, arena, &out->payload._u.notify);
      break;
    case openr_wire_PAYLOAD_READY:
      EncodeReady(message, arena, &out->payload._u.ready);
      break;
    case openr_wire_PAYLOAD_ANT:
      EncodeAnt(message, arena, &out->payload._u.ant);
      break;
  }
}

void Courier::EncodeNotify(const Message& message, const HasMemory& other_has, WireArena* arena,
                           openr_wire_Notify* out) {
  const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
  out->subject = ObjectIdOf(notify.subjectID.GetOID());
  out->selector = notify.subjectID.GetSelector();
  out->notifications = static_cast<uint32_t>(notify.numOfNotify);
  std::vector<openr_wire_NotifiedRegion> parts;
  for (int i = 0; i < notify.numOfData; ++i) {
    const auto& data = notify.data[i];
    openr_wire_NotifiedRegion part{};
    part.token = ++last_token_;
    lent_[part.token] = {data.srcRCR,   data.size,      out->subject,
                         out->selector, message.target, message.selector};
    part.region = data.memID;
    part.offset = data.offset;
    part.size = static_cast<uint32_t>(data.size);
    part.region_bytes = static_cast<uint32_t>(
        std::max(system_->regions().SizeOf(data.memID), data.offset + data.size));
    if (!other_has || !other_has(data.memID))
      part.bytes = WireArena::View(data.srcRCR->Base(), data.size);
    parts.push_back(part);
  }
  out->parts = arena->Sequence<decltype(out->parts)>(parts);
}

// An observer may write into what it received.  Most give it back in the handler that got it.
bool Courier::IsChanged(const RCRegion& region, const Borrowed& borrowed) {
  if (borrowed.bytes != nullptr)
    return std::memcmp(region.Base(), borrowed.bytes, region.Size()) != 0;
  return HashBytes(region.Base(), region.Size()) != borrowed.hash;
}

void Courier::ForgetSample() {
  for (RCRegion* const region : of_sample_) {
    const auto found = borrowed_.find(region);
    if (found == borrowed_.end() || found->second.bytes == nullptr) continue;  // given back
    Borrowed& borrowed = found->second;
    borrowed.hash = HashBytes(std::exchange(borrowed.bytes, nullptr), region->Size());
  }
  of_sample_.clear();
}

void Courier::EncodeReady(const Message& message, WireArena* arena, openr_wire_Ready* out) {
  const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
  out->command = static_cast<uint32_t>(ready.command);
  out->is_lost = ready.msgType == kDeassertOfLost;
  out->observer = ObjectIdOf(ready.observerID.GetOID());
  out->selector = ready.observerID.GetSelector();
  std::vector<openr_wire_ReturnedRegion> regions;
  for (int i = 0; i < ready.numOfData; ++i) {
    const auto found = borrowed_.find(ready.rcRegion[i]);
    // Of a subject that was replaced meanwhile.
    if (found == borrowed_.end() || found->second.token == 0) continue;
    const RCRegion& region = *found->first;
    openr_wire_ReturnedRegion returned{found->second.token, {}};
    if (IsChanged(region, found->second))
      returned.bytes = WireArena::View(region.Base(), region.Size());
    regions.push_back(returned);
  }
  out->regions = arena->Sequence<decltype(out->regions)>(regions);
}

std::vector<Courier::Lent> Courier::TakeLent() {
  std::vector<Lent> all;
  for (const auto& [token, lent] : lent_) all.push_back(lent);
  lent_.clear();
  return all;
}

std::vector<RCRegion*> Courier::TakeLentOf(ObjectId subject) {
  std::vector<RCRegion*> regions;
  std::erase_if(lent_, [&](const auto& entry) {
    if (entry.second.subject != subject) return false;
    regions.push_back(entry.second.region);
    taken_back_[entry.first] = entry.second.region->MemID();
    return true;
  });
  return regions;
}

std::vector<uint64_t> Courier::TakeDropped() {
  std::vector<uint64_t> tokens;
  std::erase_if(dropped_, [&](const auto& entry) {
    if (system_->regions().BaseOf(entry.second) != nullptr) return false;  // it may be handed on
    tokens.push_back(entry.first);
    return true;
  });
  return tokens;
}

void Courier::Dropped(const std::vector<uint64_t>& tokens) {
  for (const uint64_t token : tokens) taken_back_.erase(token);
}

void Courier::LoseOther() {
  taken_back_.clear();
  for (auto& [region, borrowed] : borrowed_) borrowed.token = 0;
}

void Courier::TakeBack(RCRegion* region) {
  const auto found = borrowed_.find(region);
  if (found == borrowed_.end()) return;
  if (makes_copies_ && found->second.token != 0) dropped_[found->second.token] = region->MemID();
  DropStandIn(region);
}

bool Courier::HasBorrowed(uint32_t region) const {
  return std::any_of(borrowed_.begin(), borrowed_.end(),
                     [region](const auto& entry) { return entry.first->MemID() == region; });
}

bool Courier::HasLent(uint32_t region) const {
  const auto is_lent = [region](const auto& entry) {
    return entry.second.region->MemID() == region;
  };
  const auto is_kept = [region](const auto& entry) { return entry.second == region; };
  return std::any_of(lent_.begin(), lent_.end(), is_lent) ||
         std::any_of(taken_back_.begin(), taken_back_.end(), is_kept);
}

void Courier::Sent(const Message& message) {
  if (message.kind != PayloadKind::kReady) return;
  const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
  for (int i = 0; i < ready.numOfData; ++i) {
    if (borrowed_.contains(ready.rcRegion[i])) DropStandIn(ready.rcRegion[i]);
  }
}

void Courier::EncodeAnt(const Message& message, WireArena* arena, openr_wire_Ant* out) {
  alignas(antEnvMsg) unsigned char bytes[Message::kPayloadMax];
  std::memcpy(bytes, message.payload, sizeof bytes);
  auto* const ant = reinterpret_cast<antEnvMsg*>(bytes);
  if (message.size >= AntMessageSize(*ant)) {
    const AntBuffer buffer = BufferOf(ant);
    size_t offset = 0;
    if (buffer.pointer != nullptr &&
        system_->regions().Locate(*buffer.pointer, &out->region, &offset)) {
      out->offset = static_cast<uint32_t>(offset);
      const int wanted = IsStack(*system_, message.target) ? buffer.sent : buffer.received;
      const size_t room = system_->regions().SizeOf(out->region) - offset;
      out->data = WireArena::View(*buffer.pointer,
                                  std::min(static_cast<size_t>(std::max(wanted, 0)), room));
    }
    if (buffer.pointer != nullptr) *buffer.pointer = nullptr;
  }
  out->message = arena->Bytes(bytes, message.size);
}

std::string Courier::Decode(const openr_wire_Message& in, Message* out) {
  out->number = in.number;
  out->cause = in.cause;
  out->sender = in.sender;
  out->target = in.target;
  out->selector = in.selector;
  out->reply_box = in.reply_box;
  out->is_reply = in.is_reply;
  out->payload_hash = in.payload_hash;
  out->kind = in.is_hashed ? PayloadKind::kHashed : PayloadKind::kBytes;
  std::memset(out->payload, 0, sizeof out->payload);
  switch (in.payload._d) {
    case openr_wire_PAYLOAD_NOTIFY:
      return DecodeNotify(in.payload._u.notify, out);
    case openr_wire_PAYLOAD_READY:
      return DecodeReady(in.payload._u.ready, out);
    case openr_wire_PAYLOAD_ANT:
      return DecodeAnt(in.payload._u.ant, out);
    case openr_wire_PAYLOAD_BYTES:
      break;
  }
  const openr_wire_Bytes& bytes = in.payload._u.bytes;
  if (bytes._length > Message::kPayloadMax) return fmt::format("{} bytes", bytes._length);
  if (bytes._length > 0) std::memcpy(out->payload, bytes._buffer, bytes._length);
  out->size = bytes._length;
  return "";
}

std::string Courier::DecodeNotify(const openr_wire_Notify& in, Message* out) {
  if (in.parts._length > MAX_NUM_DATA || in.notifications > MAX_NUM_DATA)
    return fmt::format("a notification of {} data", in.parts._length);
  auto& notify = *new (out->payload) ONotifyMessage;
  notify.msgType = omsgNOTIFY_V22;
  notify.subjectID = OServiceEntry(OidOf(in.subject), in.selector);
  notify.numOfData = 0;
  notify.numOfNotify = static_cast<short>(in.notifications);
  out->size = sizeof notify;
  out->kind = PayloadKind::kNotify;
  for (uint32_t i = 0; i < in.parts._length; ++i) {
    const openr_wire_NotifiedRegion& part = in.parts._buffer[i];
    RCRegion* region = nullptr;
    std::string problem = DecodePart(part, &region);
    if (!problem.empty()) return problem;
    auto& data = notify.data[notify.numOfData++];
    data.srcRCR = region;
    data.memID = part.region;
    data.offset = part.offset;
    data.size = part.size;
  }
  return "";
}

// Where the bytes of `in` belong; null when they have no place.
char* Courier::MemoryFor(const openr_wire_NotifiedRegion& in) {
  RegionTable& regions = system_->regions();
  const uint64_t end = uint64_t{in.offset} + in.size;
  if (regions.BaseOf(in.region) == nullptr) {
    if (!makes_copies_ || in.region_bytes < end || in.region_bytes > kRobotMemoryBytes)
      return nullptr;
    if (regions.AdoptCopy(in.region, in.region_bytes) == nullptr) return nullptr;
  }
  return end > regions.SizeOf(in.region) ? nullptr : regions.BaseOf(in.region) + in.offset;
}

std::string Courier::DecodePart(const openr_wire_NotifiedRegion& in, RCRegion** region) {
  char* const memory = MemoryFor(in);
  if (memory == nullptr) return fmt::format("{} bytes in region {:#x}", in.size, in.region);
  if (in.bytes._length != 0 && in.bytes._length != in.size) return "a part of another size";
  if (in.bytes._length != 0) std::memcpy(memory, in.bytes._buffer, in.size);
  *region = new RCRegion(in.region, in.offset, memory, in.size);
  system_->regions().KeepCopy(in.region);
  if (in.bytes._length != 0) {
    borrowed_[*region] = {in.token, in.bytes._buffer, 0};
    of_sample_.push_back(*region);
  } else {
    borrowed_[*region] = {in.token, nullptr, HashBytes(memory, in.size)};
  }
  return "";
}

std::string Courier::DecodeReady(const openr_wire_Ready& in, Message* out) {
  if (in.regions._length > MAX_NUM_DATA)
    return fmt::format("a ready with {} regions", in.regions._length);
  auto& ready = *new (out->payload) OReadyMessage;
  ready.msgType = in.is_lost ? kDeassertOfLost : omsgREADY_V22;
  ready.command = static_cast<ObjcommCommand>(in.command);
  ready.observerID = OServiceEntry(OidOf(in.observer), in.selector);
  ready.numOfData = 0;
  out->size = sizeof ready;
  out->kind = PayloadKind::kReady;
  for (uint32_t i = 0; i < in.regions._length; ++i) {
    const openr_wire_ReturnedRegion& returned = in.regions._buffer[i];
    const auto found = lent_.find(returned.token);
    if (taken_back_.erase(returned.token) > 0) continue;
    if (found == lent_.end()) return "a ready with an unknown region";
    const Lent lent = found->second;
    if (returned.bytes._length != 0 && returned.bytes._length != lent.size)
      return "a region of another size";
    if (returned.bytes._length != 0)
      std::memcpy(lent.region->Base(), returned.bytes._buffer, lent.size);
    ready.rcRegion[ready.numOfData++] = lent.region;
    lent_.erase(found);
  }
  return "";
}

std::string Courier::DecodeAnt(const openr_wire_Ant& in, Message* out) {
  if (in.message._length < sizeof(antEnvMsg) || in.message._length > Message::kPayloadMax)
    return fmt::format("a network message of {} bytes", in.message._length);
  std::memcpy(out->payload, in.message._buffer, in.message._length);
  out->size = in.message._length;
  auto* const ant = reinterpret_cast<antEnvMsg*>(out->payload);
  if (out->size < AntMessageSize(*ant)) return "";  // the stack complains
  const AntBuffer buffer = BufferOf(ant);
  if (buffer.pointer == nullptr) return "";
  *buffer.pointer = nullptr;
  char* const base = in.region == 0 ? nullptr : system_->regions().BaseOf(in.region);
  const size_t size = system_->regions().SizeOf(in.region);
  if (base == nullptr || in.offset >= size) return "";
  if (in.data._length > size - in.offset) return "network data beyond their buffer";
  *buffer.pointer = reinterpret_cast<byte*>(base + in.offset);
  if (in.data._length > 0) std::memcpy(base + in.offset, in.data._buffer, in.data._length);
  return "";
}

}  // namespace openr_host

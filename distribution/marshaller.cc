#include "distribution/marshaller.h"

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <antEnvMsg.h>
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_messages.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/ip_stack.h"

namespace openr_host {
namespace {

// Returns whether object `id` is the network stack.
bool IsStack(const System& system, ObjectId id) {
  const Object* const object = system.object(id);
  return object != nullptr && object->name == IpStack::kName;
}

// Returns the form in which the payload of `message` is sent: plain bytes, or, for a payload with
// pointers, a form with other data in place of the pointers.
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

void Marshaller::DropImported(RCRegion* region) {
  system_->regions().DropCopy(region->MemID());
  const size_t erased = imported_.erase(region);
  ASSERT(erased == 1, "region {:#x} is not imported", region->MemID());
  region->RemoveReference();
}

void Marshaller::Encode(const Message& message, const PeerHasMemory& peer_has, WireArena* arena,
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
      EncodeNotify(message, peer_has, arena, &out->payload._u.notify);
      break;
    case openr_wire_PAYLOAD_READY:
      EncodeReady(message, arena, &out->payload._u.ready);
      break;
    case openr_wire_PAYLOAD_ANT:
      EncodeAnt(message, arena, &out->payload._u.ant);
      break;
  }
}

void Marshaller::EncodeNotify(const Message& message, const PeerHasMemory& peer_has,
                              WireArena* arena, openr_wire_Notify* out) {
  const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
  out->subject = ObjectIdOf(notify.subjectID.GetOID());
  out->selector = notify.subjectID.GetSelector();
  out->notifications = static_cast<uint32_t>(notify.numOfNotify);
  ASSERT(notify.numOfData >= 0 && notify.numOfData <= static_cast<int>(MAX_NUM_DATA), "{} data",
         notify.numOfData);
  std::vector<openr_wire_NotifiedRegion> parts;
  for (int i = 0; i < notify.numOfData; ++i) {
    const auto& data = notify.data[i];
    openr_wire_NotifiedRegion part{};
    part.token = ++last_token_;
    const ExportedRegion exported = {data.srcRCR,   data.size,      out->subject,
                                     out->selector, message.target, message.selector};
    const bool is_new = exported_.emplace(part.token, exported).second;
    ASSERT(is_new, "token {}", part.token);
    part.region = data.memID;
    part.offset = data.offset;
    part.size = static_cast<uint32_t>(data.size);
    // Sends the size of the whole region, because the receiver may have to make a copy of it.  For
    // a deleted region SizeOf() returns 0.  In this case we send the offset at which the data end,
    // because the receiver refuses data that end beyond the size of their region.
    part.region_bytes = static_cast<uint32_t>(
        std::max(system_->regions().SizeOf(data.memID), data.offset + data.size));
    if (!peer_has || !peer_has(data.memID))
      part.bytes = WireArena::View(data.srcRCR->Base(), data.size);
    parts.push_back(part);
  }
  out->parts = arena->Sequence<decltype(out->parts)>(parts);
}

// Returns whether the region's bytes differ from the bytes that were received.  Most observers give
// a region back in the handler that received the region.  The sample with the received bytes still
// exists during this handler, and a comparison with the sample is faster than a hash.  After the
// handler, the sample is released, and we compare hashes.
bool Marshaller::IsChanged(const RCRegion& region, const ImportedRegion& imported) {
  if (imported.bytes != nullptr)
    return std::memcmp(region.Base(), imported.bytes, region.Size()) != 0;
  return HashBytes(region.Base(), region.Size()) != imported.hash;
}

void Marshaller::ReleaseSample() {
  for (RCRegion* const region : sample_regions_) {
    const auto found = imported_.find(region);
    // Skips a received region that an observer has given back during the handler.  Such a region is
    // not imported any more, so its hash is not needed.
    if (found == imported_.end() || found->second.bytes == nullptr) continue;
    ImportedRegion& imported = found->second;
    imported.hash = HashBytes(std::exchange(imported.bytes, nullptr), region->Size());
  }
  sample_regions_.clear();
}

void Marshaller::EncodeReady(const Message& message, WireArena* arena, openr_wire_Ready* out) {
  const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
  out->command = static_cast<uint32_t>(ready.command);
  out->is_lost = ready.msgType == kDeassertOfLost;
  out->observer = ObjectIdOf(ready.observerID.GetOID());
  out->selector = ready.observerID.GetSelector();
  std::vector<openr_wire_ReturnedRegion> regions;
  for (int i = 0; i < ready.numOfData; ++i) {
    const auto found = imported_.find(ready.rcRegion[i]);
    // Skips a region that no process expects back, because the object that sent it was replaced or
    // its process was lost.  Such a region is not in imported_, or its token (the number by which
    // the sender knows it) is 0.
    if (found == imported_.end() || found->second.token == 0) continue;
    const RCRegion& region = *found->first;
    openr_wire_ReturnedRegion returned{found->second.token, {}};
    if (IsChanged(region, found->second))
      returned.bytes = WireArena::View(region.Base(), region.Size());
    regions.push_back(returned);
  }
  out->regions = arena->Sequence<decltype(out->regions)>(regions);
}

std::vector<Marshaller::ExportedRegion> Marshaller::TakeExported() {
  std::vector<ExportedRegion> all;
  for (const auto& [token, exported] : exported_) all.push_back(exported);
  exported_.clear();
  return all;
}

std::vector<RCRegion*> Marshaller::TakeExportedBy(ObjectId subject) {
  std::vector<RCRegion*> regions;
  std::erase_if(exported_, [&](const auto& entry) {
    if (entry.second.subject != subject) return false;
    regions.push_back(entry.second.region);
    withdrawn_[entry.first] = entry.second.region->MemID();
    return true;
  });
  return regions;
}

std::vector<uint64_t> Marshaller::TakeDroppedTokens() {
  std::vector<uint64_t> tokens;
  std::erase_if(dropped_, [&](const auto& entry) {
    // Keeps the token, the number by which the peer knows the region, while the memory of the
    // region still exists in this process.  An object may still pass the region on, and the peer
    // refuses a region whose token it has forgotten.
    if (system_->regions().BaseOf(entry.second) != nullptr) return false;
    tokens.push_back(entry.first);
    return true;
  });
  return tokens;
}

void Marshaller::PeerDropped(const std::vector<uint64_t>& tokens) {
  for (const uint64_t token : tokens) withdrawn_.erase(token);
}

void Marshaller::PeerIsLost() {
  withdrawn_.clear();
  for (auto& [region, imported] : imported_) imported.token = 0;
}

void Marshaller::ReleaseImported(RCRegion* region) {
  const auto found = imported_.find(region);
  if (found == imported_.end()) return;
  if (makes_copies_ && found->second.token != 0) dropped_[found->second.token] = region->MemID();
  DropImported(region);
}

bool Marshaller::HasImported(uint32_t region) const {
  return std::any_of(imported_.begin(), imported_.end(),
                     [region](const auto& entry) { return entry.first->MemID() == region; });
}

bool Marshaller::HasExported(uint32_t region) const {
  const auto is_exported = [region](const auto& entry) {
    return entry.second.region->MemID() == region;
  };
  const auto is_withdrawn = [region](const auto& entry) { return entry.second == region; };
  return std::any_of(exported_.begin(), exported_.end(), is_exported) ||
         std::any_of(withdrawn_.begin(), withdrawn_.end(), is_withdrawn);
}

void Marshaller::CompleteSend(const Message& message) {
  if (message.kind != PayloadKind::kReady) return;
  const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
  for (int i = 0; i < ready.numOfData; ++i) {
    if (imported_.contains(ready.rcRegion[i])) DropImported(ready.rcRegion[i]);
  }
}

void Marshaller::EncodeAnt(const Message& message, WireArena* arena, openr_wire_Ant* out) {
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

void Marshaller::UndoDecode() {
  for (RCRegion* const region : decoded_regions_) DropImported(region);
  for (auto& exported : returned_) exported_.insert(std::move(exported));
  for (auto& withdrawn : returned_withdrawn_) withdrawn_.insert(std::move(withdrawn));
  decoded_regions_.clear();
  returned_.clear();
  returned_withdrawn_.clear();
}

std::string Marshaller::Decode(const openr_wire_Message& in, Message* out) {
  decoded_regions_.clear();
  returned_.clear();
  returned_withdrawn_.clear();
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

std::string Marshaller::DecodeNotify(const openr_wire_Notify& in, Message* out) {
  // Checks the number of regions and of notifications, because the array of a notification message
  // has room for MAX_NUM_DATA regions, and a forged sample may have more.
  if (in.parts._length > MAX_NUM_DATA || in.notifications > MAX_NUM_DATA)
    return fmt::format("a notification of {} data", in.parts._length);
  auto& notify = *new (out->payload) ONotifyMessage;
  notify.subjectID = OServiceEntry(OidOf(in.subject), in.selector);
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

// Returns the memory to which the bytes of `in` are to be copied.  Returns null if the region is
// unknown and cannot be added, or if the bytes do not fit into the region.  The end of the bytes is
// computed in 64 bits, because in a forged message offset plus size may overflow 32 bits.
char* Marshaller::MemoryFor(const openr_wire_NotifiedRegion& in) {
  RegionTable& regions = system_->regions();
  const uint64_t end = uint64_t{in.offset} + in.size;
  if (regions.BaseOf(in.region) == nullptr) {
    if (!makes_copies_ || in.region_bytes < end || in.region_bytes > kRobotMemoryBytes)
      return nullptr;
    if (regions.AdoptCopy(in.region, in.region_bytes) == nullptr) return nullptr;
  }
  return end > regions.SizeOf(in.region) ? nullptr : regions.BaseOf(in.region) + in.offset;
}

std::string Marshaller::DecodePart(const openr_wire_NotifiedRegion& in, RCRegion** region) {
  char* const memory = MemoryFor(in);
  if (memory == nullptr) return fmt::format("{} bytes in region {:#x}", in.size, in.region);
  if (in.bytes._length != 0 && in.bytes._length != in.size) return "a part of another size";
  if (in.bytes._length != 0) std::memcpy(memory, in.bytes._buffer, in.size);
  *region = new RCRegion(in.region, in.offset, memory, in.size);
  // Keeps the memory of the received region until the observer gives the region back, even if the
  // object that owns the region deletes it meanwhile.
  system_->regions().KeepCopy(in.region);
  decoded_regions_.push_back(*region);
  if (in.bytes._length != 0) {
    imported_[*region] = {in.token, in.bytes._buffer, 0};
    sample_regions_.push_back(*region);
  } else {
    imported_[*region] = {in.token, nullptr, HashBytes(memory, in.size)};
  }
  return "";
}

std::string Marshaller::DecodeReady(const openr_wire_Ready& in, Message* out) {
  if (in.regions._length > MAX_NUM_DATA)
    return fmt::format("a ready with {} regions", in.regions._length);
  auto& ready = *new (out->payload) OReadyMessage;
  ready.msgType = in.is_lost ? kDeassertOfLost : omsgREADY_V22;
  ready.command = static_cast<ObjcommCommand>(in.command);
  ready.observerID = OServiceEntry(OidOf(in.observer), in.selector);
  out->size = sizeof ready;
  out->kind = PayloadKind::kReady;
  for (uint32_t i = 0; i < in.regions._length; ++i) {
    const openr_wire_ReturnedRegion& returned = in.regions._buffer[i];
    // Only removes the token if the region was released already, because the object that sent the
    // region was replaced (TakeExportedBy()).  The tokens of such regions are in withdrawn_.
    if (auto withdrawn = withdrawn_.extract(returned.token)) {
      returned_withdrawn_.push_back(std::move(withdrawn));
      continue;
    }
    const auto found = exported_.find(returned.token);
    if (found == exported_.end()) return "a ready with an unknown region";
    const ExportedRegion& exported = found->second;
    if (returned.bytes._length != 0 && returned.bytes._length != exported.size)
      return "a region of another size";
    if (returned.bytes._length != 0)
      std::memcpy(exported.region->Base(), returned.bytes._buffer, exported.size);
    ready.rcRegion[ready.numOfData++] = exported.region;
    returned_.push_back(exported_.extract(found));
  }
  return "";
}

std::string Marshaller::DecodeAnt(const openr_wire_Ant& in, Message* out) {
  if (in.message._length < sizeof(antEnvMsg) || in.message._length > Message::kPayloadMax)
    return fmt::format("a network message of {} bytes", in.message._length);
  std::memcpy(out->payload, in.message._buffer, in.message._length);
  out->size = in.message._length;
  auto* const ant = reinterpret_cast<antEnvMsg*>(out->payload);
  // Accepts a message that is too short, because the network stack, which receives it, reports the
  // error.
  if (out->size < AntMessageSize(*ant)) return "";
  const AntBuffer buffer = BufferOf(ant);
  if (buffer.pointer == nullptr) return "";
  // Replaces the received pointer, which is an address in the sender's process, by the address of
  // the same data in this process.  The pointer becomes null if the region is unknown.
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

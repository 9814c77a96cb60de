#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "cli/counted.h"
#include "openr/inspect/trace_file.h"
#include "runtime/base/assert.h"

namespace openr_host {
namespace {

// Largest payload that is read from a file.  No region of this size fits into the robot's memory,
// so a larger size means that the file is damaged.
constexpr uint64_t kPayloadMax = 64 << 20;
// The largest number of bytes of all kept payloads.  The writer and the reader keep the last
// payload of each sender and size, because the next payload of this sender and size is stored as
// its differences from the last.  If a message would exceed the limit, the writer first forgets all
// kept payloads and writes kForget, at which the reader forgets them, too.  Without the limit, a
// damaged file of some hundred bytes could make the reader use all memory, because a large payload
// without differences from the last needs only some bytes in the file.
constexpr uint64_t kKeptMax = 512 << 20;

void WriteEvent(const NetworkEvent& event, ByteWriter* out) {
  out->U8(static_cast<uint8_t>(event.kind));
  out->Varint(event.handle);
  out->U8(static_cast<uint8_t>(event.error));
  out->U32(event.remote.ip);
  out->Varint(event.remote.port);
  out->Varint(event.count);
  out->Text(event.bytes);
  out->Text(event.host.name);
  out->Varint(event.host.aliases.size());
  for (const std::string& alias : event.host.aliases) out->Text(alias);
  out->Varint(event.host.addresses.size());
  for (const uint32_t address : event.host.addresses) out->U32(address);
}

template <typename E>
E ReadEnum(ByteReader* in, E last) {
  const uint8_t value = in->U8();
  if (value > static_cast<uint8_t>(last))
    throw std::runtime_error(fmt::format("{} is no kind of anything", value));
  return static_cast<E>(value);
}

NetworkEvent ReadEvent(ByteReader* in) {
  NetworkEvent event;
  event.kind = ReadEnum(in, NetworkEvent::Kind::kNote);
  event.handle = static_cast<NetHandle>(in->Varint());
  event.error = ReadEnum(in, NetError::kTooLong);
  event.remote.ip = in->U32();
  event.remote.port = static_cast<uint16_t>(in->Varint());
  event.count = in->Varint();
  event.bytes = in->Text();
  event.host.name = in->Text();
  for (uint64_t i = in->Varint(); i > 0; --i) event.host.aliases.emplace_back(in->Text());
  for (uint64_t i = in->Varint(); i > 0; --i) event.host.addresses.push_back(in->U32());
  return event;
}

// Reads an entry that a program of before version kTraceVersion wrote for an input, and makes it
// the entry kInput that a present program writes.
void ReadOldInput(ByteReader* in, TraceEntry* entry) {
  const TraceEntry::Kind kind = std::exchange(entry->kind, TraceEntry::Kind::kInput);
  entry->time_us = in->Zigzag();
  if (kind == TraceEntry::Kind::kOldConsole) {
    entry->robot = static_cast<int32_t>(in->Varint());
    entry->name = fmt::format("type {}", in->Text());
  } else {
    entry->robot = -1;
    entry->name = kind == TraceEntry::Kind::kOldPause ? "press pause" : "shutdown";
  }
}

// Reads the members of an entry that is neither a message nor an old input.
void ReadPlainEntry(ByteReader* in, TraceEntry* entry) {
  switch (entry->kind) {
    case TraceEntry::Kind::kObject:
      entry->id = static_cast<int32_t>(in->Zigzag());
      entry->robot = static_cast<int32_t>(in->Varint());
      entry->name = in->Text();
      return;
    case TraceEntry::Kind::kEntry:
      entry->id = static_cast<int32_t>(in->Zigzag());
      entry->selector = static_cast<uint32_t>(in->Varint());
      entry->name = in->Text();
      return;
    case TraceEntry::Kind::kNetwork:
      entry->robot = static_cast<int32_t>(in->Varint());
      for (uint64_t i = in->Varint(); i > 0; --i) entry->events.push_back(ReadEvent(in));
      return;
    case TraceEntry::Kind::kInput:
      entry->time_us = in->Zigzag();
      entry->robot = static_cast<int32_t>(in->Zigzag());
      entry->name = in->Text();
      return;
    case TraceEntry::Kind::kLoss:
      entry->time_us = in->Zigzag();
      entry->name = in->Text();
      return;
    case TraceEntry::Kind::kEnded:
      entry->name = in->Text();
      entry->payload = in->Text();
      return;
    case TraceEntry::Kind::kStick:
      entry->what = ReadEnum(in, TraceEntry::PathKind::kFolder);
      entry->name = in->Text();
      entry->payload = in->Text();
      return;
    case TraceEntry::Kind::kEnd:
      entry->time_us = in->Zigzag();
      entry->trace_hash = in->U64();
      entry->state_hash = in->U64();
      return;
    case TraceEntry::Kind::kForget:
    case TraceEntry::Kind::kMessage:
    case TraceEntry::Kind::kOldMessage:
    case TraceEntry::Kind::kOldPause:
    case TraceEntry::Kind::kOldShutdown:
    case TraceEntry::Kind::kOldConsole:
      break;  // cannot happen: Read() has read entries of these kinds itself
  }
  // Refuses the number 0, which is no kind, but with which a damaged file can begin an entry.
  throw std::runtime_error("0 is no kind of anything");
}

}  // namespace

bool TraceCoder::HasRoomFor(int32_t sender, size_t size) const {
  return kept_ + size <= kKeptMax || last_.contains({sender, size});
}

LastPayload& TraceCoder::LastOf(int32_t sender, size_t size) {
  const auto [found, is_new] = last_.try_emplace({sender, size}, size);
  if (is_new) kept_ += size;
  return found->second;
}

void TraceCoder::Forget() {
  last_.clear();
  kept_ = 0;
  for (Link& link : links_) link.last = nullptr;
}

uint32_t TraceCoder::LinkOf(const TraceRecord& record) {
  const auto [found, is_new] = link_numbers_.try_emplace(
      {record.sender, record.target, record.selector}, static_cast<uint32_t>(links_.size()));
  if (is_new) links_.push_back({record.sender, record.target, record.selector});
  return found->second;
}

void TraceCoder::WriteMessage(const TraceRecord& record, std::string_view payload,
                              uint32_t number_of_link, ByteWriter* out) {
  // The largest size of what precedes the payload of a message in the file: the kind, nine numbers
  // of variable length, and the hash, which has eight bytes.
  constexpr size_t kHeadMax = 1 + 9 * ByteWriter::kVarintBytesMax + 8;
  ASSERT(number_of_link <= defined_links_ && number_of_link < links_.size());
  Link& link = links_[number_of_link];
  const bool has_payload = payloads_ && !payload.empty();
  if (has_payload && (link.last == nullptr || link.last->size() != payload.size())) {
    if (!HasRoomFor(record.sender, payload.size())) {
      out->U8(static_cast<uint8_t>(TraceEntry::Kind::kForget));
      Forget();
    }
    link.last = &LastOf(record.sender, payload.size());
  }
  char* at = out->Room(kHeadMax);
  *at++ = static_cast<char>(TraceEntry::Kind::kMessage);
  at = ByteWriter::PutVarint(number_of_link, at);
  if (number_of_link == defined_links_) {
    at = ByteWriter::PutZigzag(link.sender, at);
    at = ByteWriter::PutZigzag(link.target, at);
    at = ByteWriter::PutVarint(link.selector, at);
    ++defined_links_;
  }
  at = ByteWriter::PutZigzag(static_cast<int64_t>(record.number - number_), at);
  at = ByteWriter::PutZigzag(static_cast<int64_t>(record.number - record.cause), at);
  at = ByteWriter::PutZigzag(record.time_us - time_us_, at);
  at = ByteWriter::PutVarint(record.size, at);
  at = ByteWriter::PutFixed(record.payload_hash, 8, at);
  if (payloads_) at = ByteWriter::PutVarint(payload.size(), at);
  out->SetEnd(at);
  number_ = record.number;
  time_us_ = record.time_us;
  if (has_payload) link.last->Write(payload, out);
}

void TraceCoder::ReadLink(ByteReader* in, TraceRecord* record) {
  const uint64_t number = in->Varint();
  if (number > links_.size()) throw std::runtime_error("a message of an unknown link");
  if (number == links_.size()) {
    Link link;
    link.sender = static_cast<int32_t>(in->Zigzag());
    link.target = static_cast<int32_t>(in->Zigzag());
    link.selector = static_cast<uint32_t>(in->Varint());
    links_.push_back(link);
  }
  record->sender = links_[number].sender;
  record->target = links_[number].target;
  record->selector = links_[number].selector;
}

void TraceCoder::ReadPayload(bool in_pieces, ByteReader* in, TraceEntry* entry) {
  const uint64_t size = in->Varint();
  if (size > kPayloadMax) throw std::runtime_error("a message of " + Counted(size, "byte"));
  const int32_t sender = entry->record.sender;
  if (!HasRoomFor(sender, size))
    throw std::runtime_error(fmt::format(
        "the contents of the messages need more than {} of memory; if the file is not damaged, an "
        "older openr has recorded the run: replay it with that one, or record the run again, which "
        "this openr can read to its end",
        Counted(kKeptMax, "byte")));
  LastPayload& last = LastOf(sender, size);
  in_pieces ? last.ReadPieces(in) : last.Read(in);
  entry->payload = last.bytes();
}

void TraceCoder::ReadMessage(bool is_old, ByteReader* in, TraceEntry* entry) {
  TraceRecord& record = entry->record;
  if (!is_old) ReadLink(in, &record);
  record.number = number_ + static_cast<uint64_t>(in->Zigzag());
  record.cause = record.number - static_cast<uint64_t>(in->Zigzag());
  // Adds the times as unsigned numbers, because a damaged file may have any numbers, and a sum of
  // signed numbers could overflow.
  record.time_us =
      static_cast<int64_t>(static_cast<uint64_t>(time_us_) + static_cast<uint64_t>(in->Zigzag()));
  if (is_old) {
    record.sender = static_cast<int32_t>(in->Zigzag());
    record.target = static_cast<int32_t>(in->Zigzag());
    record.selector = static_cast<uint32_t>(in->Varint());
  }
  record.size = static_cast<uint32_t>(in->Varint());
  record.payload_hash = in->U64();
  if (payloads_) ReadPayload(is_old, in, entry);
  number_ = record.number;
  time_us_ = record.time_us;
}

void TraceCoder::Write(const TraceEntry& entry, ByteWriter* out) {
  if (entry.kind == TraceEntry::Kind::kMessage)
    return WriteMessage(entry.record, entry.payload, LinkOf(entry.record), out);
  out->U8(static_cast<uint8_t>(entry.kind));
  switch (entry.kind) {
    case TraceEntry::Kind::kObject:
      out->Zigzag(entry.id);
      out->Varint(static_cast<uint64_t>(entry.robot));
      out->Text(entry.name);
      return;
    case TraceEntry::Kind::kEntry:
      out->Zigzag(entry.id);
      out->Varint(entry.selector);
      out->Text(entry.name);
      return;
    case TraceEntry::Kind::kMessage:
      return;  // nothing is left to do: WriteMessage() has written the message already
    case TraceEntry::Kind::kForget:
      ASSERT(false, "only WriteMessage() writes a kForget");
      return;
    case TraceEntry::Kind::kNetwork:
      out->Varint(static_cast<uint64_t>(entry.robot));
      out->Varint(entry.events.size());
      for (const NetworkEvent& event : entry.events) WriteEvent(event, out);
      return;
    case TraceEntry::Kind::kOldMessage:
    case TraceEntry::Kind::kOldPause:
    case TraceEntry::Kind::kOldShutdown:
    case TraceEntry::Kind::kOldConsole:
      ASSERT(false, "only programs of before version {} wrote entry {}", kTraceVersion,
             static_cast<int>(entry.kind));
      return;
    case TraceEntry::Kind::kInput:
      out->Zigzag(entry.time_us);
      out->Zigzag(entry.robot);
      out->Text(entry.name);
      return;
    case TraceEntry::Kind::kLoss:
      out->Zigzag(entry.time_us);
      out->Text(entry.name);
      return;
    case TraceEntry::Kind::kEnded:
      out->Text(entry.name);
      out->Text(entry.payload);
      return;
    case TraceEntry::Kind::kStick:
      out->U8(static_cast<uint8_t>(entry.what));
      out->Text(entry.name);
      out->Text(entry.payload);
      return;
    case TraceEntry::Kind::kEnd:
      out->Zigzag(entry.time_us);
      out->U64(entry.trace_hash);
      out->U64(entry.state_hash);
      return;
  }
}

TraceEntry TraceCoder::Read(ByteReader* in) {
  TraceEntry entry;
  while ((entry.kind = ReadEnum(in, TraceEntry::Kind::kForget)) == TraceEntry::Kind::kForget)
    Forget();
  switch (entry.kind) {
    case TraceEntry::Kind::kMessage:
      ReadMessage(false, in, &entry);
      break;
    case TraceEntry::Kind::kOldMessage:
      entry.kind = TraceEntry::Kind::kMessage;
      ReadMessage(true, in, &entry);
      break;
    case TraceEntry::Kind::kOldPause:
    case TraceEntry::Kind::kOldShutdown:
    case TraceEntry::Kind::kOldConsole:
      ReadOldInput(in, &entry);
      break;
    default:
      ReadPlainEntry(in, &entry);
  }
  return entry;
}

}  // namespace openr_host

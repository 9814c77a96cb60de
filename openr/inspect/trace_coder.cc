#include <fmt/format.h>

#include <cstring>

#include "cli/counted.h"
#include "openr/inspect/trace_file.h"
#include "runtime/base/assert.h"

namespace openr_host {
namespace {

// Largest payload that is read from a file.  No region of this size fits into the robot's memory,
// so a larger size means that the file is damaged.
constexpr uint64_t kPayloadMax = 64 << 20;
// The most bytes of last payloads that a reader keeps.  Without a limit, a damaged file of some
// hundred bytes could make it use all memory, because bytes that are equal take no room in a file.
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

// Returns the end of the bytes from `at` on that are equal in `a` and `b`, which have the same
// size.  Most bytes are equal, so large pieces are compared first: memcmp() uses the widest
// registers of the processor.
size_t EndOfEqualBytes(const std::string& a, const std::string& b, size_t at) {
  for (const size_t piece : {size_t{512}, size_t{64}, size_t{8}, size_t{1}}) {
    while (at + piece <= a.size() && std::memcmp(&a[at], &b[at], piece) == 0) at += piece;
  }
  return at;
}

// Returns the end of the bytes from `at` on that differ.  The end is behind 4 equal bytes, because
// leaving out a shorter gap would save less than a new piece costs.
size_t EndOfOtherBytes(const std::string& a, const std::string& b, size_t at) {
  for (size_t run = 0; at < a.size() && run < 4; ++at) run = a[at] == b[at] ? run + 1 : 0;
  return at;
}

}  // namespace

void TraceCoder::WritePayload(const TraceEntry& entry, ByteWriter* out) {
  const std::string& now = entry.payload;
  out->Varint(now.size());
  std::string& last = last_[{entry.record.sender, now.size()}];
  last.resize(now.size());
  for (size_t at = 0; at < now.size();) {
    const size_t equal = EndOfEqualBytes(now, last, at);
    const size_t other = EndOfOtherBytes(now, last, equal);
    out->Varint(equal - at);
    out->Text(std::string_view(now).substr(equal, other - equal));
    std::memcpy(&last[equal], &now[equal], other - equal);
    at = other;
  }
}

void TraceCoder::ReadPayload(ByteReader* in, TraceEntry* entry) {
  const uint64_t size = in->Varint();
  if (size > kPayloadMax) throw std::runtime_error("a message of " + Counted(size, "byte"));
  std::string& last = last_[{entry->record.sender, size}];
  kept_ += size - last.size();
  if (kept_ > kKeptMax)
    throw std::runtime_error("messages of more than " + Counted(kKeptMax, "byte"));
  last.resize(size);
  for (size_t at = 0; at < size;) {
    const uint64_t equal = in->Varint();
    const std::string_view other = in->Text();
    if (equal > size - at || other.size() > size - at - equal || equal + other.size() == 0)
      throw std::runtime_error("pieces of a message are longer than it");
    last.replace(at + equal, other.size(), other);
    at += equal + other.size();
  }
  entry->payload = last;
}

void TraceCoder::WriteMessage(const TraceEntry& entry, ByteWriter* out) {
  const TraceRecord& record = entry.record;
  out->Zigzag(static_cast<int64_t>(record.number - number_));
  out->Zigzag(static_cast<int64_t>(record.number - record.cause));
  out->Zigzag(record.time_us - time_us_);
  out->Zigzag(record.sender);
  out->Zigzag(record.target);
  out->Varint(record.selector);
  out->Varint(record.size);
  out->U64(record.payload_hash);
  if (payloads_) WritePayload(entry, out);
  number_ = record.number;
  time_us_ = record.time_us;
}

void TraceCoder::ReadMessage(ByteReader* in, TraceEntry* entry) {
  TraceRecord& record = entry->record;
  record.number = number_ + static_cast<uint64_t>(in->Zigzag());
  record.cause = record.number - static_cast<uint64_t>(in->Zigzag());
  // Adds without a sign, because a damaged file may have any numbers.
  record.time_us =
      static_cast<int64_t>(static_cast<uint64_t>(time_us_) + static_cast<uint64_t>(in->Zigzag()));
  record.sender = static_cast<int32_t>(in->Zigzag());
  record.target = static_cast<int32_t>(in->Zigzag());
  record.selector = static_cast<uint32_t>(in->Varint());
  record.size = static_cast<uint32_t>(in->Varint());
  record.payload_hash = in->U64();
  if (payloads_) ReadPayload(in, entry);
  number_ = record.number;
  time_us_ = record.time_us;
}

void TraceCoder::Write(const TraceEntry& entry, ByteWriter* out) {
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
      WriteMessage(entry, out);
      return;
    case TraceEntry::Kind::kNetwork:
      out->Varint(static_cast<uint64_t>(entry.robot));
      out->Varint(entry.events.size());
      for (const NetworkEvent& event : entry.events) WriteEvent(event, out);
      return;
    case TraceEntry::Kind::kOldPause:
    case TraceEntry::Kind::kOldShutdown:
    case TraceEntry::Kind::kOldConsole:
      ASSERT(false, "only programs of before version 4 wrote entry {}",
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
  entry.kind = ReadEnum(in, TraceEntry::Kind::kInput);
  switch (entry.kind) {
    case TraceEntry::Kind::kObject:
      entry.id = static_cast<int32_t>(in->Zigzag());
      entry.robot = static_cast<int32_t>(in->Varint());
      entry.name = in->Text();
      return entry;
    case TraceEntry::Kind::kEntry:
      entry.id = static_cast<int32_t>(in->Zigzag());
      entry.selector = static_cast<uint32_t>(in->Varint());
      entry.name = in->Text();
      return entry;
    case TraceEntry::Kind::kMessage:
      ReadMessage(in, &entry);
      return entry;
    case TraceEntry::Kind::kNetwork:
      entry.robot = static_cast<int32_t>(in->Varint());
      for (uint64_t i = in->Varint(); i > 0; --i) entry.events.push_back(ReadEvent(in));
      return entry;
    case TraceEntry::Kind::kOldPause:
    case TraceEntry::Kind::kOldShutdown:
      entry.name = entry.kind == TraceEntry::Kind::kOldPause ? "press pause" : "shutdown";
      entry.kind = TraceEntry::Kind::kInput;
      entry.time_us = in->Zigzag();
      entry.robot = -1;
      return entry;
    case TraceEntry::Kind::kOldConsole:
      entry.kind = TraceEntry::Kind::kInput;
      entry.time_us = in->Zigzag();
      entry.robot = static_cast<int32_t>(in->Varint());
      entry.name = fmt::format("type {}", in->Text());
      return entry;
    case TraceEntry::Kind::kInput:
      entry.time_us = in->Zigzag();
      entry.robot = static_cast<int32_t>(in->Zigzag());
      entry.name = in->Text();
      return entry;
    case TraceEntry::Kind::kLoss:
      entry.time_us = in->Zigzag();
      entry.name = in->Text();
      return entry;
    case TraceEntry::Kind::kEnded:
      entry.name = in->Text();
      entry.payload = in->Text();
      return entry;
    case TraceEntry::Kind::kStick:
      entry.what = ReadEnum(in, TraceEntry::OnStick::kFolder);
      entry.name = in->Text();
      entry.payload = in->Text();
      return entry;
    case TraceEntry::Kind::kEnd:
      entry.time_us = in->Zigzag();
      entry.trace_hash = in->U64();
      entry.state_hash = in->U64();
      return entry;
  }
  throw std::runtime_error("0 is no kind of anything");
}

}  // namespace openr_host

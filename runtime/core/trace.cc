#include "runtime/core/trace.h"

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>

namespace openr_host {
namespace {

uint64_t HashNotify(const ONotifyMessage& notify, uint32_t* size) {
  uint64_t words[2 + MAX_NUM_DATA];
  words[0] = static_cast<uint64_t>(notify.numOfData);
  words[1] = static_cast<uint64_t>(notify.numOfNotify);
  *size = 0;
  for (int i = 0; i < notify.numOfData; ++i) {
    const RCRegion* const region = notify.data[i].srcRCR;
    words[2 + i] = HashBytes(region->Base(), notify.data[i].size);
    *size += static_cast<uint32_t>(notify.data[i].size);
  }
  return HashBytes(words, sizeof words[0] * static_cast<size_t>(2 + notify.numOfData));
}

uint64_t HashReady(const OReadyMessage& ready, uint32_t* size) {
  const int32_t words[2] = {ready.command, ready.numOfData};
  *size = sizeof words;
  return HashBytes(words, sizeof words);
}

}  // namespace

uint64_t PayloadHash(const Message& message, uint32_t* size) {
  switch (message.kind) {
    case PayloadKind::kNotify:
      return HashNotify(*reinterpret_cast<const ONotifyMessage*>(message.payload), size);
    case PayloadKind::kReady:
      return HashReady(*reinterpret_cast<const OReadyMessage*>(message.payload), size);
    case PayloadKind::kHashed:
      *size = message.size;
      return message.payload_hash;
    case PayloadKind::kBytes:
      break;
  }
  *size = message.size;
  return HashBytes(message.payload, message.size);
}

std::string_view PayloadView(const Message& message, std::string* copy) {
  switch (message.kind) {
    case PayloadKind::kNotify: {
      const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
      if (notify.numOfData == 1) return {notify.data[0].srcRCR->Base(), notify.data[0].size};
      copy->clear();
      for (int i = 0; i < notify.numOfData; ++i)
        copy->append(notify.data[i].srcRCR->Base(), notify.data[i].size);
      return *copy;
    }
    case PayloadKind::kReady: {
      const auto& ready = *reinterpret_cast<const OReadyMessage*>(message.payload);
      const int32_t words[2] = {ready.command, ready.numOfData};
      copy->assign(reinterpret_cast<const char*>(words), sizeof words);
      return *copy;
    }
    case PayloadKind::kHashed:
      return {};
    case PayloadKind::kBytes:
      break;
  }
  return {reinterpret_cast<const char*>(message.payload), message.size};
}

std::string PayloadBytes(const Message& message) {
  std::string copy;
  return std::string(PayloadView(message, &copy));
}

int Trace::AddSink(Sink sink) {
  sinks_.emplace_back(++last_sink_, std::move(sink));
  is_recording_ = true;
  return last_sink_;
}

void Trace::RemoveSink(int number) {
  std::erase_if(sinks_, [number](const auto& sink) { return sink.first == number; });
  is_recording_ = hashing_ || !sinks_.empty();
}

void Trace::set_hashing(bool on) {
  hashing_ = on;
  is_recording_ = hashing_ || !sinks_.empty();
}

void Trace::Record(const Message& message, int64_t now_us) {
  TraceRecord& record = buffer_[buffered_];
  record.number = message.number;
  record.cause = message.cause;
  record.time_us = now_us;
  record.sender = message.sender;
  record.target = message.target;
  record.selector = message.is_reply ? UNDEF : message.selector;
  record.payload_hash = PayloadHash(message, &record.size);
  if (!sinks_.empty()) [[unlikely]]
    CallSinks(record, message);
  if (++buffered_ == kBuffered) [[unlikely]]
    HashBuffer();
}

// Calls the sinks, the functions that are called for every delivered message.  Not inline, because
// the inlined calls would make Record() save more registers for every message, even if there are no
// sinks.
[[gnu::noinline]] void Trace::CallSinks(const TraceRecord& record, const Message& message) {
  for (const auto& [number, sink] : sinks_) sink(record, message);
}

// Adds the records of messages in buffer_ to the trace hash.  Records are collected in the buffer,
// because hashing many at a time is faster.
void Trace::HashBuffer() const {
  hasher_.AddBytes(buffer_, sizeof buffer_[0] * static_cast<size_t>(buffered_));
  buffered_ = 0;
}

uint64_t Trace::hash() const {
  HashBuffer();
  return hasher_.Digest();
}

}  // namespace openr_host

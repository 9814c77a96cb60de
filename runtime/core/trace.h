// Trace: computes one hash of all delivered messages in their order, and passes every message to
// listeners (sinks).
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/base/hasher.h"
#include "runtime/core/message.h"

namespace openr_host {

// The record of a delivered message.  The trace hash is made of these records.  A record holds a
// hash of the message's content and not its bytes, because the bytes contain memory addresses and
// padding, which differ from run to run.
struct TraceRecord {
  uint64_t number;
  uint64_t cause;
  int64_t time_us;
  int32_t sender;
  int32_t target;
  uint32_t selector;  // number of the receiver's entry; UNDEF if the message is a reply
  uint32_t size;      // number of bytes that `payload_hash` covers
  uint64_t payload_hash;
};
static_assert(sizeof(TraceRecord) == 48);

class Trace {
 public:
  using Sink = std::function<void(const TraceRecord&, const Message&)>;

  // Adds to the trace hash the record of `message`, which is delivered at `now_us`, and passes the
  // record to the sinks (listeners).
  void Deliver(const Message& message, int64_t now_us) {
    ++count_;
    if (is_recording_) Record(message, now_us);
  }

  // Adds a `sink`, a function that is called for every delivered message, after the sinks that were
  // added before.  Returns the number to give to RemoveSink().  REQUIRES: not called in a sink.
  int AddSink(Sink sink);
  void RemoveSink(int number);

  // Switches the computation of the trace hash on or off, to measure its cost in benchmarks.  If
  // the hash is off and there are no sinks, messages are only counted.
  void set_hashing(bool on);
  uint64_t hash() const;
  uint64_t count() const { return count_; }

 private:
  static constexpr int kBuffered = 64;

  void Record(const Message& message, int64_t now_us);
  void CallSinks(const TraceRecord& record, const Message& message);
  void HashBuffer() const;

  std::vector<std::pair<int, Sink>> sinks_;
  int last_sink_ = 0;
  uint64_t count_ = 0;
  bool hashing_ = true;
  // True if records of messages are needed, because the hash is computed or there are sinks
  // (listeners).
  bool is_recording_ = true;
  mutable Hasher hasher_;
  mutable int buffered_ = 0;
  mutable TraceRecord buffer_[kBuffered];
};

// Returns the hash of the content of `message` without memory addresses, and sets `*size` to the
// number of hashed bytes.  The hash covers
// - for a notification, the number of notifications and of regions in it, and the bytes of its
//   regions;
// - for a ready, its command and the number of regions that it gives back;
// - for any other message, its bytes.
// The hash of a message of the kind kHashed is Message::payload_hash, which its sender has set.
uint64_t PayloadHash(const Message& message, uint32_t* size);

// Returns the content of `message`, which a trace file stores and a replay compares.  The content
// of a notification is the bytes of its regions; of a ready, its command and the number of regions
// that it gives back; of any other message, its bytes.  Returns "" for a message of the kind
// kHashed, because its bytes hold addresses, which differ from run to run, so that comparing them
// would be useless.
std::string PayloadBytes(const Message& message);

// Returns the same bytes as PayloadBytes(), but without a copy if these bytes are in one piece in
// memory: then the result points to them.  Otherwise copies them to `*copy`, and the result points
// to the copy.  The result is valid until the message is released or `*copy` changes.
std::string_view PayloadView(const Message& message, std::string* copy);

}  // namespace openr_host

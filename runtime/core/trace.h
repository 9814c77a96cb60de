// The trace: every message delivered, in order, and its hash.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/hasher.h"
#include "runtime/core/message.h"

namespace openr_host {

// One delivered message.  Holds no address and no padding: its bytes are hashed.
struct TraceRecord {
  uint64_t number;
  uint64_t cause;
  int64_t time_us;
  int32_t sender;
  int32_t target;
  uint32_t selector;  // UNDEF: the answer to a request
  uint32_t size;      // bytes of content, see PayloadHash()
  uint64_t payload_hash;
};
static_assert(sizeof(TraceRecord) == 48);

class Trace {
 public:
  using Sink = std::function<void(const TraceRecord&, const Message&)>;

  // Adds the message to the hash and gives it to the sinks.
  void Deliver(const Message& message, int64_t now_us);

  // `sink` hears of every message, after those added before; the number is for RemoveSink().
  // Not from within a sink.
  int AddSink(Sink sink);
  void RemoveSink(int number);

  // Off: messages are counted only and the hash stands still; for benchmarks that
  // ask what it costs.
  void set_hashing(bool on) { hashing_ = on; }
  uint64_t hash() const;
  uint64_t count() const { return count_; }

 private:
  static constexpr int kBuffered = 64;

  std::vector<std::pair<int, Sink>> sinks_;
  int last_sink_ = 0;
  uint64_t count_ = 0;
  bool hashing_ = true;
  mutable Hasher hasher_;
  mutable int buffered_ = 0;
  mutable TraceRecord buffer_[kBuffered];
};

// What a message says, without addresses: the bytes of its regions for a
// notification, command and counts for a ready, its bytes otherwise.  `size`
// becomes the number of bytes that is.
uint64_t PayloadHash(const Message& message, uint32_t* size);

// The bytes that PayloadHash() speaks of; "" for a message that holds addresses.
std::string PayloadBytes(const Message& message);

}  // namespace openr_host

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

// One delivered message.  Its bytes are hashed, so it has no address and no padding.
struct TraceRecord {
  uint64_t number;
  uint64_t cause;
  int64_t time_us;
  int32_t sender;
  int32_t target;
  uint32_t selector;  // UNDEF: the reply to a request
  uint32_t size;      // number of bytes that PayloadHash() hashes
  uint64_t payload_hash;
};
static_assert(sizeof(TraceRecord) == 48);

class Trace {
 public:
  using Sink = std::function<void(const TraceRecord&, const Message&)>;

  // Adds the message to the hash and gives it to the sinks.
  void Deliver(const Message& message, int64_t now_us);

  // Adds a function that is called for every delivered message, after the sinks that were added
  // before.  Returns its number for RemoveSink().  REQUIRES: not called in a sink.
  int AddSink(Sink sink);
  void RemoveSink(int number);

  // Switches hashing off: messages are only counted.  For benchmarks that measure the cost of
  // hashing.
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

// Returns the hash of the content of a message without addresses: of a notification the bytes of
// its regions, of a ready its command and counts, of any other message its bytes.  Sets `*size` to
// the number of these bytes.
uint64_t PayloadHash(const Message& message, uint32_t* size);

// Returns the bytes that PayloadHash() hashes; "" for a message of kind kHashed.
std::string PayloadBytes(const Message& message);

}  // namespace openr_host

// Hasher: computes the XXH3 hash of a stream of values.  Hasher makes the trace hash of a run (all
// messages in their order) and the state hash (the state at one instant), by which two runs are
// compared.
//
// Only values are hashed.  Addresses and padding are not hashed, because they differ from run to
// run.  So Add() accepts only arithmetic types and enumerations, and AddBytes() must get bytes that
// are all initialised.  Add() hashes the bytes of its argument without reading its value, because
// the bytes of a bool in a message may be no valid bool.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

struct XXH3_state_s;

namespace openr_host {

class Hasher {
 public:
  Hasher();
  // Makes a hasher that also appends all added bytes to `*copy`.  The bytes can then be sent to
  // another process, which adds them to its own hash.
  explicit Hasher(std::string* copy) : Hasher() { copy_ = copy; }
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  void AddBytes(const void* data, size_t size);

  template <typename T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void Add(const T& value) { AddBytes(&value, sizeof value); }

  // Adds the length of `text`, then `text`, so that ("ab", "c") and ("a", "bc") have different
  // hashes.
  void AddText(std::string_view text);

  // Returns the 64-bit hash of all bytes that were added until now.  More bytes may be added
  // afterwards.
  uint64_t Digest() const;

 private:
  XXH3_state_s* state_;
  std::string* copy_ = nullptr;
};

// Returns the XXH3 hash of one block of bytes.
uint64_t HashBytes(const void* data, size_t size);

}  // namespace openr_host

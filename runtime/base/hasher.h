// XXH3 over a stream of plain values, for trace and state hashes.
//
// Only values go in, never addresses and never padding: Add() takes arithmetic
// types and enumerations, AddBytes() takes bytes whose every one is initialised.
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
  // Keeps what is added, too: for a hash that is made in another process.
  explicit Hasher(std::string* copy) : Hasher() { copy_ = copy; }
  ~Hasher();
  Hasher(const Hasher&) = delete;
  Hasher& operator=(const Hasher&) = delete;

  void AddBytes(const void* data, size_t size);

  template <typename T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void Add(T value) { AddBytes(&value, sizeof value); }

  // Length first, so that ("ab", "c") and ("a", "bc") differ.
  void AddText(std::string_view text);

  // The 64-bit hash of all that was added so far; more may be added afterwards.
  uint64_t Digest() const;

 private:
  XXH3_state_s* state_;
  std::string* copy_ = nullptr;
};

// XXH3 of one block of bytes.
uint64_t HashBytes(const void* data, size_t size);

}  // namespace openr_host

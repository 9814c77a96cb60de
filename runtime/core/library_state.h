// State of the C library that every object has for itself: the generator of drand48(), and
// strtok().
#pragma once

#include <cstdint>

namespace openr_host {

// Makes numbers of 48 bits: X becomes X * multiplier + addend, modulo 2^48 (POSIX, drand48()).
// Begins with the number of newlib, the robot's C library.
class Random48 {
 public:
  // Returns the next number, of 48 bits.
  uint64_t Next() {
    state_ = (state_ * multiplier_ + addend_) & kMask;
    return state_;
  }

  // Begins anew as srand48() does.
  void Seed(uint32_t seed) { Begin(uint64_t{seed} << 16 | 0x330e, kMultiplier, kAddend); }

  // Begins anew with the number `state`, as seed48() does.
  void Begin(uint64_t state) { Begin(state, kMultiplier, kAddend); }

  void Begin(uint64_t state, uint64_t multiplier, uint16_t addend) {
    state_ = state & kMask;
    multiplier_ = multiplier & kMask;
    addend_ = addend;
  }

  uint64_t state() const { return state_; }

 private:
  static constexpr uint64_t kMask = (uint64_t{1} << 48) - 1;
  static constexpr uint64_t kMultiplier = 0x5deece66d;
  static constexpr uint16_t kAddend = 0xb;

  uint64_t state_ = 0x1234abcd330e;
  uint64_t multiplier_ = kMultiplier;
  uint16_t addend_ = kAddend;
};

// State that the C library keeps once for a process, and that every object has for itself.
struct LibraryState {
  Random48 random48;
  uint16_t former_random48[3] = {};  // the number before the last seed48(), lowest 16 bits first
  char* strtok_place = nullptr;      // place at which the next strtok(nullptr, ...) goes on
};

}  // namespace openr_host

// Rng: a generator of random numbers that depend only on a seed and a name.  Generators with
// different names give different numbers, so a new generator does not change the numbers of the
// others.
#pragma once

#include <cstdint>
#include <string_view>

namespace openr_host {

class Hasher;

// The algorithm is xoshiro256**.  Its initial state comes from the algorithm splitmix64, started at
// the seed XOR the XXH3 hash of the name.
class Rng {
 public:
  Rng(uint64_t seed, std::string_view name);

  uint64_t Next();
  // Returns a uniform value in [0, 1).
  double NextDouble();
  // Returns a uniform value in [0, n).  REQUIRES: n > 0.
  uint64_t NextBelow(uint64_t n);

  void HashState(Hasher* hasher) const;

 private:
  uint64_t s_[4];
};

}  // namespace openr_host

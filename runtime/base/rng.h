// Random numbers that depend on the seed and a name, and on nothing else.
#pragma once

#include <cstdint>
#include <string_view>

namespace openr_host {

class Hasher;

// The generator xoshiro256**; its state is filled by splitmix64, which starts at
// seed XOR XXH3(name).
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

#include "runtime/base/rng.h"

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

uint64_t SplitMix(uint64_t* state) {
  uint64_t z = (*state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

uint64_t RotateLeft(uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

}  // namespace

Rng::Rng(uint64_t seed, std::string_view name) {
  uint64_t state = seed ^ HashBytes(name.data(), name.size());
  for (uint64_t& word : s_) word = SplitMix(&state);
}

uint64_t Rng::Next() {
  const uint64_t result = RotateLeft(s_[1] * 5, 7) * 9;
  const uint64_t t = s_[1] << 17;
  s_[2] ^= s_[0];
  s_[3] ^= s_[1];
  s_[1] ^= s_[2];
  s_[0] ^= s_[3];
  s_[2] ^= t;
  s_[3] = RotateLeft(s_[3], 45);
  return result;
}

double Rng::NextDouble() { return static_cast<double>(Next() >> 11) * 0x1.0p-53; }

uint64_t Rng::NextBelow(uint64_t n) {
  ASSERT(n > 0);
  // Draws random values until a value is less than `limit`.  Because `limit` is a multiple of n,
  // each result of `value % n` is then equally likely.
  const uint64_t limit = UINT64_MAX - UINT64_MAX % n;
  uint64_t value = Next();
  while (value >= limit) value = Next();
  return value % n;
}

void Rng::HashState(Hasher* hasher) const {
  for (const uint64_t word : s_) hasher->Add(word);
}

}  // namespace openr_host

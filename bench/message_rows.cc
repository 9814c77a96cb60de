// Rows that compare messages between objects with a ring of structs, in which a message costs one
// virtual call.
#include <memory>

#include "bench/bench.h"
#include "bench/ping_pong.h"

namespace openr_host {
namespace {

// Returns the function of a variant.  It makes the game (PingPong) when its row runs first, because
// 10,000 objects take memory and caches from the rows that run before.
std::function<void(int64_t)> Lazy(int pairs, size_t bytes, bool traced) {
  auto game = std::make_shared<std::unique_ptr<PingPong>>();
  return [=](int64_t count) {
    if (*game == nullptr) *game = std::make_unique<PingPong>(pairs, bytes, traced);
    (*game)->Run(count);
  };
}

// Returns the limits of a message: `ns`, and its ratio to the floor, which took 4.5 ns where the
// limits were chosen.
std::vector<Limit> LimitsOf(double ns) {
  return {{Limit::Kind::kTime, ns}, {Limit::Kind::kRatioAtMost, ns / 4.5}};
}

}  // namespace

std::vector<Row> MessageRows() {
  constexpr int64_t kCount = 1'000'000;
  const Variant ring{"ring, one virtual call", RunRing};
  Row pair{"notify and the ready that comes back", "ns a message", kCount};
  pair.variants = {ring,
                   {"notify/ready, 32 bytes", Lazy(1, 32, false), LimitsOf(30)},
                   {"notify/ready with trace hash", Lazy(1, 32, true), LimitsOf(40)}};

  Row size{"region of any size", "ns a message", kCount / 10};
  size.variants = {{"32 bytes", Lazy(1, 32, false)},
                   {"64 KiB", Lazy(1, 64 << 10, false)},
                   {"1 MiB", Lazy(1, 1 << 20, false)}};

  Row many{"10,000 code-built objects", "ns a message", kCount};
  many.variants = {ring, {"5,000 pairs", Lazy(5000, 32, false), LimitsOf(60)}};

  std::vector<Row> rows = {pair, size, many};
  for (Row& row : rows) row.warm_up = row.count / 10;
  return rows;
}

}  // namespace openr_host

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

}  // namespace

std::vector<Row> MessageRows() {
  constexpr int64_t kCount = 1'000'000;
  return {
      {"notify and the ready that comes back",
       "ns a message",
       kCount,
       {{"ring, one virtual call", RunRing},
        {"notify/ready, 32 bytes", Lazy(1, 32, false)},
        {"notify/ready with trace hash", Lazy(1, 32, true)}},
       3.0},
      {"region of any size",
       "ns a message",
       kCount / 10,
       {{"32 bytes", Lazy(1, 32, false)},
        {"64 KiB", Lazy(1, 64 << 10, false)},
        {"1 MiB", Lazy(1, 1 << 20, false)}},
       1.0},
      {"10,000 code-built objects",
       "ns a message",
       kCount,
       {{"ring, one virtual call", RunRing}, {"5,000 pairs", Lazy(5000, 32, false)}},
       3.0},
  };
}

}  // namespace openr_host

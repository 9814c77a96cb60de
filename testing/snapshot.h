// A state that takes long to reach, reached once: every test gets a copy of the process in
// which it holds.
//
//   Snapshot<Bench>& Standing() {
//     static Snapshot<Bench> standing([] {
//       auto bench = std::make_unique<Bench>(BenchOptions{.stick = STICK, .body = "ideal"});
//       bench->Boot();
//       bench->RunUntil([&] { return bench->state("JointMover") == "accepting-commands"; }, 20s);
//       return bench;
//     });
//     return standing;
//   }
//   TEST(WalkTest, Walks) {
//     Standing().Run([](Bench& bench) { ... });
//   }
//
// A copy (fork) takes a fraction of a millisecond and shares nothing with the others, so
// tests may do to it what they like, crash included.  Failures and skips in a copy are those
// of the test that asked for it, at the same lines.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "testing/place.h"

namespace openr::testing {

// Runs `body` in a copy of this process.  What fails there fails here; so does a copy that
// dies.  REQUIRES: no other thread (reported otherwise).
void RunInCopy(const std::function<void()>& body, const Place& place);

// World: anything; what it calls OnCopied() is called in every copy, for what must not be
// shared (Bench: the stick).
template <typename World>
class Snapshot {
 public:
  // `make` reaches the state, once, when the first test asks for it.  Null: it could not.
  explicit Snapshot(std::function<std::unique_ptr<World>()> make) : make_(std::move(make)) {}

  void Run(const std::function<void(World&)>& test, Place place = Place::Here()) {
    if (make_) world_ = std::exchange(make_, nullptr)();
    if (world_ == nullptr) {
      Fail(place, "The state of this snapshot was not reached; see its first failure");
      return;
    }
    RunInCopy(
        [&] {
          if constexpr (requires { world_->OnCopied(); }) world_->OnCopied();
          test(*world_);
          world_.reset();
        },
        place);
  }

 private:
  std::function<std::unique_ptr<World>()> make_;
  std::unique_ptr<World> world_;
};

}  // namespace openr::testing

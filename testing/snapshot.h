// A state that takes long to reach is reached once.  Every test gets a copy of the process in this
// state.
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
// A copy (fork) takes a fraction of a millisecond and shares nothing with other copies, so a test
// may change the state or crash.  Failures and skips in a copy belong to the test that asked for
// it, at the same lines.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "testing/place.h"

namespace openr::testing {

// Runs `body` in a copy of this process.  A failure in the copy, and a crash of it, is a failure of
// the running test.  REQUIRES: the process has one thread (reports a failure otherwise).
void RunInCopy(const std::function<void()>& body, const Place& place);

// A state of a World that several tests go on from, each in a copy of the process.  World may be
// any type.  If it has a member OnCopied(), each copy calls it first, to replace what copies must
// not share (a Bench replaces its stick).
template <typename World>
class Snapshot {
 public:
  // `make` reaches the state.  `make` is called once, when the first test asks for the state.  A
  // null result means that it failed.
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

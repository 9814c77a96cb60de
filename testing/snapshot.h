// Snapshot, a state of a bench that takes long to reach.  The state is reached once, and every test
// gets a copy of the process in this state.
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
// A copy (made with fork) takes less than a millisecond and shares nothing with other copies, so a
// test may change the state or crash.  If a test fails or is skipped in a copy, the original
// process reports this for the test, with the file and line where it happened in the copy.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "testing/place.h"

namespace openr::testing {

// Runs `body` in a copy of this process.  Failures of the copy, and its crash, are failures of the
// running test.  If this process has more than one thread, reports a failure and does not run
// `body`, because fork() copies only the calling thread.
void RunInCopy(const std::function<void()>& body, const Place& place);

// A state from which several tests go on, each in a copy of the process.  World is any type, such
// as Bench.  If World has a function OnCopied(), each copy calls this function first, to replace
// what copies must not share (a Bench replaces its stick).
template <typename World>
class Snapshot {
 public:
  // `make` is a function that makes a World and brings it to the state.  Only the first Run() calls
  // it.  If `make` returns null, the state was not reached, and Run() fails in every test.
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

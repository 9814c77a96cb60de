// The end of the workers of a run: all of them are told before one of them is waited for, and
// workers that are stopped share one limit of time.
#include "distribution/end_workers.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/distribution/forged.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;

constexpr int64_t kReceiptMs = 5000;
constexpr int64_t kExitMs = 4000;

class EndWorkersTest : public ::testing::Test {
 protected:
  // Adds a worker that receives a sample `needed_ms` after the first wait for it has begun.
  void Add(const std::string& name, int64_t needed_ms, bool is_there = true) {
    workers_.push_back({[this, name, is_there] {
                          calls_.push_back("tell " + name);
                          return is_there;
                        },
                        [this, name, needed_ms](int64_t limit_ms) {
                          calls_.push_back(fmt::format("wait {} ms for {}", limit_ms, name));
                          now_ms_ += std::min(needed_ms, limit_ms);
                          return needed_ms <= limit_ms;
                        },
                        [this, name](int64_t limit_ms) {
                          calls_.push_back(
                              fmt::format("wait {} ms for the end of {}", limit_ms, name));
                          now_ms_ += std::min(ending_ms_, limit_ms);
                        }});
  }
  // Adds a worker that is stopped, so it never receives anything.
  void AddStopped(const std::string& name) { Add(name, 1'000'000); }
  void End() {
    EndWorkers(workers_, {kReceiptMs, kExitMs}, [this] { return now_ms_; });
  }

  int64_t now_ms_ = 77;
  int64_t ending_ms_ = 0;  // time that each worker needs to end
  std::vector<EndingWorker> workers_;
  std::vector<std::string> calls_;  // all calls of functions of the workers, in their order
};

TEST_F(EndWorkersTest, StoppedWorkersShareOneLimit) {
  AddStopped("a");
  AddStopped("b");
  Add("c", 0);
  End();
  EXPECT_THAT(calls_,
              ElementsAre("tell a", "tell b", "tell c", "wait 5000 ms for a", "wait 0 ms for b",
                          "wait 0 ms for c", "wait 0 ms for the end of a",
                          "wait 0 ms for the end of b", "wait 4000 ms for the end of c"));
}

TEST_F(EndWorkersTest, WorkersThatDoNotEndShareOneLimit) {
  ending_ms_ = 3000;
  Add("a", 0);
  Add("b", 0);
  Add("c", 0);
  End();
  EXPECT_THAT(calls_,
              ElementsAre("tell a", "tell b", "tell c", "wait 5000 ms for a", "wait 5000 ms for b",
                          "wait 5000 ms for c", "wait 4000 ms for the end of a",
                          "wait 1000 ms for the end of b", "wait 0 ms for the end of c"));
}

TEST_F(EndWorkersTest, ABusyWorkerLeavesTheNextOneTheRestOfTheLimit) {
  Add("a", 2000);
  Add("b", 2000);
  Add("c", 2000);
  End();
  EXPECT_THAT(calls_,
              ElementsAre("tell a", "tell b", "tell c", "wait 5000 ms for a", "wait 3000 ms for b",
                          "wait 1000 ms for c", "wait 4000 ms for the end of a",
                          "wait 4000 ms for the end of b", "wait 0 ms for the end of c"));
}

TEST_F(EndWorkersTest, AWorkerThatIsNotThereIsNotWaitedFor) {
  Add("a", 0, false);
  Add("b", 0);
  End();
  EXPECT_THAT(calls_,
              ElementsAre("tell a", "tell b", "wait 5000 ms for b", "wait 4000 ms for the end of a",
                          "wait 4000 ms for the end of b"));
}

class EndOfOneWorkerTest : public ForgedTest {
 protected:
  // Returns the reason of the end that the worker receives; "" if it receives none.
  std::string ReasonInWorker() {
    while (const auto to_worker = channel_->Receive(10'000)) {
      if (to_worker->body._d == openr_wire_TO_WORKER_END)
        return StringOf(to_worker->body._u.ended.why);
    }
    return "";
  }
};

TEST_F(EndOfOneWorkerTest, ItHearsWhyTheRunHasEnded) {
  EXPECT_TRUE(process_.SendEnd("ended by a test"));
  EXPECT_TRUE(process_.connection().AwaitReceipt(10'000));
  EXPECT_EQ(ReasonInWorker(), "ended by a test");
}

TEST_F(EndOfOneWorkerTest, AWorkerThatWasGivenUpIsNotTold) {
  process_.ReleaseAll();
  EXPECT_FALSE(process_.SendEnd("ended by a test"));
}

}  // namespace
}  // namespace openr_host

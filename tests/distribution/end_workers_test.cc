// The end of the workers of a run: all of them are told before one of them is waited for, and
// workers that are stopped share one limit of time.
#include "distribution/end_workers.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "distribution/child_process.h"
#include "tests/distribution/forged.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr int64_t kReceiptMs = 5000;
constexpr int64_t kExitMs = 4000;
constexpr int64_t kInterruptedMs = 500;
constexpr int64_t kNever = 1'000'000;

class EndWorkersTest : public ::testing::Test {
 protected:
  // Adds a worker that receives a sample `receipt_ms` after the first wait for it has begun, and
  // ends `ending_ms` after the first wait for its end has begun.
  void Add(const std::string& name, int64_t receipt_ms, int64_t ending_ms, bool is_there = true,
           bool has_ended = false) {
    workers_.push_back({[this, name, is_there] {
                          calls_.push_back({"tell " + name});
                          return is_there;
                        },
                        [has_ended] { return has_ended; },
                        [this, name, receipt_ms](int64_t limit_ms) mutable {
                          return Wait(name, limit_ms, &receipt_ms);
                        },
                        [this, name, ending_ms](int64_t limit_ms) mutable {
                          return Wait("the end of " + name, limit_ms, &ending_ms);
                        },
                        [this, name] { calls_.push_back({"kill " + name}); }});
  }
  // Adds a worker that is stopped, so it never receives anything and never ends.
  void AddStopped(const std::string& name) { Add(name, kNever, kNever); }

  // Calls EndWorkers(), and returns the calls of functions of the workers in their order.  Waits
  // for the same event that follow each other are returned as one wait, with the time of all of
  // them.
  std::vector<std::string> End() {
    const int64_t begin_ms = now_ms_;
    EndWorkers(
        workers_, {kReceiptMs, kExitMs, kInterruptedMs},
        [this, begin_ms] { return now_ms_ - begin_ms >= interrupt_ms_; },
        [this] { return now_ms_; });
    std::vector<std::string> texts;
    for (const Call& call : calls_) {
      texts.push_back(call.waits == 0
                          ? call.text
                          : fmt::format("wait {} ms for {}", call.waited_ms, call.text));
    }
    return texts;
  }
  // Returns how often the workers were waited for.
  int CountWaits() const {
    int count = 0;
    for (const Call& call : calls_) count += call.waits;
    return count;
  }

  int64_t interrupt_ms_ = kNever;  // time after the begin at which the user asks not to wait

 private:
  struct Call {
    std::string text;
    int waits = 0;  // number of waits for the event `text`; 0 if the call is no wait
    int64_t waited_ms = 0;
  };

  // Waits for `event`, which comes in `*needed_ms`.  Returns whether it has come.
  bool Wait(const std::string& event, int64_t limit_ms, int64_t* needed_ms) {
    EXPECT_LE(limit_ms, kEndSliceMs);
    const int64_t waited_ms = std::min(*needed_ms, limit_ms);
    if (calls_.back().text != event) calls_.push_back({event});
    ++calls_.back().waits;
    calls_.back().waited_ms += waited_ms;
    now_ms_ += waited_ms;
    *needed_ms -= waited_ms;
    return *needed_ms == 0;
  }

  int64_t now_ms_ = 77;
  std::vector<EndingWorker> workers_;
  std::vector<Call> calls_;
};

TEST_F(EndWorkersTest, StoppedWorkersShareOneLimit) {
  AddStopped("a");
  AddStopped("b");
  Add("c", 0, kExitMs);
  EXPECT_THAT(End(),
              ElementsAre("tell a", "tell b", "tell c", "wait 5000 ms for a", "wait 0 ms for b",
                          "wait 0 ms for c", "wait 0 ms for the end of a", "kill a",
                          "wait 0 ms for the end of b", "kill b", "wait 4000 ms for the end of c"));
}

TEST_F(EndWorkersTest, WorkersThatDoNotEndShareOneLimit) {
  for (const char* const name : {"a", "b", "c"}) Add(name, 0, 3000);
  EXPECT_THAT(End(), ElementsAre("tell a", "tell b", "tell c", "wait 0 ms for a", "wait 0 ms for b",
                                 "wait 0 ms for c", "wait 3000 ms for the end of a",
                                 "wait 1000 ms for the end of b", "kill b",
                                 "wait 0 ms for the end of c", "kill c"));
}

TEST_F(EndWorkersTest, ABusyWorkerLeavesTheNextOneTheRestOfTheLimit) {
  for (const char* const name : {"a", "b", "c"}) Add(name, 2000, 10);
  EXPECT_THAT(End(),
              ElementsAre("tell a", "tell b", "tell c", "wait 2000 ms for a", "wait 2000 ms for b",
                          "wait 1000 ms for c", "wait 10 ms for the end of a",
                          "wait 10 ms for the end of b", "wait 0 ms for the end of c", "kill c"));
}

TEST_F(EndWorkersTest, AWorkerThatIsNotThereIsNotWaitedFor) {
  Add("a", 0, 10, false);
  Add("b", 0, 10);
  EXPECT_THAT(End(), ElementsAre("tell a", "tell b", "wait 0 ms for b",
                                 "wait 10 ms for the end of a", "wait 10 ms for the end of b"));
}

// A worker that was killed is there for DDS until its lease is over.
TEST_F(EndWorkersTest, AWorkerWhoseProcessHasEndedIsNotWaitedFor) {
  Add("a", kNever, 0, true, true);
  Add("b", 0, 10);
  EXPECT_THAT(End(), ElementsAre("tell a", "tell b", "wait 0 ms for b",
                                 "wait 0 ms for the end of a", "wait 10 ms for the end of b"));
}

TEST_F(EndWorkersTest, AWorkerThatEndsAtOnceIsWaitedForOnceInEachStep) {
  for (const char* const name : {"a", "b", "c"}) Add(name, 0, 0);
  End();
  EXPECT_EQ(CountWaits(), 6);
}

// The user asks not to wait while a wait is under way.  This is noticed at the end of a slice.
TEST_F(EndWorkersTest, AnInterruptShortensTheWaitForReceipt) {
  interrupt_ms_ = 10 * kEndSliceMs + 1;
  AddStopped("a");
  AddStopped("b");
  Add("c", 0, kNever);
  EXPECT_THAT(End(), ElementsAre("tell a", "tell b", "tell c", "wait 1600 ms for a",
                                 "wait 0 ms for b", "wait 0 ms for c", "wait 0 ms for the end of a",
                                 "kill a", "wait 0 ms for the end of b", "kill b",
                                 "wait 500 ms for the end of c", "kill c"));
}

TEST_F(EndWorkersTest, AnInterruptShortensTheWaitForTheEnd) {
  interrupt_ms_ = 10 * kEndSliceMs + 1;
  Add("a", 0, kNever);
  EXPECT_THAT(End(),
              ElementsAre("tell a", "wait 0 ms for a", "wait 1600 ms for the end of a", "kill a"));
}

TEST_F(EndWorkersTest, AnInterruptBeforeTheEndShortensAllWaits) {
  interrupt_ms_ = 0;
  AddStopped("a");
  Add("b", 0, kNever);
  EXPECT_THAT(End(), ElementsAre("tell a", "tell b", "wait 500 ms for a", "wait 0 ms for b",
                                 "wait 0 ms for the end of a", "kill a",
                                 "wait 500 ms for the end of b", "kill b"));
}

TEST_F(EndWorkersTest, AnInterruptDoesNotLengthenAWait) {
  interrupt_ms_ = kReceiptMs - kEndSliceMs;
  AddStopped("a");
  EXPECT_THAT(End(),
              ElementsAre("tell a", "wait 5000 ms for a", "wait 0 ms for the end of a", "kill a"));
}

TEST(ChildProcessTest, AWaitThatEndsTooEarlyLeavesTheProcessAlive) {
  ChildProcess child("sleeper", {"sleep", "600"}, false);
  EXPECT_FALSE(child.WaitForEnd(0));
  EXPECT_EQ(child.EndText(), "");
  child.Kill();
  EXPECT_THAT(child.EndText(), HasSubstr("was killed by signal 9"));
  EXPECT_TRUE(child.WaitForEnd(0));
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

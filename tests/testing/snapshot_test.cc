// States that are reached once, and copied for every test.
#include <csignal>
#include <cstdlib>
#include <fstream>

#include "tests/testing/doubler.h"

namespace openr::testing {
namespace {

using ::testing::HasSubstr;

int g_made = 0;

Snapshot<Bench>& AfterOneSecond() {
  static Snapshot<Bench> snapshot([] {
    ++g_made;
    auto bench = std::make_unique<Bench>();
    bench->Add<Doubler>("Doubler");
    bench->Feed("Doubler.In.int.O");
    bench->Watch("Doubler.Out.int.S");
    bench->stick().Write("/MS/NOTES.TXT", "made");
    bench->Boot();
    bench->RunFor(1s);
    return bench;
  });
  return snapshot;
}

ProbeObserver& OutOf(Bench& bench) { return bench.probe("Test2").observer("Out"); }

TEST(SnapshotTest, EveryTestGetsACopyOfTheState) {
  for (int i = 1; i <= 3; ++i) {
    AfterOneSecond().Run([&](Bench& bench) {
      EXPECT_EQ(bench.now_us(), 1'000'000);
      EXPECT_EQ(bench.stick().Read("/MS/NOTES.TXT"), "made");
      bench.stick().Write("/MS/NOTES.TXT", "spoilt");
      bench.probe("Test1").subject("In").Send(i);
      bench.RunFor(1s);
      EXPECT_EQ(OutOf(bench).values<int>(), Ints{2 * i});
    });
  }
  EXPECT_EQ(g_made, 1);
}

TEST(SnapshotTest, AFailureInACopyIsAFailureHereAtTheSameLine) {
  ::testing::TestPartResultArray results;
  const int line = __LINE__ + 4;
  {
    ::testing::ScopedFakeTestPartResultReporter reporter(
        ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    AfterOneSecond().Run([](Bench& bench) { EXPECT_EQ(bench.now_us(), 1) << "in the copy"; });
  }
  ASSERT_EQ(results.size(), 1);
  const ::testing::TestPartResult& result = results.GetTestPartResult(0);
  EXPECT_EQ(result.line_number(), line);
  EXPECT_THAT(result.file_name(), HasSubstr("snapshot_test.cc"));
  EXPECT_THAT(result.message(), HasSubstr("in the copy"));
  EXPECT_TRUE(result.nonfatally_failed());
}

TEST(SnapshotTest, ExpectationsOfACopyAreVerified) {
  EXPECT_NONFATAL_FAILURE(AfterOneSecond().Run([](Bench& bench) { bench.Expect(NotReady()); }),
                          "Expected, but it did not happen: not ready");
}

TEST(SnapshotTest, ACopyThatDiesIsAFailure) {
  EXPECT_NONFATAL_FAILURE(AfterOneSecond().Run([](Bench&) { raise(SIGKILL); }),
                          "The copy of the process died of signal 9 (Killed)");
  EXPECT_NONFATAL_FAILURE(AfterOneSecond().Run([](Bench&) { _exit(3); }),
                          "The copy of the process ended itself with status 3");
  EXPECT_NONFATAL_FAILURE(AfterOneSecond().Run([](Bench&) { throw std::runtime_error("oh"); }),
                          "uncaught exception: oh");
  AfterOneSecond().Run([](Bench& bench) { EXPECT_EQ(bench.now_us(), 1'000'000); });
}

TEST(SnapshotTest, WhatWasSaidBeforeADeathIsNotLost) {
  ::testing::TestPartResultArray results;
  {
    ::testing::ScopedFakeTestPartResultReporter reporter(
        ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &results);
    AfterOneSecond().Run([](Bench&) {
      ADD_FAILURE() << "the first sign";
      raise(SIGKILL);
    });
  }
  ASSERT_EQ(results.size(), 2);
  EXPECT_THAT(results.GetTestPartResult(0).message(), HasSubstr("the first sign"));
}

TEST(SnapshotTest, AStateThatIsNotReachedFailsEveryTest) {
  Snapshot<Bench> never([]() -> std::unique_ptr<Bench> { return nullptr; });
  for (int i = 0; i < 2; ++i) {
    EXPECT_NONFATAL_FAILURE(never.Run([](Bench&) {}), "The state of this snapshot was not reached");
  }
}

}  // namespace
}  // namespace openr::testing

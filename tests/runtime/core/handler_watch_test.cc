// How much stack a handler's own functions use.
#include "runtime/core/handler_watch.h"

#include <gtest/gtest.h>

#include "runtime/core/current.h"

namespace openr_host {
namespace {

constexpr size_t kDepth = size_t{32} << 10;

template <size_t kBytes>
__attribute__((noinline)) char UseStack() {
  volatile char room[kBytes];
  for (size_t i = 0; i < kBytes; i += 64) room[i] = static_cast<char>(i);
  return room[kBytes - 1];
}

// A function of the runtime: its frame is none of the handler's.
__attribute__((noinline)) void CallRuntime() {
  const ApiScope scope;
  UseStack<20000>();
}

// What `handler` uses, by the watch.
template <typename Handler>
__attribute__((noinline)) size_t UsedBy(Handler handler) {
  HandlerWatch watch(kDepth);
  const Current saved = t_current;
  t_current = {nullptr, nullptr, true, &watch};
  watch.Begin(__builtin_frame_address(0), 0);
  handler();
  t_current = saved;
  watch.End();
  return watch.Used();
}

class HandlerWatchTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!HandlerWatch::CanMeasure()) GTEST_SKIP() << "unused stack is somebody else's";
    UsedBy([] { CallRuntime(); });  // the first call of a function looks it up, on this stack
  }
};

TEST_F(HandlerWatchTest, CountsTheFramesOfTheHandler) {
  const size_t used = UsedBy([] { UseStack<5000>(); });
  EXPECT_GE(used, 5000u);
  EXPECT_LT(used, 5600u);
}

TEST_F(HandlerWatchTest, LeavesOutWhatTheRuntimeUsesOnItsBehalf) {
  EXPECT_LT(UsedBy([] { CallRuntime(); }), 1000u);
}

TEST_F(HandlerWatchTest, CountsWhatCameBeforeAndAfterACall) {
  for (const bool is_before : {true, false}) {
    const size_t used = UsedBy([is_before] {
      if (is_before) UseStack<5000>();
      CallRuntime();
      if (!is_before) UseStack<5000>();
    });
    EXPECT_GE(used, 5000u) << is_before;
    EXPECT_LT(used, 6000u) << is_before;
  }
}

TEST_F(HandlerWatchTest, CountsTheCallerOfTheRuntime) {
  const size_t used = UsedBy([] {
    volatile char room[6000];
    room[0] = 1;
    CallRuntime();
    room[5999] = room[0];
  });
  EXPECT_GE(used, 6000u);
  EXPECT_LT(used, 7000u);
}

TEST_F(HandlerWatchTest, ACallWithinACallIsPartOfIt) {
  const size_t used = UsedBy([] {
    const LibraryScope scope;
    CallRuntime();
    UseStack<9000>();
  });
  EXPECT_LT(used, 1000u);
}

TEST_F(HandlerWatchTest, StopsAtTheDepthThatWasAskedFor) {
  const size_t used = UsedBy([] { UseStack<60000>(); });
  EXPECT_LE(used, kDepth);
  EXPECT_GT(used, kDepth - 64);  // it leaves gaps of that size
}

TEST_F(HandlerWatchTest, TheDepthSufficesForTwiceTheSizeOfTheOcfFile) {
  EXPECT_GE(HandlerWatch::DepthFor(3072), 2 * 3072u + 1);
  EXPECT_GE(HandlerWatch::DepthFor(65536), 2 * 65536u + 1);
}

}  // namespace
}  // namespace openr_host

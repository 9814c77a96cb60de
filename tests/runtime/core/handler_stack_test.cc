// The stack of an image's code: zero at the begin of each call, and measured.
#include "runtime/core/handler_stack.h"

#include <alloca.h>
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "runtime/core/address_plan.h"
#include "runtime/core/memory_tools.h"
#include "runtime/core/stack_memory.h"

namespace openr_host {
namespace {

constexpr size_t kRoomBytes = 8000;

// Writes to 8,000 bytes of stack.
__attribute__((noinline)) void Scribble(void*) {
  char room[kRoomBytes];
  std::fill_n(static_cast<volatile char*>(room), kRoomBytes, 'x');
}

// How many of the bytes that Scribble() wrote to are not zero for a later call.
__attribute__((noinline)) void CountLeftovers(void* result) {
  const char* room = static_cast<char*>(alloca(kRoomBytes));
  asm volatile("" : "+r"(room) : : "memory");  // the compiler does not know what lies there
  *static_cast<size_t*>(result) =
      static_cast<size_t>(std::count_if(room, room + kRoomBytes, [](char c) { return c == 'x'; }));
}

// Writes to 8,000 bytes of stack that lie below 20,000 bytes which nobody has used.
__attribute__((noinline)) void ScribbleBelowAGap(void*) {
  char* const gap = static_cast<char*>(alloca(20000));
  asm volatile("" : : "r"(gap) : "memory");  // the compiler keeps the gap
  Scribble(nullptr);
}

// The same place as in ScribbleBelowAGap(): counts the bytes there that are not zero.
__attribute__((noinline)) void CountLeftoversBelowAGap(void* result) {
  char* const gap = static_cast<char*>(alloca(20000));
  asm volatile("" : : "r"(gap) : "memory");
  CountLeftovers(result);
}

// How many pages of the image's stack at `place` have memory; nullopt if the kernel does not tell.
std::optional<size_t> PagesWithMemory(const ObjectAddresses& place) {
  std::vector<unsigned char> has_memory(StackMemory::kBytes / 4096);
  if (mincore(place.stack(0) + StackMemory::kBottomOffset, StackMemory::kBytes,
              has_memory.data()) != 0)
    return std::nullopt;
  return static_cast<size_t>(std::count_if(has_memory.begin(), has_memory.end(),
                                           [](unsigned char page) { return (page & 1) != 0; }));
}

class HandlerStackTest : public testing::Test {
 protected:
  void SetUp() override {
    if (place_.image() == nullptr || IsStackWatched())
      GTEST_SKIP() << "code of images runs on the caller's stack, or on one that is watched";
  }

  const ObjectAddresses place_{0};
};

TEST_F(HandlerStackTest, WhatACallLeftIsGoneBeforeTheNextOne) {
  HandlerStack stack(place_.stack(0));
  for (int i = 0; i < 100; ++i) {  // the first calls are cleared in another way than later ones
    stack.Call(&Scribble, nullptr);
    size_t leftovers = kRoomBytes;
    stack.Call(&CountLeftovers, &leftovers);
    EXPECT_EQ(leftovers, 0u) << i;
  }
}

TEST_F(HandlerStackTest, WhatLiesBelowUnusedPagesIsGoneAsWell) {
  HandlerStack stack(place_.stack(0));
  stack.Call(&ScribbleBelowAGap, nullptr);
  EXPECT_GE(stack.UsedBytes(), 20000 + kRoomBytes);
  size_t leftovers = kRoomBytes;
  stack.Call(&CountLeftoversBelowAGap, &leftovers);
  EXPECT_EQ(leftovers, 0u);
}

TEST_F(HandlerStackTest, TheSearchForWrittenBytesGivesNoMemoryToUnusedPages) {
  HandlerStack stack(place_.stack(0));
  if (PagesWithMemory(place_).value_or(1) != 0)
    GTEST_SKIP() << "this kernel does not tell which pages have memory";
  stack.Call([](void*) {}, nullptr);
  // More than one where the kernel gives memory to several pages at a time.
  const size_t used = PagesWithMemory(place_).value();
  for (int i = 0; i < 100; ++i) stack.Call([](void*) {}, nullptr);
  EXPECT_LE(PagesWithMemory(place_).value(), used + 1);
}

TEST_F(HandlerStackTest, TellsHowMuchTheLastCallUsed) {
  HandlerStack stack(place_.stack(0));
  stack.Call(&Scribble, nullptr);
  EXPECT_GE(stack.UsedBytes(), kRoomBytes);
  EXPECT_LT(stack.UsedBytes(), kRoomBytes + 500);
  stack.Call([](void*) {}, nullptr);
  EXPECT_LT(stack.UsedBytes(), 100u);
}

TEST_F(HandlerStackTest, ACallWithinACallGoesOnOnTheSameStack) {
  HandlerStack stack(place_.stack(0));
  struct Calls {
    HandlerStack* stack;
    char* inner;
  } calls{&stack, nullptr};
  stack.Call(
      [](void* argument) {
        static_cast<Calls*>(argument)->stack->Call(
            [](void* again) {
              static_cast<Calls*>(again)->inner = static_cast<char*>(__builtin_frame_address(0));
            },
            argument);
      },
      &calls);
  EXPECT_GT(calls.inner, place_.stack(0));
  EXPECT_LT(calls.inner, place_.stack(0) + ObjectAddresses::kStackBytes);
}

TEST_F(HandlerStackTest, AnExceptionLeavesACleanStack) {
  HandlerStack stack(place_.stack(0));
  const std::string here = "a variable of the caller";  // in a register that is put back
  try {
    stack.Call(
        [](void*) {
          Scribble(nullptr);
          throw std::runtime_error("thrown on the other stack");
        },
        nullptr);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "thrown on the other stack");
  }
  EXPECT_EQ(here, "a variable of the caller");
  size_t leftovers = kRoomBytes;
  stack.Call(&CountLeftovers, &leftovers);
  EXPECT_EQ(leftovers, 0u);
}

}  // namespace
}  // namespace openr_host

// Functions of the libraries that an image calls run on another stack than its own functions.
#include <gtest/gtest.h>

#include <cstdlib>

#include "runtime/core/address_plan.h"
#include "runtime/core/load_stick.h"
#include "runtime/core/memory_tools.h"
#include "runtime/core/stack_memory.h"
#include "tests/runtime/images/image_fixture.h"

namespace openr_host {
namespace {

using ImportsTest = ImageTest;

TEST_F(ImportsTest, AllArgumentsArrive) {
  Start();
  EXPECT_EQ(talker->Ask("arguments"),
            "1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 31 "
            "32 33 34 35 36 37 38 39 40 0.5 1.5 2.5 3.5 4.5 5.5 6.5 7.5 8.5 9.5 10.5 11.5 end");
}

TEST_F(ImportsTest, AnExceptionOfTheLibraryIsCaughtInTheImage) {
  Start();
  EXPECT_EQ(talker->Ask("catch"), "0 caught caught ");
}

TEST_F(ImportsTest, AJumpComesBackWhereItWasSet) {
  Start();
  EXPECT_EQ(talker->Ask("jump"), "came with 7");
  EXPECT_EQ(talker->Ask("jump"), "came with 7");
}

TEST_F(ImportsTest, AFunctionThatTheLibraryCallsBackMayCallTheLibrary) {
  Start();
  EXPECT_EQ(talker->Ask("sort"), "1 4 30 200 ");
}

TEST_F(ImportsTest, TheAddressOfAFunctionIsOneAddress) {
  Start();
  EXPECT_EQ(talker->Ask("functions"), "10 23");
}

TEST_F(ImportsTest, WhatTheLibraryUsesIsNoStackOfTheObject) {
  if (IsStackWatched()) GTEST_SKIP() << "the stack is not measured";
  Start({.measure_stacks = true});
  const Object* const probe = system->FindObject(0, "probe");
  talker->Ask("sort");
  const size_t shallow = probe->statistics().stack_max();
  talker->Ask("digits");  // the C library needs some thousand bytes for them
  EXPECT_LT(probe->statistics().stack_max(), shallow + 1000);
}

TEST_F(ImportsTest, ConstructorsRunOnTheStackOfHandlers) {
  if (ObjectAddresses(0).image() == nullptr) GTEST_SKIP() << "addresses are not planned";
  Start();
  const uint64_t constructed = std::strtoull(talker->Ask("constructed").c_str(), nullptr, 16);
  const uint64_t handled = std::strtoull(talker->Ask("stack").c_str(), nullptr, 16);
  EXPECT_NE(handled, 0u);
  EXPECT_EQ(constructed / ObjectAddresses::kStackBytes, handled / ObjectAddresses::kStackBytes);
  EXPECT_GT(constructed % ObjectAddresses::kStackBytes, StackMemory::kBottomOffset);
}

TEST_F(ImportsTest, AConstructorThatThrowsIsAProblemOfTheImage) {
  Write("OPEN-R/MW/DATA/P/THROW.TXT", "");
  System broken;
  broken.AddRobot("ERS-210", stick);
  EXPECT_FALSE(LoadStick(&broken, 0));
  ASSERT_FALSE(broken.findings().all().empty());
  EXPECT_EQ(broken.findings().all()[0].text,
            "OBJECT.CFG:1: /MS/OPEN-R/MW/OBJS/PROBE.BIN has a global object whose constructor "
            "throws an exception: thrown early");
}

}  // namespace
}  // namespace openr_host

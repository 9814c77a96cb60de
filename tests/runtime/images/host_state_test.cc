// The state of the host and of other objects does not reach an object through the C library.
#include <gtest/gtest.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "tests/runtime/images/image_fixture.h"

namespace openr_host {
namespace {

using HostStateTest = ImageTest;

TEST_F(HostStateTest, ThereIsNoEnvironmentAndNoLocaleOfTheHost) {
  Start();
  ASSERT_NE(getenv("PATH"), nullptr);
  EXPECT_EQ(talker->Ask("environment"), "1");
  EXPECT_EQ(talker->Ask("locale"), "C C 1");
}

TEST_F(HostStateTest, LocalTimeIsUtc) {
  const char* const before = getenv("TZ");
  const std::string zone = before == nullptr ? "" : before;
  setenv("TZ", "XYZ-5:45", 1);
  tzset();
  Start();
  EXPECT_EQ(talker->Ask("local time"), "2001-09-09 01:46:40 GMT 1 Sun Sep  9 01:46:40 2001\n");
  if (before == nullptr) {
    unsetenv("TZ");
  } else {
    setenv("TZ", zone.c_str(), 1);
  }
  tzset();
}

TEST_F(HostStateTest, TheWallClockIsVirtualTime) {
  Start();
  EXPECT_EQ(talker->Ask("wall clock"), "1 0");
}

TEST_F(HostStateTest, RandomNumbersAreTheObjectsOwn) {
  Start();
  EXPECT_EQ(talker->Ask("numbers 48"), "851401618 -685110122 0.353336");
  drand48();
  Start();
  EXPECT_EQ(talker->Ask("numbers 48"), "851401618 -685110122 0.353336");
}

TEST_F(HostStateTest, StrtokGoesOnInTheObjectsOwnText) {
  Start();
  EXPECT_EQ(talker->Ask("words"), "one");
  char other[] = "a b";
  strtok(other, " ");
  EXPECT_EQ(talker->Ask("next word"), "two");
}

}  // namespace
}  // namespace openr_host

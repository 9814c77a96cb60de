#include "cli/colour.h"

#include <gmock/gmock.h>
#include <pty.h>
#include <unistd.h>

#include <cstdlib>

namespace openr_host {
namespace {

// A terminal, and an environment that allows colours.
class ColourTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(openpty(&reader_, &terminal_, nullptr, nullptr, nullptr), 0);
    setenv("TERM", "xterm", 1);
    unsetenv("NO_COLOR");
  }
  void TearDown() override {
    unsetenv("NO_COLOR");
    close(terminal_);
    close(reader_);
  }

  int reader_ = -1;
  int terminal_ = -1;
};

TEST_F(ColourTest, IsForTerminalsOnly) {
  EXPECT_TRUE(HasColours(terminal_));
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  EXPECT_FALSE(HasColours(ends[1]));
  close(ends[0]);
  close(ends[1]);
}

TEST_F(ColourTest, IsLeftOutWhenTheUserSaysSo) {
  setenv("NO_COLOR", "1", 1);
  EXPECT_FALSE(HasColours(terminal_));
  setenv("NO_COLOR", "", 1);  // set and empty means nothing (no-color.org)
  EXPECT_TRUE(HasColours(terminal_));
}

TEST_F(ColourTest, IsLeftOutOnATerminalThatHasNone) {
  setenv("TERM", "dumb", 1);
  EXPECT_FALSE(HasColours(terminal_));
  unsetenv("TERM");
  EXPECT_FALSE(HasColours(terminal_));
  setenv("TERM", "xterm", 1);
}

TEST_F(ColourTest, StandsAroundTheTextAndNotAroundNothing) {
  EXPECT_EQ(Coloured(Colour::kError, "bad", true), "\x1b[1;31mbad\x1b[0m");
  EXPECT_EQ(Coloured(Colour::kError, "bad", false), "bad");
  EXPECT_EQ(Coloured(Colour::kBold, "", true), "");
}

}  // namespace
}  // namespace openr_host

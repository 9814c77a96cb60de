#include "runtime/base/terminal_text.h"

#include <gtest/gtest.h>

#include <string>

namespace openr_host {
namespace {

TEST(TerminalTextTest, ControlBytesAreShownAsQuestionMarks) {
  EXPECT_EQ(TerminalText("a\x1b[2Jb\x07\r\x7f"), "a?[2Jb???");
  EXPECT_EQ(TerminalText(std::string("a\0b", 3)), "a?b");
}

TEST(TerminalTextTest, NewlinesAndTabsStay) {
  EXPECT_EQ(TerminalText("a\tb\nc\n"), "a\tb\nc\n");
  EXPECT_EQ(TerminalText("a\r\nb\rc\r"), "a\r\nb?c?");
  EXPECT_EQ(TerminalLine("a\r\nb"), "a??b");
  EXPECT_EQ(TerminalLine("a\tb\nc\n"), "a\tb?c?");
}

// U+009B begins a command of a terminal, as ESC [ does.
TEST(TerminalTextTest, Utf8StaysExceptItsControlCharacters) {
  EXPECT_EQ(TerminalText("gr\xc3\xbc\xc3\x9f \xc2\xb0"), "gr\xc3\xbc\xc3\x9f \xc2\xb0");
  EXPECT_EQ(TerminalText("a\xc2\x9b"
                         "2J\xc2"),
            "a??2J\xc2");
}

}  // namespace
}  // namespace openr_host

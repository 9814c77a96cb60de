#include "runtime/config/diagnostic.h"

#include <gtest/gtest.h>

namespace openr_host::diagnostic_test {
namespace {

TEST(DiagnosticTest, ErrorShowsFileLineMessageTextAndCaret) {
  EXPECT_EQ(Render(ErrorAt(FilePosition{"A.CFG", 3, 5, "one two"}, "no such word")),
            "A.CFG:3: no such word\n"
            "one two\n"
            "    ^");
}

TEST(DiagnosticTest, WarningSaysThatItIsOne) {
  EXPECT_EQ(Render(WarningAt(FilePosition{"A.CFG", 3, 1, "one"}, "odd")),
            "A.CFG:3: warning: odd\n"
            "one\n"
            "^");
}

TEST(DiagnosticTest, AFindingHasASeverityOfItsOwn) {
  EXPECT_EQ(RenderWithoutKind(WarningAt(FilePosition{"A.CFG", 3, 1, "one"}, "odd")),
            "A.CFG:3: odd\n"
            "one\n"
            "^");
}

TEST(DiagnosticTest, CaretCanStandBehindTheEndOfTheLine) {
  EXPECT_EQ(Render(ErrorAt(FilePosition{"A.CFG", 1, 6, "one"}, "more is missing")),
            "A.CFG:1: more is missing\n"
            "one\n"
            "     ^");
}

TEST(DiagnosticTest, TabsInTheLineKeepTheCaretUnderItsColumn) {
  EXPECT_EQ(Render(ErrorAt(FilePosition{"A.CFG", 1, 3, "\ta\tb"}, "m")),
            "A.CFG:1: m\n"
            "\ta\tb\n"
            "\t ^");
}

TEST(DiagnosticTest, Utf8CharacterIsOneColumnWide) {
  EXPECT_EQ(Render(ErrorAt(FilePosition{"A.CFG", 1, 5, "\xc3\xa4\xc3\xb6x"}, "m")),
            "A.CFG:1: m\n"
            "\xc3\xa4\xc3\xb6x\n"
            "  ^");
}

TEST(DiagnosticTest, ControlBytesNeverReachTheTerminal) {
  EXPECT_EQ(Render(ErrorAt(FilePosition{"A.CFG", 1, 0, "a\x1b[2Jb"}, "m")), "A.CFG:1: m\na?[2Jb");
}

TEST(DiagnosticTest, ControlBytesOfAWordInTheMessageDoNotEither) {
  EXPECT_EQ(Render(ErrorAt(FilePosition{"A.CFG", 1, 0, "ab"}, "no key 'a\x1b[2Jb'")),
            "A.CFG:1: no key 'a?[2Jb'\nab");
  EXPECT_EQ(Render(ErrorAt(FilePosition{"A.CFG", 0, 0, ""}, "no key '\x1b'")), "A.CFG: no key '?'");
}

TEST(DiagnosticTest, ControlBytesOfTheNameOfTheFileDoNotEither) {
  EXPECT_EQ(Render(ErrorAt(FilePosition{"a\x1b[2Jb", 0, 0, ""}, "m")), "a?[2Jb: m");
  EXPECT_EQ(Render(ErrorAt(FilePosition{"a\x1b[2Jb", 1, 0, "x"}, "m")), "a?[2Jb:1: m\nx");
}

TEST(DiagnosticTest, WithoutLineOnlyTheFileIsNamed) {
  EXPECT_EQ(Render(ErrorAt(FilePosition{"A.CFG", 0, 0, ""}, "is empty")), "A.CFG: is empty");
}

TEST(DiagnosticTest, SeveralAreRenderedOneAfterTheOther) {
  const FilePosition place{"A", 0, 0, ""};
  EXPECT_EQ(Render({ErrorAt(place, "x"), WarningAt(place, "y")}), "A: x\nA: warning: y\n");
}

TEST(DiagnosticTest, WarningsAloneAreNotErrors) {
  EXPECT_FALSE(HasErrors({WarningAt(FilePosition{}, "x")}));
}

TEST(DiagnosticTest, OneErrorAmongWarningsIsFound) {
  EXPECT_TRUE(HasErrors({WarningAt(FilePosition{}, "x"), ErrorAt(FilePosition{}, "y")}));
}

}  // namespace
}  // namespace openr_host::diagnostic_test

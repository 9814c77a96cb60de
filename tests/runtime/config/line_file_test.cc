#include "runtime/config/line_file.h"

#include <gtest/gtest.h>

namespace openr_host::line_file_test {
namespace {

// Returns the first words of the records that hold for `design`.
std::vector<std::string> FirstWords(std::string_view text, std::string_view design = "ERS-210") {
  std::vector<Diagnostic> diagnostics;
  std::vector<std::string> words;
  for (const RecordLine& line : ReadRecords("A.CFG", text, design, &diagnostics)) {
    words.push_back(line.words[0].text);
  }
  return words;
}

std::string Problems(std::string_view text) {
  std::vector<Diagnostic> diagnostics;
  ReadRecords("A.CFG", text, "ERS-210", &diagnostics);
  return Render(diagnostics);
}

using Words = std::vector<std::string>;

TEST(LineFileTest, EmptyFileHasNoRecords) {
  EXPECT_EQ(FirstWords(""), Words{});
  EXPECT_EQ(Problems(""), "");
}

TEST(LineFileTest, CommentsAndBlankLinesAreNoRecords) {
  EXPECT_EQ(FirstWords("# one\n\n \t \na\n  # two\nb\n"), (Words{"a", "b"}));
}

TEST(LineFileTest, LinesMayEndInCrLf) {
  EXPECT_EQ(FirstWords("a\r\n\r\nb\r\n"), (Words{"a", "b"}));
}

TEST(LineFileTest, LastLineNeedsNoNewline) {
  EXPECT_EQ(FirstWords("a\nb"), (Words{"a", "b"}));
  EXPECT_EQ(FirstWords("a\r\nb\r"), (Words{"a", "b"}));
}

TEST(LineFileTest, BlanksAndTabsSeparateAndMayTrail) {
  const std::vector<Word> words = SplitWords("\ta  b\t\tc \t");
  ASSERT_EQ(words.size(), 3u);
  EXPECT_EQ(words[0].text, "a");
  EXPECT_EQ(words[1].text, "b");
  EXPECT_EQ(words[2].text, "c");
  EXPECT_EQ(words[2].column, 8);
}

TEST(LineFileTest, RecordKnowsItsLineColumnAndText) {
  std::vector<Diagnostic> diagnostics;
  const auto records = ReadRecords("A.CFG", "#\r\n  a b \r\n", "ERS-210", &diagnostics);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].place.file, "A.CFG");
  EXPECT_EQ(records[0].place.line, 2);
  EXPECT_EQ(records[0].place.column, 3);
  EXPECT_EQ(records[0].place.text, "  a b ");
}

constexpr std::string_view kSections = "all\n[ERS-210]\ndog\n[ERS-220]\nbot\n[ERS-210]\ndog2\n";

TEST(LineFileTest, RecordsOfTheRobotAndThoseBeforeTheFirstSectionHold) {
  EXPECT_EQ(FirstWords(kSections, "ERS-210"), (Words{"all", "dog", "dog2"}));
  EXPECT_EQ(FirstWords(kSections, "ERS-220"), (Words{"all", "bot"}));
}

TEST(LineFileTest, UnknownRobotGetsOnlyTheCommonRecords) {
  EXPECT_EQ(FirstWords(kSections, "ERS-7"), (Words{"all"}));
}

TEST(LineFileTest, EveryDesignGetsAllRecords) {
  EXPECT_EQ(FirstWords(kSections, kEveryDesign), (Words{"all", "dog", "bot", "dog2"}));
}

TEST(LineFileTest, SectionHeaderMayHaveBlanksAroundAndInside) {
  EXPECT_EQ(FirstWords("  [ ERS-220 ] \r\nbot\r\n"), Words{});
  EXPECT_EQ(Problems("  [ ERS-220 ] \r\nbot\r\n"), "");
}

TEST(LineFileTest, SectionOfARobotOfOnesOwnIsNoMistake) { EXPECT_EQ(Problems("[MYDOG]\nx\n"), ""); }

TEST(LineFileTest, SectionInOtherCaseHoldsWithAWarning) {
  EXPECT_EQ(FirstWords("[ers-210]\ndog\n"), Words{"dog"});
  EXPECT_EQ(Problems("[ers-210]\ndog\n"),
            "A.CFG:1: warning: section [ers-210] is read as [ERS-210]; write [ERS-210], the robot "
            "may not ignore case\n[ers-210]\n^\n");
}

TEST(LineFileTest, MisspeltSectionIsPointedOut) {
  EXPECT_EQ(Problems("[ERS210]\ndog\n"),
            "A.CFG:1: warning: no robot design 'ERS210' is known; did you mean 'ERS-210'?\n"
            "[ERS210]\n^\n");
}

TEST(LineFileTest, SectionWithoutBracketIsReadAsMeant) {
  EXPECT_EQ(FirstWords("[ERS-220\nbot\n"), Words{});
  EXPECT_EQ(Problems("[ERS-220\nbot\n"),
            "A.CFG:1: section header without ']'; write [ERS-220] (read so here)\n"
            "[ERS-220\n^\n");
}

TEST(LineFileTest, NothingMayFollowASectionHeader) {
  EXPECT_EQ(FirstWords("[ERS-220]  bot\nbot2\n"), Words{});
  EXPECT_EQ(Problems("[ERS-220]  bot\n"),
            "A.CFG:1: nothing may follow a section header; write this on a line of its own\n"
            "[ERS-220]  bot\n"
            "           ^\n");
}

TEST(LineFileTest, RecordsOfANamelessSectionAreSkipped) {
  EXPECT_EQ(FirstWords("a\n[]\nb\n[ERS-210]\nc\n"), (Words{"a", "c"}));
  EXPECT_EQ(Problems("[ ]\nb\n"),
            "A.CFG:1: section without a robot design; its records are skipped\n[ ]\n^\n");
}

TEST(LineFileTest, LineWithNulIsSkippedAndOthersHold) {
  const std::string text("a\nb\0c\nd\n", 8);
  EXPECT_EQ(FirstWords(text), (Words{"a", "d"}));
  EXPECT_EQ(Problems(text),
            "A.CFG:2: NUL byte in the line; skipped; is this a binary or a UTF-16 file?\n"
            "(not shown)\n");
}

TEST(LineFileTest, BinaryFileGivesOneProblemNotThousands) {
  std::string text;
  for (int i = 0; i < 3000; ++i) text += std::string("\0\x7f\n", 3);
  EXPECT_EQ(Problems(text),
            "A.CFG:1: NUL byte in the line; skipped, as 2999 more; is this a binary or a UTF-16 "
            "file?\n(not shown)\n");
}

TEST(LineFileTest, LineOfTheGreatestLengthHolds) {
  EXPECT_EQ(FirstWords(std::string(kLineBytesMax, 'x')).size(), 1u);
}

TEST(LineFileTest, OverlongLineIsSkippedAndNotShownWhole) {
  const std::string text = "a\n" + std::string(1025, 'x') + "\nb\n";
  EXPECT_EQ(FirstWords(text), (Words{"a", "b"}));
  EXPECT_EQ(Problems(text), "A.CFG:2: line of 1025 bytes, the limit is 1024; skipped\n" +
                                std::string(60, 'x') + "...\n");
}

TEST(LineFileTest, ByteOrderMarkIsDroppedWithAWarning) {
  EXPECT_EQ(FirstWords("\xef\xbb\xbf"
                       "a\n"),
            Words{"a"});
  EXPECT_EQ(Problems("\xef\xbb\xbf"
                     "a\n"),
            "A.CFG: warning: starts with a UTF-8 byte order mark, which the robot would read as "
            "part of the first line; save it without\n");
}

TEST(LineFileTest, ControlByteInARecordIsRefused) {
  EXPECT_EQ(FirstWords("a\nb\x1a\nc\n"), (Words{"a", "c"}));
  EXPECT_EQ(Problems("b\x1a\n"),
            "A.CFG:1: byte 0x1a in a record; only text, blanks and tabs are allowed\nb?\n ^\n");
}

TEST(LineFileTest, CommentsMayHoldAnyByteButNul) {
  EXPECT_EQ(Problems("# \x1b$B \x93\xfa\x96\x7b\n"), "");
}

}  // namespace
}  // namespace openr_host::line_file_test

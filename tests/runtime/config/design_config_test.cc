#include "runtime/config/design_config.h"

#include <gtest/gtest.h>

#include "runtime/config/line_file.h"

namespace openr_host::design_config_test {
namespace {

DesignConfig Parse(std::string_view text, std::string_view design = "ERS-210") {
  return ParseDesignConfig("DESIGNDB.CFG", text, design);
}

std::string ErrorIn(std::string_view text) {
  const DesignConfig config = Parse(text);
  return config.diagnostics.empty() ? "" : Render(config.diagnostics[0]);
}

TEST(DesignConfigTest, KeywordAndPathAreRead) {
  const DesignConfig config = Parse("# data\r\nBOW\t/MS/OPEN-R/MW/DATA/P/BOW.MTN\r\n");
  ASSERT_EQ(config.designs.size(), 1u);
  EXPECT_EQ(config.designs[0].keyword, "BOW");
  EXPECT_EQ(config.designs[0].path, "/MS/OPEN-R/MW/DATA/P/BOW.MTN");
  EXPECT_EQ(config.designs[0].path_place.column, 5);
  EXPECT_TRUE(config.diagnostics.empty());
}

TEST(DesignConfigTest, KeywordMayNameOneFilePerRobot) {
  const std::string_view text = "[ERS-210]\nBOW /MS/A.MTN\n[ERS-220]\nBOW /MS/B.MTN\n";
  ASSERT_EQ(Parse(text, "ERS-220").designs.size(), 1u);
  EXPECT_EQ(Parse(text, "ERS-220").designs[0].path, "/MS/B.MTN");
  EXPECT_TRUE(Parse(text, kEveryDesign).diagnostics.empty());
}

TEST(DesignConfigTest, LoneKeywordIsRefused) {
  EXPECT_EQ(ErrorIn("BOW\n"),
            "DESIGNDB.CFG:1: 'BOW' stands alone; write a keyword and a path, separated by a blank\n"
            "BOW\n"
            "^");
}

TEST(DesignConfigTest, ThirdWordIsRefused) {
  EXPECT_EQ(ErrorIn("BOW /MS/BOW.MTN bow\n"),
            "DESIGNDB.CFG:1: 'bow' after the path; a line holds one keyword and one path\n"
            "BOW /MS/BOW.MTN bow\n"
            "                ^");
}

TEST(DesignConfigTest, PathMustBeOnTheStick) {
  EXPECT_EQ(ErrorIn("BOW BOW.MTN\n"),
            "DESIGNDB.CFG:1: data path 'BOW.MTN' does not begin with /MS/, the root of the Memory "
            "Stick\n"
            "BOW BOW.MTN\n"
            "    ^");
}

TEST(DesignConfigTest, KeywordTwiceKeepsTheFirstPath) {
  const std::string_view text = "BOW /MS/A.MTN\nBOW /MS/B.MTN\n";
  ASSERT_EQ(Parse(text).designs.size(), 1u);
  EXPECT_EQ(Parse(text).designs[0].path, "/MS/A.MTN");
  EXPECT_EQ(ErrorIn(text),
            "DESIGNDB.CFG:2: warning: keyword 'BOW' is given already in line 1, which holds\n"
            "BOW /MS/B.MTN\n"
            "^");
}

TEST(DesignConfigTest, KeywordAnsweredByTheSystemHasNoEffect) {
  EXPECT_EQ(Parse("SYS_CPUINFO /MS/A.DAT\n").designs.size(), 0u);
  EXPECT_EQ(ErrorIn("SYS_CPUINFO /MS/A.DAT\n"),
            "DESIGNDB.CFG:1: warning: 'SYS_CPUINFO' is answered by the system itself; the line has "
            "no effect\n"
            "SYS_CPUINFO /MS/A.DAT\n"
            "^");
}

TEST(DesignConfigTest, OverlongKeywordIsRefused) {
  EXPECT_EQ(Parse(std::string(127, 'K') + " /MS/A.DAT\n").designs.size(), 1u);
  const std::string line = std::string(128, 'K') + " /MS/A.DAT";
  EXPECT_EQ(ErrorIn(line),
            "DESIGNDB.CFG:1: keyword of 128 characters, the limit is 127\n" + line + "\n^");
}

}  // namespace
}  // namespace openr_host::design_config_test

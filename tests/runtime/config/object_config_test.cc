#include "runtime/config/object_config.h"

#include <gtest/gtest.h>

#include "runtime/config/line_file.h"

namespace openr_host::object_config_test {
namespace {

std::vector<std::string> Paths(std::string_view text, std::string_view design = "ERS-210") {
  std::vector<std::string> paths;
  for (const ObjectRecord& object : ParseObjectConfig("OBJECT.CFG", text, design).objects) {
    paths.push_back(object.path);
  }
  return paths;
}

std::string Problems(std::string_view text, std::string_view design = "ERS-210") {
  return Render(ParseObjectConfig("OBJECT.CFG", text, design).diagnostics);
}

using List = std::vector<std::string>;

TEST(ObjectConfigTest, PathsComeInFileOrder) {
  EXPECT_EQ(Paths("# objects\r\n/MS/OPEN-R/MW/OBJS/POWERMON.BIN\r\n/MS/OPEN-R/MW/OBJS/A.BIN"),
            (List{"/MS/OPEN-R/MW/OBJS/POWERMON.BIN", "/MS/OPEN-R/MW/OBJS/A.BIN"}));
}

TEST(ObjectConfigTest, RecordKeepsItsPlace) {
  const auto config = ParseObjectConfig("OBJECT.CFG", "\n /MS/A.BIN \n", "ERS-210");
  ASSERT_EQ(config.objects.size(), 1u);
  EXPECT_EQ(config.objects[0].place.line, 2);
  EXPECT_EQ(config.objects[0].place.column, 2);
}

TEST(ObjectConfigTest, OnlySectionsOfTheRobotHold) {
  constexpr std::string_view kText = "/MS/A.BIN\n[ERS-220]\n/MS/B.BIN\n[ERS-210]\n/MS/C.BIN\n";
  EXPECT_EQ(Paths(kText, "ERS-210"), (List{"/MS/A.BIN", "/MS/C.BIN"}));
  EXPECT_EQ(Paths(kText, "ERS-220"), (List{"/MS/A.BIN", "/MS/B.BIN"}));
}

TEST(ObjectConfigTest, LowerCaseIsAsGoodAsUpperCase) {
  EXPECT_EQ(Paths("/ms/open-r/mw/objs/vision.bin\n"), (List{"/ms/open-r/mw/objs/vision.bin"}));
  EXPECT_EQ(Problems("/ms/open-r/mw/objs/vision.bin\n"), "");
}

TEST(ObjectConfigTest, PathOutsideTheStickIsRefused) {
  EXPECT_EQ(Problems("/home/dog/A.BIN\n"),
            "OBJECT.CFG:1: object path '/home/dog/A.BIN' does not begin with /MS/, the root of the "
            "Memory Stick\n/home/dog/A.BIN\n^\n");
}

TEST(ObjectConfigTest, PathThatLacksTheRootGetsASuggestion) {
  EXPECT_EQ(Problems(" OPEN-R/MW/OBJS/A.BIN\n"),
            "OBJECT.CFG:1: object path 'OPEN-R/MW/OBJS/A.BIN' does not begin with /MS/, the root "
            "of the Memory Stick; did you mean '/MS/OPEN-R/MW/OBJS/A.BIN'?\n"
            " OPEN-R/MW/OBJS/A.BIN\n ^\n");
}

TEST(ObjectConfigTest, BackslashesAreRefusedWithTheRightPath) {
  EXPECT_EQ(Problems("/MS\\A.BIN\n"),
            "OBJECT.CFG:1: object path '/MS\\A.BIN' has a backslash; did you mean '/MS/A.BIN'?\n"
            "/MS\\A.BIN\n"
            "   ^\n");
}

TEST(ObjectConfigTest, DotsCannotLeaveTheStick) {
  EXPECT_EQ(Problems("/MS/../A.BIN\n"),
            "OBJECT.CFG:1: object path '/MS/../A.BIN' has a part that is only dots; write the "
            "whole path\n/MS/../A.BIN\n    ^\n");
}

TEST(ObjectConfigTest, FolderIsNoObject) {
  EXPECT_EQ(Problems("/MS/OPEN-R/\n"),
            "OBJECT.CFG:1: object path '/MS/OPEN-R/' has an empty part; write the whole path\n"
            "/MS/OPEN-R/\n"
            "           ^\n");
}

TEST(ObjectConfigTest, CommentAfterThePathIsAWarning) {
  EXPECT_EQ(Paths("/MS/A.BIN # mover\n"), List{"/MS/A.BIN"});
  EXPECT_EQ(
      Problems("/MS/A.BIN # mover\n"),
      "OBJECT.CFG:1: warning: a comment has a line of its own; this one is not read here, the "
      "robot may take it for a part of the record\n"
      "/MS/A.BIN # mover\n"
      "          ^\n");
}

TEST(ObjectConfigTest, SecondPathIsRefused) {
  EXPECT_EQ(Paths("/MS/A.BIN /MS/B.BIN\n"), List{});
  EXPECT_EQ(Problems("/MS/A.BIN /MS/B.BIN\n"),
            "OBJECT.CFG:1: '/MS/B.BIN' after the path; a line holds one path\n"
            "/MS/A.BIN /MS/B.BIN\n"
            "          ^\n");
}

TEST(ObjectConfigTest, NameLongerThanTheRobotCanHoldIsAWarning) {
  EXPECT_EQ(Paths("/MS/JOINTMOVER.BIN\n"), List{"/MS/JOINTMOVER.BIN"});
  EXPECT_EQ(Problems("/MS/JOINTMOVER.BIN\n"),
            "OBJECT.CFG:1: warning: 'JOINTMOVER.BIN' is not an 8.3 name; the robot cannot open it\n"
            "/MS/JOINTMOVER.BIN\n"
            "    ^\n");
}

TEST(ObjectConfigTest, PathListedTwiceIsLoadedOnce) {
  EXPECT_EQ(Paths("/MS/A.BIN\n/ms/a.bin\n"), List{"/MS/A.BIN"});
  EXPECT_EQ(Problems("/MS/A.BIN\n/ms/a.bin\n"),
            "OBJECT.CFG:2: warning: '/ms/a.bin' is listed already in line 1; it is loaded once\n"
            "/ms/a.bin\n^\n");
}

TEST(ObjectConfigTest, SamePathForTwoRobotsIsNoRepetition) {
  constexpr std::string_view kText = "[ERS-210]\n/MS/A.BIN\n[ERS-220]\n/MS/A.BIN\n";
  EXPECT_EQ(Problems(kText, kEveryDesign), "");
  EXPECT_EQ(Paths(kText, kEveryDesign).size(), 2u);
}

TEST(ObjectConfigTest, LinesAroundABadOneHold) {
  EXPECT_EQ(Paths("/MS/A.BIN\nB.BIN\n/MS/C.BIN\n"), (List{"/MS/A.BIN", "/MS/C.BIN"}));
}

}  // namespace
}  // namespace openr_host::object_config_test

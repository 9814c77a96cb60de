#include "runtime/config/connect_config.h"

#include <gtest/gtest.h>

#include "runtime/config/line_file.h"

namespace openr_host::connect_config_test {
namespace {

ConnectConfig Parse(std::string_view text, std::string_view design = "ERS-210") {
  return ParseConnectConfig("CONNECT.CFG", text, design);
}

// Returns the first message about `text`.
std::string ErrorIn(std::string_view text) {
  const ConnectConfig config = Parse(text);
  return config.diagnostics.empty() ? "" : Render(config.diagnostics[0]);
}

TEST(ConnectConfigTest, SubjectAndObserverAreConnectedInFileOrder) {
  const ConnectConfig config = Parse("A.x.T.S B.y.T.O\r\n\tC.x.U.S\tB.z.U.O  ");
  ASSERT_EQ(config.connections.size(), 2u);
  EXPECT_EQ(Compose(config.connections[0].subject), "A.x.T.S");
  EXPECT_EQ(Compose(config.connections[0].observer), "B.y.T.O");
  EXPECT_EQ(Compose(config.connections[1].subject), "C.x.U.S");
  EXPECT_TRUE(config.diagnostics.empty());
}

TEST(ConnectConfigTest, RecordKnowsWhereBothNamesStand) {
  const ConnectConfig config = Parse("#\nA.x.T.S B.y.T.O\n");
  ASSERT_EQ(config.connections.size(), 1u);
  EXPECT_EQ(config.connections[0].subject_place.line, 2);
  EXPECT_EQ(config.connections[0].subject_place.column, 1);
  EXPECT_EQ(config.connections[0].observer_place.column, 9);
}

TEST(ConnectConfigTest, OneServiceMayHaveManyConnections) {
  EXPECT_EQ(Parse("A.x.T.S B.y.T.O\nA.x.T.S C.y.T.O\nD.x.T.S B.y.T.O\n").connections.size(), 3u);
}

TEST(ConnectConfigTest, ObjectMayBeConnectedToItself) {
  EXPECT_EQ(Parse("A.x.T.S A.x.T.O\n").connections.size(), 1u);
}

TEST(ConnectConfigTest, OnlySectionsOfTheRobotHold) {
  EXPECT_EQ(Parse("[ERS-7]\nA.x.T.S B.y.T.O\n").connections.size(), 0u);
  EXPECT_EQ(Parse("[ERS-7]\nA.x.T.S B.y.T.O\n", "ERS-7").connections.size(), 1u);
}

TEST(ConnectConfigTest, DataTypesOfSubjectAndObserverMustAgree) {
  EXPECT_EQ(ErrorIn("RCServer.Move.MoveCommand.S JointMover.Move.SensorFrame.O\n"),
            "CONNECT.CFG:1: subject sends 'MoveCommand', observer expects 'SensorFrame' "
            "(the line is skipped)\n"
            "RCServer.Move.MoveCommand.S JointMover.Move.SensorFrame.O\n"
            "                            ^");
}

TEST(ConnectConfigTest, DataTypesAreComparedWithCase) {
  EXPECT_EQ(Parse("A.x.T.S B.y.t.O\n").connections.size(), 0u);
}

TEST(ConnectConfigTest, LinesAroundABadOneHold) {
  EXPECT_EQ(Parse("A.x.T.S B.y.T.O\nA.x.T.S B.y.U.O\nA.z.T.S B.y.T.O\n").connections.size(), 2u);
}

TEST(ConnectConfigTest, SwappedNamesAreRecognised) {
  EXPECT_EQ(ErrorIn("B.y.T.O A.x.T.S\n"),
            "CONNECT.CFG:1: observer first, subject second; swap the two, the subject comes first "
            "(the line is skipped)\n"
            "B.y.T.O A.x.T.S\n"
            "^");
}

TEST(ConnectConfigTest, TwoObserversAreRefused) {
  EXPECT_EQ(ErrorIn("B.y.T.O A.x.T.O\n"),
            "CONNECT.CFG:1: 'B.y.T.O' is an observer; the first service of a line is a subject "
            "(the line is skipped)\n"
            "B.y.T.O A.x.T.O\n"
            "^");
}

TEST(ConnectConfigTest, TwoSubjectsAreRefused) {
  EXPECT_EQ(ErrorIn("A.x.T.S B.y.T.S\n"),
            "CONNECT.CFG:1: 'B.y.T.S' is a subject; the second service of a line is an observer "
            "(the line is skipped)\n"
            "A.x.T.S B.y.T.S\n"
            "        ^");
}

TEST(ConnectConfigTest, LoneNameIsRefused) {
  EXPECT_EQ(ErrorIn("A.x.T.S\n"),
            "CONNECT.CFG:1: 'A.x.T.S' stands alone; write a subject and an observer, separated by "
            "a blank (the line is skipped)\n"
            "A.x.T.S\n"
            "^");
}

TEST(ConnectConfigTest, CommentAfterTheNamesIsAWarning) {
  EXPECT_EQ(Parse("A.x.T.S B.y.T.O #arm\n").connections.size(), 1u);
  EXPECT_EQ(ErrorIn("A.x.T.S B.y.T.O #arm\n"),
            "CONNECT.CFG:1: warning: a comment has a line of its own; this one is not read here, "
            "the robot may take it for a part of the record\n"
            "A.x.T.S B.y.T.O #arm\n"
            "                ^");
}

TEST(ConnectConfigTest, ThirdServiceIsRefused) {
  EXPECT_EQ(ErrorIn("A.x.T.S B.y.T.O C.y.T.O\n"),
            "CONNECT.CFG:1: 'C.y.T.O' after the two services; a line holds one subject and one "
            "observer (the line is skipped)\n"
            "A.x.T.S B.y.T.O C.y.T.O\n"
            "                ^");
}

TEST(ConnectConfigTest, CaretStandsUnderTheFaultyPartOfAName) {
  EXPECT_EQ(ErrorIn("A.x.T.S B.y.T.o\n"),
            "CONNECT.CFG:1: 'B.y.T.o' ends in '.o'; a subject ends in '.S', an observer in '.O'; "
            "did you mean '.O'? (the line is skipped)\n"
            "A.x.T.S B.y.T.o\n"
            "              ^");
}

TEST(ConnectConfigTest, BothNamesOfALineAreChecked) {
  EXPECT_EQ(Parse("A.x.S B.y.O\n").diagnostics.size(), 2u);
}

TEST(ConnectConfigTest, NameOfTheGreatestLengthHolds) {
  const std::string object(127 - 6, 'A');
  EXPECT_EQ(Parse(object + ".x.T.S B.y.T.O\n").connections.size(), 1u);
}

TEST(ConnectConfigTest, OverlongNameIsRefused) {
  const std::string line = std::string(122, 'A') + ".x.T.S B.y.T.O";
  EXPECT_EQ(
      ErrorIn(line),
      "CONNECT.CFG:1: service name of 128 characters, the limit is 127 (the line is skipped)\n" +
          line + "\n^");
}

TEST(ConnectConfigTest, SamePairTwiceIsConnectedOnce) {
  const std::string_view text = "A.x.T.S B.y.T.O\nA.x.T.S  B.y.T.O\n";
  EXPECT_EQ(Parse(text).connections.size(), 1u);
  EXPECT_EQ(ErrorIn(text),
            "CONNECT.CFG:2: warning: these two are connected already in line 1; connected once\n"
            "A.x.T.S  B.y.T.O\n"
            "^");
}

TEST(ConnectConfigTest, SamePairForTwoRobotsIsNoRepetition) {
  const std::string_view text = "[ERS-210]\nA.x.T.S B.y.T.O\n[ERS-7]\nA.x.T.S B.y.T.O\n";
  EXPECT_TRUE(Parse(text, kEveryDesign).diagnostics.empty());
}

}  // namespace
}  // namespace openr_host::connect_config_test

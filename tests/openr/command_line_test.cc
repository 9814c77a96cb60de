// What the program refuses, and how.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

// Expects exit status `status`, nothing on standard output, and `text` on standard error.
void ExpectRefusal(const std::vector<std::string>& arguments, int status, const std::string& text) {
  const ProgramResult result = RunProgram(arguments);
  EXPECT_EQ(result.status, status) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
}

TEST(CommandLineTest, WithoutACommandItSaysSo) { ExpectRefusal({}, 2, "subcommand is required"); }

TEST(CommandLineTest, UnknownFlagsAreRefused) {
  ExpectRefusal({"run", "--nonsense"}, 2, "--nonsense");
}

TEST(CommandLineTest, HelpIsGood) {
  const ProgramResult result = RunProgram({"run", "--help"});
  EXPECT_EQ(result.status, 0);
  EXPECT_NE(result.out.find("--until-idle"), std::string::npos);
}

TEST(CommandLineTest, VersionIsOneJsonObject) {
  const ProgramResult result = RunProgram({"version", "--json"});
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(nlohmann::json::parse(result.out).contains("version"));
}

TEST(CommandLineTest, ThereIsNoPanelYet) {
  ExpectRefusal({"run", "--panel"}, 2, "no web panel in this version");
  ExpectRefusal({"run", "--panel", "127.0.0.1:8210"}, 2, "no web panel in this version");
}

TEST(CommandLineTest, DurationsNeedAUnit) {
  ExpectRefusal({"run", "--for", "20"}, 2, "'20' has no unit; write 20s or 20ms");
}

TEST(CommandLineTest, RatesAreNumbersOrMax) {
  ExpectRefusal({"run", "--rate", "fast"}, 2, "'fast' is neither 'max' nor a number");
  ExpectRefusal({"run", "--rate", "0"}, 2, "'0' is neither 'max' nor a number");
}

TEST(CommandLineTest, APictureNeedsAFile) {
  ExpectRefusal({"run", "--snapshot", "t=1s"}, 2, "1 given, with 0 files (-o FILE)");
}

TEST(CommandLineTest, APictureOfARobotThatIsNotThereIsRefused) {
  ExpectRefusal({"run", "--snapshot", "robot=1", "-o", "a.png"}, 2, "there is no robot 1");
}

TEST(CommandLineTest, AFolderThatIsNoStickIsRefused) {
  const ScratchFolder folder;
  ExpectRefusal({"run", "--stick", folder.path()}, 1, "holds no folder OPEN-R");
}

TEST(CommandLineTest, AStickWithoutObjectsIsRefused) {
  const ScratchFolder folder;
  folder.Write("OPEN-R/MW/CONF/CONNECT.CFG", "");
  ExpectRefusal({"run", "--stick", folder.path(), "--no-panel"}, 1, "OBJECT.CFG: No such file");
}

TEST(CommandLineTest, AWorldThatCannotBeReadIsRefused) {
  ExpectRefusal({"run", "--world", "nowhere.json"}, 1, "nowhere.json");
}

TEST(CommandLineTest, UnknownRobotsAreRefused) {
  ExpectRefusal({"run", "--robot", "ers1000"}, 2, "ers1000");
}

TEST(CommandLineTest, AMotionThatCannotBeReadIsNamed) {
  ExpectRefusal({"mtn", "info", "nowhere.mtn"}, 1, "nowhere.mtn: cannot be read");
}

TEST(CommandLineTest, AFileThatIsNoMotionIsRefusedWithSectionAndOffset) {
  const ScratchFolder folder;
  folder.Write("a.mtn", "this is no motion file at all, whatever its name says it is");
  ExpectRefusal({"mtn", "check", folder.File("a.mtn")}, 1, "offset 0");
}

TEST(CommandLineTest, TheMotionsOfTheStickPlay) {
  const ProgramResult result = RunProgram(
      {"mtn", "check", "--json", std::string(OPENR_STICK) + "/OPEN-R/MW/DATA/P/SIT.MTN"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(nlohmann::json::parse(result.out)["plays"], true);
}

TEST(CommandLineTest, NobodyAtThePortIsExplained) {
  // Port 1 of loopback: no service of that kind runs there.
  ExpectRefusal({"rc", "127.0.0.1:1", "info"}, 1, "nobody listens there; is 'openr run' running");
}

TEST(CommandLineTest, APortThatIsNoNumberIsRefused) {
  ExpectRefusal({"rc", "127.0.0.1:door", "info"}, 2, "has no port from 1 to 65535");
}

TEST(CommandLineTest, LightsAreOnOrOff) {
  ExpectRefusal({"rc", "127.0.0.1:1", "led", "0", "maybe"}, 2, "maybe");
}

}  // namespace
}  // namespace openr_host

// Tests of the messages of openr run about a stick whose configuration is wrong.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

ProgramResult RunStick(const ScratchFolder& stick, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"run",       "--for", "100ms",   "--rate",    "max",
                                     "--rc-port", "0",     "--stick", stick.path()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return RunProgram(arguments);
}

void ExpectSaid(const ProgramResult& result, const std::string& text) {
  EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
}

TEST(StickFaultsTest, AMissingImageGetsTheNearestFileAsASuggestion) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  stick.Write("OPEN-R/MW/CONF/OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/TROUBEL.BIN\n");
  const ProgramResult result = RunStick(stick);
  EXPECT_EQ(result.status, 1);
  ExpectSaid(result, "OBJECT.CFG:1: /MS/OPEN-R/MW/OBJS/TROUBEL.BIN does not exist on the stick");
  ExpectSaid(result, "did you mean 'TROUBLE.BIN'?");
  ExpectSaid(result, "openr: the robot does not boot");
}

TEST(StickFaultsTest, ALineOfWiringThatCannotBeReadIsSaidToBeSkipped) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", "Trouble.Out.Text.S\n");
  const ProgramResult result = RunStick(stick);
  EXPECT_EQ(result.status, 1);
  ExpectSaid(result, "error: CONNECT.CFG:1: 'Trouble.Out.Text.S' stands alone");
  ExpectSaid(result, "(the line is skipped)\n");
  ExpectSaid(result, "Trouble is running");
}

TEST(StickFaultsTest, StrictlyNothingStartsThenAndThatIsSaid) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", "Trouble.Out.Text.S\n");
  const ProgramResult result = RunStick(stick, {"--strict"});
  EXPECT_EQ(result.status, 1);
  ExpectSaid(result, "(--strict: no object starts)\n");
  EXPECT_EQ(result.err.find("skipped"), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find("Trouble is running"), std::string::npos) << result.err;
}

TEST(StickFaultsTest, AMissingConnectConfigIsAWarningAndStrictlyAnError) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  std::filesystem::remove(stick.File("OPEN-R/MW/CONF/CONNECT.CFG"));
  const ProgramResult result = RunStick(stick);
  EXPECT_EQ(result.status, 0);
  ExpectSaid(result, "note: /MS/OPEN-R/MW/CONF/CONNECT.CFG: No such file on the stick");
  ExpectSaid(result, "Trouble is running");
  const ProgramResult strict = RunStick(stick, {"--strict", "--json"});
  EXPECT_EQ(strict.status, 0);
  ExpectSaid(strict, "note: /MS/OPEN-R/MW/CONF/CONNECT.CFG: No such file on the stick");
  ExpectSaid(strict, "Trouble is running");
  EXPECT_EQ(nlohmann::json::parse(strict.out)["findings"].at(0)["severity"], "note");
}

// Opening it would wait for somebody to write.
TEST(StickFaultsTest, AFifoInPlaceOfConnectConfigDoesNotHoldTheRunUp) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  const std::string config = stick.File("OPEN-R/MW/CONF/CONNECT.CFG");
  std::filesystem::remove(config);
  ASSERT_EQ(mkfifo(config.c_str(), 0600), 0);
  const ProgramResult result = RunStick(stick);
  EXPECT_EQ(result.status, 0);
  ExpectSaid(result,
             "warning: /MS/OPEN-R/MW/CONF/CONNECT.CFG is neither a file nor a folder, and a stick "
             "has nothing else");
  ExpectSaid(result, "no object is connected");
}

TEST(StickFaultsTest, AWarningSaysSoOnce) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", "[ers-210]\n");
  const ProgramResult result = RunStick(stick, {"--json"});
  ExpectSaid(result, "warning: CONNECT.CFG:1: section [ers-210] is read as [ERS-210]");
  const auto finding = nlohmann::json::parse(result.out)["findings"].at(0);
  EXPECT_EQ(finding["severity"], "warning");
  EXPECT_EQ(finding["text"].get<std::string>().find("warning"), std::string::npos) << finding;
}

constexpr char kUnknownService[] = "Trouble.Out.Text.S Nobody.In.Text.O\n";

TEST(StickFaultsTest, AnUnknownServiceIsSkippedAsOnTheRobot) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", kUnknownService);
  const ProgramResult result = RunStick(stick);
  EXPECT_EQ(result.status, 1);
  ExpectSaid(result, "CONNECT.CFG:1: OServiceManager::Connect() : Nobody.In.Text.O NOT FOUND");
  ExpectSaid(result, "Trouble is running");
}

// OBJECT.CFG does not name the object, and forty lines of CONNECT.CFG speak of it.
TEST(StickFaultsTest, EqualConsequencesOfOneMissingObjectAreOneFinding) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  std::string lines;
  for (int i = 0; i < 40; ++i)
    lines += "Trouble.Out.Text.S Nobody.In" + std::to_string(i) + ".Text.O\n";
  stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", lines + "Trouble.Owt.Text.S Trouble.In.Text.O\n");
  const ProgramResult result = RunStick(stick, {"--json"});
  EXPECT_EQ(result.status, 1);
  ExpectSaid(result,
             "(40 times, also at CONNECT.CFG:2, CONNECT.CFG:3, CONNECT.CFG:4, "
             "CONNECT.CFG:5, CONNECT.CFG:6 and 34 more)");
  const auto findings = nlohmann::json::parse(result.out)["findings"];
  ASSERT_GE(findings.size(), 2u) << findings;
  EXPECT_EQ(findings[0]["count"], 40);
  EXPECT_EQ(findings[0]["also_at"].size(), 5u);
  EXPECT_EQ(findings[0]["also_at_left_out"], 34);
  // A service that an object lacks is a mistake of its own.
  EXPECT_EQ(findings[1]["text"].get<std::string>().rfind("CONNECT.CFG:41:", 0), 0u) << findings[1];
}

TEST(StickFaultsTest, StrictRefusesAnUnknownServiceBeforeAnyObjectStarts) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", kUnknownService);
  const ProgramResult result = RunStick(stick, {"--strict", "--json"});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.err.find("Trouble is running"), std::string::npos) << result.err;
  ExpectSaid(result, "openr: the robot does not boot");
  ExpectSaid(result, "CONNECT.CFG:1: OServiceManager::Connect() : Nobody.In.Text.O NOT FOUND");
  EXPECT_EQ(nlohmann::json::parse(result.out)["virtual_time_s"], 0.0);
}

// The same user, or nobody in place of root, who may read everything.
ProgramResult RunUnprivileged(const std::vector<std::string>& words) {
  if (geteuid() != 0) return RunProgram(words);
  std::vector<std::string> all{"--reuid", "65534",          "--regid",
                               "65534",   "--clear-groups", OPENR_PROGRAM};
  all.insert(all.end(), words.begin(), words.end());
  return ProgramRun(all, "/usr/bin/setpriv").Finish();
}

class UnreadableStickTest : public testing::Test {
 protected:
  void SetUp() override {
    namespace fs = std::filesystem;
    stick_.MakeTrouble("nothing");
    fs::permissions(stick_.path(), fs::perms(0755));
    if (RunUnprivileged({"version"}).status != 0)
      GTEST_SKIP() << "no user but root may run the program here";
  }
  void TearDown() override {
    std::filesystem::permissions(closed_, std::filesystem::perms::owner_all);
  }
  void Close(const std::string& name) {
    closed_ = name.empty() ? stick_.path() : stick_.File(name);
    std::filesystem::permissions(closed_, std::filesystem::perms::none);
  }
  // Expects the messages `in_run` and `in_check` of `openr run` and `openr check` about the stick.
  // `run_status` is the expected exit status of `openr run`.
  void ExpectUnreadable(const std::string& in_run, const std::string& in_check,
                        int run_status = 1) {
    for (const std::string command : {"run", "check"}) {
      const std::vector<std::string> words =
          command == "run"
              ? std::vector<std::string>{"run",       "--for", "100ms",   "--rate",     "max",
                                         "--rc-port", "0",     "--stick", stick_.path()}
              : std::vector<std::string>{"check", stick_.path()};
      const ProgramResult result = RunUnprivileged(words);
      EXPECT_EQ(result.status, command == "run" ? run_status : 1) << result.err;
      const std::string said = result.out + result.err;
      const std::string& wanted = command == "run" ? in_run : in_check;
      EXPECT_NE(said.find(wanted + "Permission denied"), std::string::npos) << said;
      for (const char* wrong : {"does not exist", "No such file", "is missing", "holds no folder"})
        EXPECT_EQ(said.find(wrong), std::string::npos) << said;
    }
  }
  const ScratchFolder stick_;
  std::string closed_ = stick_.path();
};

TEST_F(UnreadableStickTest, TheFolderItself) {
  Close("");
  ExpectUnreadable("--stick " + stick_.path() + ": ", stick_.path() + ": cannot be read: ", 2);
}

TEST_F(UnreadableStickTest, AFolderOfIt) {
  Close("OPEN-R/MW/OBJS");
  ExpectUnreadable("OBJECT.CFG:1: /MS/OPEN-R/MW/OBJS/TROUBLE.BIN cannot be read: ",
                   stick_.File("OPEN-R/MW/OBJS") + ": cannot be read: ");
}

TEST_F(UnreadableStickTest, AFileOfIt) {
  Close("OPEN-R/MW/CONF/OBJECT.CFG");
  ExpectUnreadable("/MS/OPEN-R/MW/CONF/OBJECT.CFG: cannot be read: ",
                   stick_.File("OPEN-R/MW/CONF/OBJECT.CFG: cannot be read: "));
}

}  // namespace
}  // namespace openr_host

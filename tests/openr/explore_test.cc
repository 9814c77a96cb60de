// openr explore as a whole.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "openr/commands/explore_replay.h"
#include "openr/commands/explore_setup.h"
#include "openr/explore/fork_server.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using nlohmann::json;
using testing::HasSubstr;

ProgramResult Explore(const std::vector<std::string>& arguments) {
  std::vector<std::string> all = {"explore", "--for", "200ms", "--jobs", "1"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return RunProgram(all);
}

// Nothing the default stick ever says.
constexpr char kNever[] = "eventually objects.JointMover.state == dancing";

TEST(ExploreCommandTest, JsonIsOneObjectAndNothingElse) {
  const ProgramResult result = Explore({"--runs", "3", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["runs"], 3);
  EXPECT_EQ(report["broken"], 0);
  for (const char* field : {"digest", "wall_time_s", "runs_per_s", "first_seed", "jobs"}) {
    EXPECT_TRUE(report.contains(field)) << field;
  }
}

TEST(ExploreCommandTest, VerifyCountsDifferences) {
  const ProgramResult result = Explore({"--runs", "3", "--verify", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["differences"], 0);
}

TEST(ExploreCommandTest, ABrokenPropertyIsShownAndEndsWithOne) {
  const ProgramResult result = Explore({"--runs", "3", "--property", kNever});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("seed 1 breaks line 1 by t=0.200000 s: not "
                                    "objects.JointMover.state == dancing ever: it is '"));
  EXPECT_THAT(result.out, HasSubstr("it does so in the canonical order, too"));
  EXPECT_THAT(result.out, HasSubstr("the last messages:"));
}

TEST(ExploreCommandTest, AFailureIsWrittenAndReplaysTheSame) {
  const ScratchFolder folder;
  const std::string file = folder.File("failure.json");
  const ProgramResult found =
      Explore({"--seed", "2", "--runs", "1", "--body", "ideal", "--property", kNever, "-o", file});
  EXPECT_THAT(found.err, HasSubstr("openr explore --replay"));
  const json written = json::parse(folder.Read("failure.json"));
  EXPECT_EQ(written["openr_explore"], 1);
  EXPECT_EQ(written["seed"], 2);
  const ProgramResult replayed = RunProgram({"explore", "--replay", file});
  EXPECT_EQ(replayed.status, 1);
  EXPECT_THAT(replayed.out, HasSubstr("the same as in the file"));
  const ProgramResult both =
      RunProgram({"explore", "--replay", file, "--panel", "--record", folder.File("failure.rec")});
  EXPECT_EQ(both.status, 2) << "the panel shows the run and records nothing";
  EXPECT_THAT(both.err, HasSubstr("--panel excludes --record"));
}

TEST(ExploreCommandTest, AReplayTakesTheSticksThatTheUserNames) {
  const ScratchFolder folder, calm, wild;
  calm.MakeTrouble("nothing");
  wild.MakeTrouble("crash");
  const std::string file = folder.File("failure.json");
  Explore(
      {"--runs", "1", "--robots", "2", "--stick", calm.path(), "--stick", wild.path(), "-o", file});
  EXPECT_EQ(RunProgram({"explore", "--replay", file}).status, 1);
  const ProgramResult mended =
      RunProgram({"explore", "--replay", file, "--stick", calm.path(), "--stick", calm.path()});
  EXPECT_EQ(mended.status, 0) << mended.out << mended.err;
  const ProgramResult refused = RunProgram({"explore", "--replay", file, "--stick", calm.path(),
                                            "--stick", calm.path(), "--stick", calm.path()});
  EXPECT_NE(refused.status, 0);
  EXPECT_THAT(refused.err, HasSubstr("3 sticks, but the failing run has 2 robots"));
}

TEST(ExploreCommandTest, ARunThatDidNotEndIsNotRecorded) {
  const ScratchFolder folder;
  ExploreFlags flags;
  flags.record_file = folder.File("failure.rec");
  nlohmann::ordered_json answer;
  answer[kNotEnded] = true;
  answer["broken"]["text"] = "the run did not end within 120 s";
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE(RecordFailure(flags, ExploredStick(), 1, nlohmann::ordered_json::array(), answer));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(),
            "openr explore: no recording: the run did not end within 120 s\n");
  EXPECT_FALSE(std::filesystem::exists(flags.record_file));
}

TEST(ExploreCommandTest, AReplayThatHoldsNowSaysSoAndEndsWithZero) {
  const ScratchFolder folder;
  Explore({"--runs", "1", "--property", kNever, "-o", folder.File("failure.json")});
  json schedule = json::parse(folder.Read("failure.json"));
  schedule["properties"] = {"default"};
  folder.Write("failure.json", schedule.dump());
  const ProgramResult replayed =
      RunProgram({"explore", "--replay", folder.File("failure.json"), "--json"});
  EXPECT_EQ(replayed.status, 0) << replayed.err;
  EXPECT_FALSE(json::parse(replayed.out)["same"].get<bool>());
}

// The names of entries in a schedule file are for people, who may leave them out.
TEST(ExploreCommandTest, AnEditedScheduleNeedsNoNamesOfEntries) {
  const ScratchFolder folder;
  const std::string file = folder.File("failure.json");
  Explore({"--runs", "1", "--property", kNever, "-o", file});
  json schedule = json::parse(folder.Read("failure.json"));
  const json delay = {
      {"kind", "delay"},      {"time_us", 0},           {"nth", 0},       {"robot", 0},
      {"object", "RCServer"}, {"sender", "Controller"}, {"selector", 10}, {"us", 1000}};
  schedule["deviations"] = json::array({delay});
  folder.Write("failure.json", schedule.dump());
  const ProgramResult replayed = RunProgram({"explore", "--replay", file});
  EXPECT_EQ(replayed.status, 1) << replayed.err;
  EXPECT_THAT(replayed.out,
              HasSubstr("message 1 from Controller to RCServer, entry 10, comes 1000 us later"));
}

TEST(ExploreCommandTest, ACrashNamesTheHandlerAndDoesNotEndTheProgram) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  const ProgramResult result = Explore({"--runs", "1", "--stick", stick.path()});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("seed 1 breaks no-crash"));
#ifndef __SANITIZE_ADDRESS__
  EXPECT_THAT(result.out, HasSubstr("OBJECT Trouble, DoStart"));
  EXPECT_THAT(result.out, HasSubstr("seed 1 breaks no-crash by t=0.000000 s: EXCEPTION SIGSEGV"));
  EXPECT_THAT(result.out, HasSubstr("  the last messages:\n"));
  EXPECT_THAT(result.out, HasSubstr(" -> Trouble  DoStart: boot\n"));
#endif
}

TEST(ExploreCommandTest, AHandlerThatHangsIsEnded) {
  const ScratchFolder stick;
  stick.MakeTrouble("hang");
  const ProgramResult result =
      Explore({"--runs", "1", "--stick", stick.path(), "--handler-limit", "100ms"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("breaks handlers-return"));
  EXPECT_THAT(result.out, HasSubstr("Trouble, DoStart"));
  EXPECT_THAT(result.out, HasSubstr(" -> Trouble  DoStart: boot\n"));
}

// Such a system call is no function of the C library, so nothing refuses it.
TEST(ExploreCommandTest, ACopyThatEndsWithoutAnAnswerIsNamed) {
  const ScratchFolder stick;
  stick.MakeTrouble("endsystem");
  const ProgramResult result = Explore({"--runs", "1", "--stick", stick.path()});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("seed 1 breaks no-crash"));
  EXPECT_THAT(result.out, HasSubstr("the process ended with status 0 before the end of the run"));
}

#ifndef __SANITIZE_ADDRESS__  // AddressSanitizer reports crashes itself
// Expects that an exploration of Trouble ends while it loads the image, and says `end`.
void ExpectEarlyEndOfTrouble(const std::string& word, const std::string& end,
                             const std::vector<std::string>& more = {}) {
  const ScratchFolder stick;
  stick.MakeTrouble(word);
  std::vector<std::string> flags{"--runs",          "1",    "--stick", stick.path(),
                                 "--handler-limit", "200ms"};
  flags.insert(flags.end(), more.begin(), more.end());
  const ProgramResult result = Explore(flags);
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("Trouble, constructors of its globals"));
  EXPECT_THAT(result.err, HasSubstr("\nended by " + end));
}

TEST(ExploreCommandTest, AConstructorThatEndsTheProcessIsNamed) {
  const std::string crash = "crash: Trouble: crash: ", called = "a constructor of a global object ";
  ExpectEarlyEndOfTrouble("earlycrash", crash + "SIGSEGV");
  ExpectEarlyEndOfTrouble("earlycrash", crash + "SIGSEGV", {"--verify"});
  ExpectEarlyEndOfTrouble("earlyabort", crash + called + "has called abort()");
  ExpectEarlyEndOfTrouble("earlyexit", crash + called + "has called exit()");
  ExpectEarlyEndOfTrouble("earlyhang",
                          "handler-limit: Trouble: the loading or unloading of an image does not "
                          "end: constructors of its globals has used more than 0.2 s of processor "
                          "time (--handler-limit)");
}
#endif

TEST(ExploreCommandTest, AStickThatDoesNotBootIsRefusedWithItsFindings) {
  const ScratchFolder stick;
  stick.Write("OPEN-R/MW/CONF/OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/NOBODY.BIN\n");
  stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", "");
  const ProgramResult result = Explore({"--stick", stick.path()});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("the robot does not boot"));
  EXPECT_THAT(result.err, HasSubstr("NOBODY.BIN"));
}

TEST(ExploreCommandTest, ExhaustiveTellsHowMuchWasCovered) {
  const ProgramResult result = Explore({"--exhaustive", "--runs", "30", "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_EQ(report["runs"], 30);
  EXPECT_FALSE(report["complete"].get<bool>());
  EXPECT_GT(report["covered"].get<double>(), 0);
  EXPECT_EQ(report["stopped"], "at the bound of 30 runs");
}

TEST(ExploreCommandTest, WhatDoesNotGoTogetherIsRefused) {
  EXPECT_EQ(Explore({"--exhaustive", "--verify"}).status, 2);
  EXPECT_EQ(Explore({"--exhaustive", "--cost", "ers210.cost"}).status, 2);
  EXPECT_EQ(Explore({"--vary", "weather"}).status, 2);
  const ProgramResult property = Explore({"--property", "no-drop"});
  EXPECT_EQ(property.status, 1);
  EXPECT_THAT(property.err, HasSubstr("did you mean 'no-drops'?"));
  EXPECT_THAT(Explore({"--property", "always robots[-1].pitch_deg < 5"}).err,
              HasSubstr("'robots[-1].pitch_deg': there is no robot -1\n"));
  EXPECT_THAT(Explore({"--property", "always robots[].pitch_deg < 5"}).err,
              HasSubstr("'robots[].pitch_deg': write robots[0].standing\n"));
}

TEST(ExploreCommandTest, AWrongCostFileIsShown) {
  const ScratchFolder folder;
  folder.Write("a.cost", "* DoStart soon\n");
  const ProgramResult result = Explore({"--cost", folder.File("a.cost")});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("a.cost:1: 'soon' is no time"));
}

TEST(ExploreCommandTest, WhatObjectsPrintGoesToAFile) {
  const ScratchFolder stick;
  stick.MakeTrouble("print");
  Explore({"--runs", "2", "--stick", stick.path(), "--console", stick.File("console.txt")});
  EXPECT_THAT(stick.Read("console.txt"), HasSubstr("said by an object"));
}

}  // namespace
}  // namespace openr_host

// openr run as a whole, on the default stick and on sticks that are up to no good.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>

#include "openr/emon/emon_log.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using nlohmann::json;
using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::MatchesRegex;
using ::testing::Not;

std::vector<std::string> With(std::vector<std::string> arguments,
                              const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

ProgramResult RunFor(const std::string& duration, const std::vector<std::string>& more = {}) {
  return RunProgram(
      With({"run", "--for", duration, "--rate", "max", "--no-panel", "--rc-port", "0"}, more));
}

TEST(RunTest, JsonIsOneObjectAndNothingElse) {
  const ProgramResult result = RunFor("100ms", {"--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const json report = json::parse(result.out);
  EXPECT_DOUBLE_EQ(report["virtual_time_s"].get<double>(), 0.1);
}

TEST(RunTest, TheReportHasEveryFieldOfTheManual) {
  const ScratchFolder folder;
  const ProgramResult result = RunFor("1s", {"--report", folder.File("r.json")});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out, "");
  const json report = json::parse(folder.Read("r.json"));
  for (const char* field :
       {"virtual_time_s", "wall_time_s", "x_real_time", "frames", "messages", "seed", "state_hash",
        "trace_hash", "rc_port", "robots", "objects", "findings", "ended_by", "ended_why"}) {
    EXPECT_TRUE(report.contains(field)) << field;
  }
  const json& robot = report["robots"].at(0);
  for (const char* field :
       {"model", "standing", "base_position_m", "base_rpy_deg", "joints_deg", "sensors", "leds"}) {
    EXPECT_TRUE(robot.contains(field)) << field;
  }
  for (const char* field :
       {"robot", "name", "state", "messages", "dropped", "queue_max", "handler_us_max"}) {
    EXPECT_TRUE(report["objects"].at(0).contains(field)) << field;
  }
  EXPECT_EQ(report["state_hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(robot["joints_deg"].size(), 18u);
  EXPECT_EQ(robot["leds"].size(), 9u);
}

TEST(RunTest, FramesLastEightMilliseconds) {
  const json report = json::parse(RunFor("2s", {"--json"}).out);
  EXPECT_EQ(report["frames"], 250);
}

TEST(RunTest, TheSameSeedGivesTheSameHashes) {
  const json first = json::parse(RunFor("2s", {"--json", "--seed", "7"}).out);
  const json second = json::parse(RunFor("2s", {"--json", "--seed", "7"}).out);
  EXPECT_EQ(first["state_hash"], second["state_hash"]);
  EXPECT_EQ(first["trace_hash"], second["trace_hash"]);
}

TEST(RunTest, TheErs220StandsOnItsBodyWithPhysics) {
  const json report = json::parse(RunFor("20s", {"--robot", "ers220", "--json"}).out);
  EXPECT_EQ(report["robots"][0]["model"], "ERS-220");
  EXPECT_TRUE(report["robots"][0]["standing"]);
}

TEST(RunTest, SeveralRobotsAreReportedEach) {
  const json report =
      json::parse(RunFor("200ms", {"--json", "--robots", "2", "--body", "ideal"}).out);
  EXPECT_EQ(report["robots"].size(), 2u);
  EXPECT_NE(report["robots"][0]["rc_port"], report["robots"][1]["rc_port"]);
}

TEST(RunTest, WhatObjectsPrintGoesToStandardError) {
  const ScratchFolder stick;
  stick.MakeTrouble("print");
  const ProgramResult result = RunFor("100ms", {"--stick", stick.path(), "--json"});
  EXPECT_TRUE(json::accept(result.out)) << result.out;
  EXPECT_NE(result.err.find("printed by an object"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("said by an object"), std::string::npos) << result.err;
}

TEST(RunTest, TheConsoleCanBeAFile) {
  const ScratchFolder stick;
  stick.MakeTrouble("print");
  const ProgramResult result =
      RunFor("100ms", {"--stick", stick.path(), "--console", stick.File("console.txt")});
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(result.err.find("by an object"), std::string::npos) << result.err;
  EXPECT_NE(stick.Read("console.txt").find("printed by an object"), std::string::npos);
}

TEST(RunTest, TheConsoleBeginsWithTheNamesOfTheObjects) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  RunFor("100ms", {"--stick", stick.path(), "--console", stick.File("console.txt")});
  const std::string console = stick.Read("console.txt");
  EXPECT_NE(console.find("] /MS/OPEN-R/MW/OBJS/TROUBLE.BIN Trouble\n"), std::string::npos)
      << console;
  EXPECT_EQ(console.find("[oid:0x80000042] "), 0u) << console;
}

TEST(RunTest, AnObjectThatShutsTheRobotDownEndsTheRun) {
  const ScratchFolder stick;
  stick.MakeTrouble("shutdown");
  const ProgramResult result =
      RunProgram({"run", "--rate", "max", "--no-panel", "--rc-port", "0", "--stick", stick.path()});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("Trouble was stopped"), std::string::npos) << result.err;
}

TEST(RunTest, WithoutAnythingToDoTheRunIsIdleAfterASecond) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  const ProgramResult result = RunProgram({"run", "--until-idle", "--rate", "max", "--no-panel",
                                           "--rc-port", "0", "--json", "--stick", stick.path()});
  const double time_s = json::parse(result.out)["virtual_time_s"].get<double>();
  EXPECT_GE(time_s, 1.0);
  EXPECT_LT(time_s, 1.1);
}

TEST(RunTest, ControlCIsThePauseButton) {
  const ScratchFolder folder;
  ProgramRun run(
      {"run", "--rate", "max", "--no-panel", "--rc-port", "0", "--report", folder.File("r.json")});
  ASSERT_TRUE(run.WaitFor("state: sleeping"));
  run.Signal(SIGINT);
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("pause button pressed"), std::string::npos) << result.err;
  EXPECT_TRUE(json::accept(folder.Read("r.json")));
}

TEST(RunTest, LinesOfACostFileThatFitNothingAreNamedAtTheEnd) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  stick.Write("a.cost", "# times\nTrouble DoStart 100\nTruoble DoStart 200\n* DoStrt 300\n");
  const ProgramResult result =
      RunFor("100ms", {"--stick", stick.path(), "--cost", stick.File("a.cost"), "--json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const json findings = json::parse(result.out)["findings"];
  ASSERT_EQ(findings.size(), 1u) << findings;
  EXPECT_EQ(findings[0]["severity"], "warning");
  EXPECT_EQ(findings[0]["text"],
            stick.File("a.cost") +
                ": no handler that ran is meant by line 3 (Truoble DoStart 200), 4 (* DoStrt 300); "
                "openr trace shows how objects and entries are called");
}

TEST(RunTest, WithoutAnObjectForThePauseButtonTheRunEndsAllTheSame) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  ProgramRun run({"run", "--no-panel", "--rc-port", "0", "--stick", stick.path()});
  ASSERT_TRUE(run.WaitFor("is running"));
  run.Signal(SIGTERM);
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("no object handles the pause button"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("Trouble was stopped"), std::string::npos) << result.err;
}

TEST(RunTest, AHandlerThatDoesNotReturnIsNamed) {
  const ScratchFolder stick;
  stick.MakeTrouble("hang");
  const ProgramResult result =
      RunFor("1s", {"--stick", stick.path(), "--handler-limit", "200ms", "--json"});
  EXPECT_EQ(result.status, 1);
  const json report = json::parse(result.out);
  EXPECT_TRUE(report.contains("error")) << result.out;
  EXPECT_TRUE(report.contains("state_hash")) << result.out;
  EXPECT_EQ(report["findings"].at(0)["object"], "Trouble");
  EXPECT_EQ(report["findings"].at(0)["said"], "boot");
  EXPECT_EQ(report["findings"].at(0)["text"],
            "a handler does not return: DoStart (selector 1) has used more than 0.2 s of processor "
            "time (--handler-limit)");
  EXPECT_NE(result.err.find("a handler does not return: Trouble, DoStart (selector 1), message "),
            std::string::npos)
      << result.err;
}

TEST(RunTest, ALineThatIsNotEndedIsPrintedBeforeTheSummary) {
  const ScratchFolder stick;
  stick.MakeTrouble("half");
  EXPECT_NE(RunFor("1s", {"--stick", stick.path()}).err.find("\nhalf a line\n1.000 s of virtual"),
            std::string::npos);
  RunFor("1s", {"--stick", stick.path(), "--console", stick.File("c.txt")});
  EXPECT_TRUE(stick.Read("c.txt").ends_with("\nhalf a line\n")) << stick.Read("c.txt");
}

TEST(RunTest, WhatAHandlerPrintedThatDoesNotReturnIsThere) {
  const ScratchFolder stick;
  stick.MakeTrouble("halfhang");
  const ProgramResult result = RunFor("1s", {"--stick", stick.path(), "--handler-limit", "200ms"});
  EXPECT_NE(result.err.find("\nhalf a line\nopenr: a handler does not return"), std::string::npos)
      << result.err;
}

#if !defined(__SANITIZE_ADDRESS__)  // AddressSanitizer reports such faults itself
// Returns the part of a crash record that is for people.  The part in the robot's form follows it.
std::string TextPart(const std::string& record) {
  return record.substr(0, record.find("[exception info]\n"));
}

std::string RecordOf(const std::string& word) {
  const ScratchFolder stick;
  stick.MakeTrouble(word);
  const ProgramResult result = RunFor("1s", {"--stick", stick.path()});
  EXPECT_EQ(result.status, 1) << result.err;
  const std::string record = stick.Read("OPEN-R/EMON.LOG");
  EXPECT_THAT(result.err, HasSubstr(TextPart(record))) << "standard error says the same";
  return record;
}

TEST(CrashTest, ACrashLeavesARecordOnTheStick) {
  const std::string record = RecordOf("crash");
  EXPECT_NE(record.find("EXCEPTION SIGSEGV"), std::string::npos) << record;
  EXPECT_NE(record.find("at address 0x10\n"), std::string::npos) << record;
  EXPECT_NE(record.find("OBJECT Trouble, DoStart (selector 1), message "), std::string::npos)
      << record;
  EXPECT_EQ(record.find("STACK overflow"), std::string::npos) << record;
}

TEST(CrashTest, ACrashLeavesARecordInAFolderInLowerCase) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  std::filesystem::rename(stick.File("OPEN-R"), stick.File("open-r"));
  const ProgramResult result = RunFor("1s", {"--stick", stick.path()});
  const std::string record = stick.Read("open-r/EMON.LOG");
  EXPECT_THAT(record, HasSubstr("EXCEPTION SIGSEGV")) << result.err;
  EXPECT_THAT(result.err, HasSubstr("openr: wrote " + stick.File("open-r/EMON.LOG") + "\n"));
}

TEST(CrashTest, TheRecordNamesTheMessageAndStandardErrorSaysItsContent) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  const ProgramResult result = RunFor("1s", {"--stick", stick.path(), "--json"});
  EXPECT_THAT(stick.Read("OPEN-R/EMON.LOG"),
              ContainsRegex("\nOBJECT [^\n]*\nMESSAGE from oobjectManager, [0-9]+ bytes\nSTACK\n"));
  const json finding = json::parse(result.out)["findings"].at(0);
  EXPECT_EQ(finding["said"], "boot");
  EXPECT_THAT(result.err, HasSubstr("\nopenr: message " + finding["message"].dump() + ": boot\n"));
}

TEST(CrashTest, ARecordThatCannotBeWrittenIsNamedWithTheReason) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  const std::string file = stick.File("OPEN-R/EMON.LOG");
  std::filesystem::create_directory(file);
  ProgramResult result = RunFor("1s", {"--stick", stick.path()});
  EXPECT_EQ(result.status, 1);
  const std::string complaint = "openr: " + file + ": the record of the crash cannot be written: ";
  EXPECT_THAT(result.err, HasSubstr(complaint + "Is a directory\n"));
  std::filesystem::remove(file);
  std::filesystem::create_symlink("/dev/full", file);
  result = RunFor("1s", {"--stick", stick.path()});
  EXPECT_THAT(result.err, HasSubstr(complaint + "No space left on device\n"));
  EXPECT_THAT(result.err, Not(HasSubstr("openr: wrote")));
}

TEST(CrashTest, TheRecordHasTheStackOfTheObjectAndEndsThere) {
  const std::string record = RecordOf("crash");
  EXPECT_THAT(record, ContainsRegex("\nSTACK\n  #0 TROUBLE.BIN\\+0x[0-9a-f]+ Trouble::DoStart.* "
                                    "\\(Trouble.cc:[0-9]+\\)\n"));
  const std::string last = record.substr(record.rfind('#'));
  EXPECT_THAT(last, HasSubstr("TROUBLE.BIN+0x"));
  for (const char* const word : {"crash", "divide", "recurse"})
    EXPECT_EQ(RecordOf(word), RecordOf(word)) << "no addresses of this host";
}

TEST(CrashTest, TheStackOfOneThatRecursesIsOfSoManyFrames) {
  const std::string record = RecordOf("recurse");
  EXPECT_THAT(record, HasSubstr("  #31 TROUBLE.BIN+0x"));
  EXPECT_EQ(record.find("  #32 "), std::string::npos) << record;
}

// Nothing is there to be named; who called it is.
TEST(CrashTest, WhoCallsNothingIsInTheStack) {
  const std::string record = RecordOf("callnull");
  EXPECT_THAT(record, ContainsRegex("  #1 TROUBLE.BIN\\+0x[0-9a-f]+ Trouble::DoStart"));
}

TEST(CrashTest, ACrashInTheCLibraryIsFollowedByTheLineThatCalledIt) {
  const std::string record = RecordOf("copynull");
  EXPECT_THAT(record, ContainsRegex("  #0 libc.so[^\n]*\n"
                                    "  #1 TROUBLE.BIN\\+0x[0-9a-f]+ Trouble::DoStart"));
}

TEST(CrashTest, TheJsonAnswerSaysWhatHappened) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  const ProgramResult result = RunFor("1s", {"--stick", stick.path(), "--json"});
  ASSERT_TRUE(json::accept(result.out)) << result.out;
  EXPECT_EQ(json::parse(result.out)["error"].get<std::string>() + "\n",
            TextPart(stick.Read("OPEN-R/EMON.LOG")));
}

TEST(CrashTest, TheRecordHasTheRobotsFormToo) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  RunFor("1s", {"--stick", stick.path()});
  const std::string record = stick.Read("OPEN-R/EMON.LOG");
  EXPECT_THAT(record, ContainsRegex("\nSTACK\n(.*\n)*\\[exception info\\]\n"));
  const std::optional<EmonLog> log = ParseEmonLog(record);
  ASSERT_TRUE(log) << record;
  EXPECT_EQ(log->code, 3u) << "a store";
  EXPECT_EQ(log->cause, 3u << 2);
  EXPECT_EQ(log->bad_address, 0x10u);
  char offset[16];  // offset of the instruction in the image, as in the stack above
  std::snprintf(offset, sizeof offset, "+0x%x ", log->epc.value_or(0));
  EXPECT_THAT(record, HasSubstr("#0 TROUBLE.BIN" + std::string(offset)));
  ASSERT_NE(log->CrashedObject(), nullptr) << record;
  EXPECT_EQ(log->CrashedObject()->name, "Trouble");
  EXPECT_THAT(record, HasSubstr("\n OVirtualRobotComm 0x80000043 "));
}

TEST(CrashTest, TheRobotsCodesOfOtherCrashes) {
  EXPECT_EQ(ParseEmonLog(RecordOf("divide"))->code, 9u);
  EXPECT_EQ(ParseEmonLog(RecordOf("callnull"))->code, 2u) << "a jump";
  for (const char* const word : {"nan", "denormal"}) {
    const ScratchFolder stick;
    stick.MakeTrouble(word);
    RunFor("1s", {"--stick", stick.path(), "--strict"});
    EXPECT_EQ(ParseEmonLog(stick.Read("OPEN-R/EMON.LOG"))->code, 15u) << word;
  }
}

TEST(CrashTest, TheRecordListsTheObjectsOfOneRobot) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  RunFor("1s", {"--stick", stick.path(), "--robots", "2"});
  const std::optional<EmonLog> log = ParseEmonLog(stick.Read("OPEN-R/EMON.LOG"));
  ASSERT_TRUE(log);
  const auto is_trouble = [](const EmonLog::Object& object) { return object.name == "Trouble"; };
  EXPECT_EQ(std::count_if(log->objects.begin(), log->objects.end(), is_trouble), 1);
}

TEST(CrashTest, EmonTellsARecordWithoutTheRobotsForm) {
  const ScratchFolder folder;
  folder.Write("EMON.LOG", "EXCEPTION SIGSEGV (data were executed)\nOBJECT dancer\n");
  const ProgramResult told = RunProgram({"emon", folder.File("EMON.LOG")});
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(
      told.out,
      "EXCEPTION SIGSEGV (data were executed)\nOBJECT dancer\n"
      "note: the record is not complete: it has no list of objects at its end, because it was "
      "cut off, or because the crash had damaged the stack\n");
}

TEST(CrashTest, EmonSaysThatARecordIsCutOff) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  RunFor("1s", {"--stick", stick.path()});
  const std::string record = stick.Read("OPEN-R/EMON.LOG");
  const size_t robot_record = record.find("[exception info]\n");
  for (const size_t size : {size_t{40}, robot_record + 20, record.size() - 1}) {
    stick.Write("EMON.LOG", record.substr(0, size));
    const ProgramResult told = RunProgram({"emon", stick.File("EMON.LOG")});
    EXPECT_EQ(told.status, 0) << told.err;
    EXPECT_THAT(told.out, HasSubstr("\nnote: the record is not complete: ")) << size;
    const json answer = json::parse(RunProgram({"emon", stick.File("EMON.LOG"), "--json"}).out);
    EXPECT_THAT(answer["problem"].get<std::string>(), HasSubstr("is not complete")) << size;
  }
}

TEST(CrashTest, EmonPrintsNoControlBytesOfARecord) {
  const ScratchFolder folder;
  folder.Write("EMON.LOG", "EXCEPTION \x1b[31m\nOBJECT\tdancer\n");
  EXPECT_THAT(RunProgram({"emon", folder.File("EMON.LOG")}).out,
              HasSubstr("EXCEPTION ?[31m\nOBJECT\tdancer\n"));
}

TEST(CrashTest, EmonTellsWhatItIsOnTheRobot) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  RunFor("1s", {"--stick", stick.path()});
  const std::string file = stick.File("OPEN-R/EMON.LOG");
  const ProgramResult told = RunProgram({"emon", file});
  EXPECT_EQ(told.status, 0) << told.err;
  EXPECT_EQ(told.out, TextPart(stick.Read("OPEN-R/EMON.LOG")) +
                          "ON THE ROBOT exception 3: a store with a null or wild pointer\n");
  const json answer = json::parse(RunProgram({"emon", file, "--json"}).out);
  EXPECT_EQ(answer["object"], "Trouble");
  EXPECT_EQ(answer["code"], 3);
  EXPECT_THAT(answer["record"].get<std::string>(), HasSubstr("EXCEPTION SIGSEGV"));
  EXPECT_THAT(RunProgram({"emon", file, "--image", stick.File("OPEN-R/MW/OBJS/TROUBLE.BIN")}).err,
              HasSubstr("names functions and lines itself; leave out --image"));
}

TEST(CrashTest, TheReportIsThatOfARunAndHasTheCrashAmongItsFindings) {
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  const ProgramResult result =
      RunFor("1s", {"--stick", stick.path(), "--json", "--report", stick.File("r.json")});
  EXPECT_EQ(result.status, 1);
  const json report = json::parse(result.out);
  EXPECT_EQ(report, json::parse(stick.Read("r.json")));
  EXPECT_EQ(report["seed"], 1);
  EXPECT_EQ(report["robots"].size(), 1u);
  ASSERT_EQ(report["findings"].size(), 1u);
  const json finding = report["findings"][0];
  EXPECT_EQ(finding["severity"], "error");
  EXPECT_EQ(finding["object"], "Trouble");
  EXPECT_GT(finding["message"].get<int>(), 0);
  EXPECT_THAT(finding["text"].get<std::string>(),
              MatchesRegex("crash: SIGSEGV \\(an address that is not the object's\\) in DoStart "
                           "\\(selector 1\\), at TROUBLE.BIN\\+0x[0-9a-f]+ Trouble::DoStart.*; "
                           "on the robot this stops all objects"));
}

TEST(CrashTest, WhatAnObjectPrintedBeforeIsThere) {
  const ScratchFolder stick;
  stick.MakeTrouble("halfcrash");
  const ProgramResult result = RunFor("1s", {"--stick", stick.path()});
  EXPECT_NE(result.err.find("\nhalf a line\nEXCEPTION SIGSEGV"), std::string::npos) << result.err;
}

TEST(CrashTest, AStackOverflowIsCalledByItsName) {
  EXPECT_NE(RecordOf("recurse").find("STACK overflow"), std::string::npos);
}

TEST(CrashTest, AHandlerThatWouldOverflowTheRobotsStackIsAWarning) {
  const ScratchFolder stick;
  stick.MakeTrouble("deep");
  const ProgramResult result = RunFor("1s", {"--stick", stick.path()});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err,
              ::testing::ContainsRegex("a handler's own functions used 40[0-9]+ bytes of stack, "
                                       "the .ocf file gives 8192"));
}

TEST(CrashTest, ADivisionByZeroIsCalledByItsName) {
  const std::string record = RecordOf("divide");
  EXPECT_NE(record.find("a division by zero"), std::string::npos) << record;
  // The functions by which the runtime has found the division are not of the object's stack.
  EXPECT_NE(record.find("STACK\n  #0 TROUBLE.BIN+0x"), std::string::npos) << record;
}
#endif

TEST(PictureTest, ASnapshotIsAPngOfTheSizeAskedFor) {
  const ScratchFolder folder;
  const ProgramResult result =
      RunFor("80ms", {"--snapshot", "t=40ms,view=side,size=320x200", "-o", folder.File("a.png")});
  EXPECT_EQ(result.status, 0) << result.err;
  const std::string png = folder.Read("a.png");
  ASSERT_GT(png.size(), 1000u);
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(png.substr(16, 8), std::string("\0\0\1\x40\0\0\0\xc8", 8));
}

TEST(PictureTest, APictureWhoseTimeDoesNotComeIsAnError) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  const ProgramResult result =
      RunProgram({"run", "--until-idle", "--rate", "max", "--rc-port", "0", "--stick", stick.path(),
                  "--json", "--snapshot", "t=30s", "-o", stick.File("a.png")});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(stick.Read("a.png"), "");
  const json finding = json::parse(result.out)["findings"].at(0);
  EXPECT_EQ(finding["severity"], "error");
  EXPECT_EQ(finding["text"], "no picture " + stick.File("a.png") +
                                 ": the run was over before t=30s; t=end is its end");
}

TEST(GraphTest, EveryLineOfTheDefaultWiringIsConnected) {
  const ProgramResult result = RunProgram({"graph", "--format", "json"});
  EXPECT_EQ(result.status, 0) << result.err;
  const json graph = json::parse(result.out);
  EXPECT_GE(graph["connections"].size(), 11u);
  for (const json& wire : graph["connections"]) EXPECT_EQ(wire["connected"], true) << wire;
}

TEST(GraphTest, DotNamesEveryObject) {
  const ProgramResult result = RunProgram({"graph"});
  EXPECT_EQ(result.out.find("digraph"), 0u);
  EXPECT_NE(result.out.find("OVirtualRobotComm"), std::string::npos);
}

}  // namespace
}  // namespace openr_host

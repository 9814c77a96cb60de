// Control bytes of files, recordings and runs in what the program prints: a terminal would obey
// them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "openr/inspect/trace_file.h"
#include "tests/openr/panel_server.h"
#include "tests/openr/program_run.h"
#include "tests/openr/terminal_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Clears a terminal.
constexpr char kEscape[] = "\x1b[2J", kShownEscape[] = "?[2J";

class ControlBytesTest : public ::testing::Test {
 protected:
  ControlBytesTest() {
    setenv("TERM", "xterm", 1);
    setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1);
  }
  ~ControlBytesTest() override { unsetenv("XDG_RUNTIME_DIR"); }

  // Returns the file of a recording whose names of entries have control bytes.
  std::string Record() const {
    const std::string file = folder_.File("run.rec"), copy = folder_.File("copy.rec");
    const ProgramResult run = RunProgram({"run", "--body", "ideal", "--for", "1s", "--rate", "max",
                                          "--no-panel", "--rc-port", "0", "--record", file});
    EXPECT_EQ(run.status, 0) << run.err;
    TraceReader reader(file);
    TraceWriter writer(copy, reader.header());
    while (reader.Peek() != nullptr) {
      TraceEntry entry = reader.Take();
      if (entry.kind == TraceEntry::Kind::kEntry) entry.name += kEscape;
      writer.AddEntry(entry);
    }
    writer.Flush();
    return copy;
  }

  const ScratchFolder folder_;
};

TEST_F(ControlBytesTest, ANameOfAFileIsShownWithoutThem) {
  const std::string file = folder_.File(std::string("a") + kEscape + ".log");
  std::filesystem::copy_file(std::string(OPENR_TEST_DATA) + "/walk.log", file);
  const ProgramResult info = RunProgram({"log", "info", file});
  EXPECT_EQ(info.status, 0) << info.err;
  EXPECT_THAT(info.out, HasSubstr(std::string("a") + kShownEscape + ".log: AIBO_1.1"));
  const ProgramResult json = RunProgram({"log", "info", "--json", file});
  EXPECT_EQ(nlohmann::json::parse(json.out).at("file"), file);
}

TEST_F(ControlBytesTest, ATraceHasThemOnlyAsDataAndNotOnATerminal) {
  const std::string file = Record();
  const ProgramResult text = RunProgram({"trace", file});
  EXPECT_THAT(text.out, HasSubstr(kShownEscape));
  EXPECT_THAT(text.out, Not(HasSubstr("\x1b")));
  EXPECT_THAT(RunProgram({"trace", file, "--format", "csv"}).out, HasSubstr(kEscape));
  TerminalRun shown({"trace", file, "--format", "csv"}, "");
  EXPECT_EQ(shown.Finish(), 0);
  EXPECT_THAT(shown.shown(), HasSubstr(kShownEscape));
  EXPECT_THAT(shown.shown(), Not(HasSubstr("\x1b")));
}

TEST_F(ControlBytesTest, AStepOfAReplayIsShownWithoutThem) {
  TerminalRun step({"replay", Record(), "--step"}, "(");
  ASSERT_TRUE(step.WaitFor("(start) ")) << step.shown();
  EXPECT_NE(step.Ask("step\r", kShownEscape), "") << step.shown();
  EXPECT_THAT(step.shown(), Not(HasSubstr(kEscape)));
}

TEST_F(ControlBytesTest, AFindingOfARunIsShownWithoutThem) {
  FakeRun run("played");
  TerminalRun attach({"attach", "played"}, "played> ");
  run.Accept();
  attach.Type("findings\r");
  EXPECT_EQ(nlohmann::json::parse(run.Line()).at("do"), "findings");
  run.Write(R"({"findings":[{"severity":"error","object":"A","time_s":1.0,"message":0,)"
            R"("text":"bad \u001b[2J name"}]})"
            "\n");
  EXPECT_TRUE(attach.WaitFor(std::string("bad ") + kShownEscape + " name")) << attach.shown();
  EXPECT_THAT(attach.shown(), Not(HasSubstr(kEscape)));
}

TEST_F(ControlBytesTest, ARefusalOfARunIsShownWithoutThem) {
  FakeRun run("played");
  ProgramRun poke({"poke", "played", "press"});
  run.Accept();
  EXPECT_EQ(nlohmann::json::parse(run.Line()).at("line"), "press");
  run.Write("{\"error\":\"no \\u001b[2J sensor\"}\n");
  EXPECT_EQ(poke.Finish().status, 1);
  EXPECT_THAT(poke.heard(), HasSubstr(std::string("openr: no ") + kShownEscape + " sensor\n"));
}

TEST_F(ControlBytesTest, AScheduleFileIsShownWithoutThem) {
  const std::string file = folder_.File("schedule.json");
  std::ofstream(file) << R"({"openr_explore": 1, "stick": "", "robot": "ers210", "world": "",
      "body": "ideal", "robots": 1, "strict": false, "guard": true, "cost": "", "battery": "drain",
      "for_us": 100000, "properties": ["no-drops"], "seed": 17, "property": "no-drops",
      "text": "evil \u001b[2J text", "deviations": []})";
  const ProgramResult replay = RunProgram({"explore", "--replay", file});
  EXPECT_THAT(replay.out, HasSubstr(std::string("the file says: no-drops: evil ") + kShownEscape));
  EXPECT_THAT(replay.out, Not(HasSubstr(kEscape)));
}

}  // namespace
}  // namespace openr_host

// openr top; watching a run changes nothing in it.
#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "openr/commands/top_view.h"
#include "tests/distribution/hosts.h"
#include "tests/distribution/kill_process.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// Returns what openr top prints about the run of this name.
json Top(const std::string& name) {
  const ProgramResult result = RunProgram({"top", "--once", "--json", "--run-name", name});
  EXPECT_EQ(result.status, 0) << result.err;
  const json top = json::parse(result.out, nullptr, false);
  if (!top.is_object() || top["runs"].size() != 1) {
    ADD_FAILURE() << result.out;
    return {};
  }
  return top["runs"][0];
}

json ObjectNamed(const json& run, const std::string& name) {
  for (const json& object : run["objects"]) {
    if (object["name"] == name) return object;
  }
  ADD_FAILURE() << "no object " << name << " in " << run;
  return {};
}

std::unique_ptr<ProgramRun> StartRun(const std::string& name, const Words& flags) {
  auto run = std::make_unique<ProgramRun>(Words{"run", "--body", "ideal", "--no-panel", "--rc-port",
                                                "0", "--for", "10min", "--run-name", name} +
                                          flags);
  EXPECT_TRUE(run->WaitFor("state: listening")) << run->Finish().err;
  return run;
}

// Runs of other tests may be in the list as well.
bool IsSaidToHaveEnded(const std::string& run, const std::string& table) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(run + " on ") && line.find("; ended") != std::string::npos) return true;
  }
  return false;
}

TEST(TopTest, TopNamesTheObjectsAndProcessesOfARun) {
  const std::string name = RunName("busy");
  const auto run =
      StartRun(name, {"--isolate", "JointMover", "--place", "RCServer=net", "--rate", "2"});
  const json top = Top(name);
  EXPECT_EQ(top["run"], name);
  EXPECT_EQ(top["pid"], run->pid());
  EXPECT_FALSE(top["ended"]);
  EXPECT_GT(top["virtual_time_s"], 0);
  EXPECT_GT(top["x_real_time"], 0);
  EXPECT_GT(top["messages_per_s"], 0);
  ASSERT_EQ(top["processes"].size(), 2u);
  for (const json& process : top["processes"]) {
    const pid_t pid = process["pid"];
    EXPECT_EQ(kill(pid, 0), 0) << process;
    EXPECT_NE(pid, run->pid());
    EXPECT_EQ(process["lost"], "");
  }
  const json mover = ObjectNamed(top, "JointMover");
  EXPECT_EQ(mover["process"], "JointMover");
  EXPECT_EQ(mover["pid"], top["processes"][0]["pid"]);
  EXPECT_EQ(mover["host"], top["host"]);
  EXPECT_GT(mover["messages_per_s"], 0);
  EXPECT_GT(mover["handler_us"]["mean"], 0);
  EXPECT_LE(mover["handler_us"]["mean"], mover["handler_us"]["max"]);
  EXPECT_EQ(mover["priority"], 128);
  EXPECT_EQ(ObjectNamed(top, "RCServer")["pid"], top["processes"][1]["pid"]);
  const json here = ObjectNamed(top, "Controller");
  EXPECT_EQ(here["process"], "");
  EXPECT_EQ(here["pid"], run->pid());
  EXPECT_TRUE(here["handler_us"].is_null());
  run->Signal(SIGINT);
  EXPECT_EQ(run->Finish().status, 0) << run->heard();
}

TEST(TopTest, ALostProcessIsShownAsLost) {
  const std::string name = RunName("lost");
  const auto run = StartRun(name, {"--isolate", "JointMover", "--free-running"});
  const pid_t child = ObjectNamed(Top(name), "JointMover")["pid"];
  KillProcess(child, SIGKILL);
  std::string lost;
  for (int i = 0; i < 10 && lost.empty(); ++i) lost = ObjectNamed(Top(name), "JointMover")["lost"];
  EXPECT_THAT(lost, HasSubstr("process 'JointMover' (pid " + std::to_string(child) +
                              ") was killed by signal 9"));
  const ProgramResult table = RunProgram({"top", "--once", "--run-name", name});
  EXPECT_THAT(table.out, HasSubstr("JointMover (lost)"));
  EXPECT_THAT(table.out, HasSubstr("lost: " + lost));
}

TEST(TopTest, ARestartedProcessIsShownWithItsNewId) {
  const std::string name = RunName("back");
  const auto run = StartRun(name, {"--isolate", "JointMover", "--restart", "1"});
  const pid_t child = ObjectNamed(Top(name), "JointMover")["pid"];
  KillProcess(child, SIGKILL);
  ASSERT_TRUE(run->WaitFor("process 'JointMover' is back")) << run->heard();
  for (int i = 0; i < 2; ++i) {  // counters that began anew must not give huge rates
    const json mover = ObjectNamed(Top(name), "JointMover");
    EXPECT_NE(mover["pid"], child);
    EXPECT_EQ(mover["lost"], "");
    EXPECT_LT(mover["messages_per_s"], 10'000);
  }
}

TEST(TopTest, ARunInOneProcessIsShownWithMonitorOnly) {
  {
    ProgramRun silent({"run", "--body", "ideal", "--no-panel", "--rc-port", "0", "--for", "10min"});
    EXPECT_TRUE(silent.WaitFor("state: listening")) << silent.Finish().err;
    const std::string its_name = "openr-" + std::to_string(silent.pid());
    const ProgramResult nothing =
        RunProgram({"top", "--once", "--json", "--wait", "1500ms", "--run-name", its_name});
    EXPECT_EQ(nothing.status, 1);
    EXPECT_THAT(nothing.err, HasSubstr("no run '" + its_name + "' was heard within 1.5 s"));
    EXPECT_TRUE(json::parse(nothing.out, nullptr, false).contains("error")) << nothing.out;
  }
  const std::string name = RunName("one");
  const auto run = StartRun(name, {"--monitor"});
  EXPECT_EQ(ObjectNamed(Top(name), "JointMover")["pid"], run->pid());
}

TEST(TopTest, AllRunsThatAreHeardAreShownUntilControlC) {
  const std::string one = RunName("first"), two = RunName("second");
  const auto first = StartRun(one, {"--monitor"}), second = StartRun(two, {"--monitor"});
  const auto has_both = [&](const std::string& text) {
    return text.find(one + " on ") != std::string::npos &&
           text.find(two + " on ") != std::string::npos;
  };
  std::string once;  // a status may arrive late on a busy machine
  for (int i = 0; i < 20 && !has_both(once); ++i) once = RunProgram({"top", "--once"}).out;
  EXPECT_TRUE(has_both(once)) << once;
  ProgramRun top(Words{"-c", "exec \"$0\" \"$@\" >&2", OPENR_PROGRAM, "top"}, "/bin/sh");
  EXPECT_TRUE(top.WaitFor(one + " on "));
  EXPECT_TRUE(top.WaitFor(two + " on "));
  first->Signal(SIGINT);
  EXPECT_TRUE(top.WaitUntil([&] { return IsSaidToHaveEnded(one, top.heard()); }));
  top.Signal(SIGINT);
  EXPECT_EQ(top.Finish().status, 0) << top.heard();
}

// Two listeners watch: `quick` reads everything, the other listener is stopped.
TEST(TopTest, WatchingChangesNothing) {
  const Words flags = {"--for", "6s", "--body", "ideal"};
  const RecordedRun one = Record(flags);
  ProgramRun quick(
      Words{"-c", "exec \"$0\" \"$@\" >&2", OPENR_PROGRAM, "top", "--interval", "100ms"},
      "/bin/sh");
  ProgramRun stopped({"top"});
  const std::string before = RunName("before");
  {  // both listeners are known to listen after this
    const auto run = StartRun(before, {"--monitor"});
    ASSERT_TRUE(quick.WaitFor(before + " on "));
    ASSERT_TRUE(stopped.WaitForOutput(before + " on "));
  }
  stopped.Signal(SIGSTOP);
  const auto watched = [&](const std::string& name, const Words& more) {
    const ScratchFolder folder;
    const ProgramResult result =
        RunProgram(Words{"run", "--rate", "2", "--no-panel", "--rc-port", "0", "--json",
                         "--run-name", name, "--record", folder.File("r")} +
                   flags + more);
    EXPECT_TRUE(quick.WaitFor(name + " on "));
    return RecordedRun{result.status, result.err, folder.Read("r"),
                       json::parse(result.out, nullptr, false)};
  };
  ExpectSame(one, watched(RunName("alone"), {"--monitor"}));
  ExpectSame(one, watched(RunName("placed"), Isolated({"JointMover", "Controller"})));
}

RunStatusList::Run MadeUp() {
  RunStatusList::Run run;
  run.status.run = "dog";
  run.status.host = "den";
  run.status.pid = 7;
  run.status.virtual_us = 1'500'000;
  run.status.x_real_time = 1;
  run.status.messages_per_s = 250;
  run.status.waiting = 3;
  run.status.processes = {{"legs", "yard", 9, ""}};
  RunStatus::Object mover{0, "Mover", "legs", "standing",       128, 40, 12.5,
                          2, 3,       5,      {4, 90, 120, 130}};
  RunStatus::Object brain{0, "Brain", "", "", 64, 0, 0, 0, 0, 0, {}};
  run.status.objects = {mover, brain};
  return run;
}

TEST(TopViewTest, TheTableHasALineForEachObject) {
  EXPECT_EQ(TopText({MadeUp()}, 1),
            "dog on den (pid 7): t=1.500 s, 1.00 x real time, 250 messages/s, 3 waiting\n"
            "  OBJECT  PROCESS  HOST  PID  PRIO  MSG/S  MEAN us  P99 us  QUEUE  DROPS  STATE\n"
            "  Mover   legs     yard    9   128   12.5       90     120      3      2  standing\n"
            "  Brain   -        den     7    64    0.0        -       -      0      0\n");
}

TEST(TopViewTest, WithoutARunTheFlagsAreNamedWithWhichItWouldBeHeard) {
  EXPECT_THAT(TopText({}, 1, 80), HasSubstr("no run was heard yet"));
  EXPECT_THAT(TopText({}, 1, 80), HasSubstr("--monitor"));
}

// 80 columns show only whole columns.
TEST(TopViewTest, ANarrowScreenHasTheColumnsThatMatterMost) {
  RunStatusList::Run run = MadeUp();
  run.status.objects[0].state = "plays WALK.MTN for the third time";
  EXPECT_EQ(TopText({run}, 1, 80),
            "dog on den (pid 7): t=1.500 s, 1.00 x real time, 250 messages/s, 3 waiting\n"
            "  OBJECT  PROCESS  HOST  PID  MSG/S  MEAN us  P99 us  QUEUE  DROPS  STATE\n"
            "  Mover   legs     yard    9   12.5       90     120      3      2  plays WALK.M\n"
            "  Brain   -        den     7    0.0        -       -      0      0\n");
  EXPECT_EQ(TopText({run}, 1, 50),
            "dog on den (pid 7): t=1.500 s, 1.00 x real time,\n"
            "    250 messages/s, 3 waiting\n"
            "  OBJECT  PROCESS  MSG/S  QUEUE  STATE\n"
            "  Mover   legs      12.5      3  plays WALK.MTN fo\n"
            "  Brain   -          0.0      0\n");
  for (const size_t columns : {40u, 60u, 100u, 200u}) {
    std::istringstream lines(TopText({run}, 1, columns));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), columns) << line;
  }
}

TEST(TopViewTest, AnObjectThatIsLostHasNoOtherState) {
  RunStatusList::Run run = MadeUp();
  run.status.processes[0].lost = "process 'legs' (pid 9) was killed by signal 9";
  EXPECT_THAT(TopText({run}, 1), HasSubstr("  2  lost\n  Brain"));
  EXPECT_THAT(TopText({run}, 1), Not(HasSubstr("standing")));
}

TEST(TopViewTest, ObjectsWithoutRoomAreCounted) {
  RunStatusList::Run run = MadeUp();
  EXPECT_THAT(TopText({run}, 1), Not(HasSubstr("more objects")));
  run.status.objects_left_out = 904;
  EXPECT_THAT(TopText({run}, 1), HasSubstr("\n  ... 904 more objects: a run tells of 2\n"));
  EXPECT_EQ(TopJson({run}, 1)["runs"][0]["objects_left_out"], 904);
}

TEST(TopViewTest, ARunWithoutNewStatusIsShownAsSilent) {
  EXPECT_THAT(TopText({MadeUp()}, 2), Not(HasSubstr("silent")));
  EXPECT_THAT(TopText({MadeUp()}, 5), HasSubstr("; silent for 5 s: "));
  EXPECT_EQ(TopJson({MadeUp()}, 5)["runs"][0]["silent_s"], 5);
}

TEST(TopViewTest, ARunThatIsGoneIsShownAsEndedAndThenRemoved) {
  RunStatusList runs;
  runs.Update({MadeUp().status}, 1);
  RunStatus gone;
  gone.run = "dog";
  gone.host = "den";
  gone.pid = 7;
  gone.has_ended = true;
  runs.Update({gone}, 11);  // the lease of the run has ended
  ASSERT_EQ(runs.All().size(), 1u);
  EXPECT_THAT(TopText(runs.All(), 20), HasSubstr("; ended\n"));
  EXPECT_EQ(runs.All()[0].status.objects.size(), 2u) << "what was heard last is shown";
  RunStatus told = MadeUp().status;
  told.has_ended = true;
  told.end = "ended by time: --for 1s is over";
  runs.Update({told}, 12);
  EXPECT_THAT(TopText(runs.All(), 20), HasSubstr("; ended by time: --for 1s is over\n"));
  EXPECT_EQ(TopJson(runs.All(), 20)["runs"][0]["end"], "ended by time: --for 1s is over");
  runs.RemoveEnded(14);
  EXPECT_FALSE(runs.empty());
  runs.RemoveEnded(40);
  EXPECT_TRUE(runs.empty());
}

TEST(TopViewTest, ControlBytesOfNamesAreShownAsQuestionMarks) {
  RunStatus status = MadeUp().status;
  status.objects[0].name = "a\x1b[2Jb";
  RunStatusList runs;
  runs.Update({status}, 1);
  const std::string text = TopText(runs.All(), 1);
  EXPECT_THAT(text, HasSubstr("a?[2Jb"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

TEST(TopViewTest, TheTableFitsTheScreen) {
  EXPECT_EQ(OnScreen("one\ntwo\nthree\n", 3, 4), "one\x1b[K\r\ntwo\x1b[K\r\nthre\x1b[K\x1b[J");
  EXPECT_EQ(OnScreen("one\ntwo\nthree\n", 2, 80), "one\x1b[K\r\n... 2 more lines\x1b[K\x1b[J");
}

}  // namespace
}  // namespace openr_host

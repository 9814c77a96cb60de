// Tests of the programs when their standard streams are closed, full or read by nobody, and when
// their files cannot be written.
#include <gmock/gmock.h>
#include <stdlib.h>

#include <nlohmann/json.hpp>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;

std::string ProgramOf(const std::string& name) {
  return (fs::path(OPENR_PROGRAM).parent_path() / name).string();
}

// Runs a script of bash; $openr is the program, $rest what a short run needs.
ProgramResult Script(const std::string& script) {
  const std::string start =
      std::string("openr=") + OPENR_PROGRAM + "\nrest='--rate max --rc-port 0 --no-panel'\n";
  return ProgramRun({"-c", start + script}, "/bin/bash").Finish();
}

// A stick whose object says something, and a recording of a run on it.
struct Recorded {
  Recorded() {
    folder.MakeTrouble("print");
    const ProgramResult result =
        Script("$openr run $rest --for 1s --stick " + stick() + " --record " + file());
    EXPECT_EQ(result.status, 0) << result.err;
  }
  std::string stick() const { return folder.path(); }
  std::string file() const { return files.File("run.trace"); }
  ScratchFolder folder, files;
};

TEST(LostOutputTest, ARunWhoseMessagesNobodyReadsGoesToItsEnd) {
  const ScratchFolder stick, files;
  stick.MakeTrouble("print");
  const std::string run =
      "$openr run $rest --for 2s --stick " + stick.path() + " --report " + files.File("r.json");
  for (const char* const lost : {" 2>&1 | true", " 2>&1 | head -1", " 2>/dev/full", " 2>&-"}) {
    fs::remove(files.File("r.json"));
    const ProgramResult result = Script(run + lost + "\nexit ${PIPESTATUS[0]}");
    EXPECT_EQ(result.status, 0) << lost << result.err;
    ASSERT_TRUE(json::accept(files.Read("r.json"))) << lost;
    EXPECT_EQ(json::parse(files.Read("r.json"))["virtual_time_s"], 2.0) << lost;
  }
}

TEST(LostOutputTest, HashesDoNotDependOnWhoReadsTheConsole) {
  const ScratchFolder stick, files;
  stick.MakeTrouble("print");
  const std::string run = "$openr run $rest --for 1s --stick " + stick.path() + " --report ";
  Script(run + files.File("a.json"));
  Script(run + files.File("b.json") + " 2>/dev/full");
  EXPECT_EQ(json::parse(files.Read("a.json"))["trace_hash"],
            json::parse(files.Read("b.json"))["trace_hash"]);
  EXPECT_EQ(json::parse(files.Read("a.json"))["state_hash"],
            json::parse(files.Read("b.json"))["state_hash"]);
}

TEST(LostOutputTest, ClosedStreamsDoNotGetIntoFiles) {
  const ScratchFolder stick, files;
  stick.MakeTrouble("print");
  const ProgramResult result =
      Script("$openr run $rest --for 1s --stick " + stick.path() + " --record " +
             files.File("r.trace") + " --report " + files.File("r.json") + " <&- >&- 2>&-");
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(json::accept(files.Read("r.json")));
  EXPECT_EQ(files.Read("r.trace").find("said by an object"), std::string::npos);
  const ProgramResult replay = Script("$openr replay " + files.File("r.trace"));
  EXPECT_EQ(replay.status, 0) << replay.err;
}

TEST(LostOutputTest, ToolsWithoutStreamsMakeTheSameFiles) {
  const ScratchFolder folder;
  folder.Write("stub.cfg",
               "ObjectName : Small\nNumOfOSubject : 1\nNumOfOObserver : 1\n"
               "Service : \"Small.DummySubject.DoNotConnect.S\", null, null\n"
               "Service : \"Small.DummyObserver.DoNotConnect.O\", null, null\n");
  const std::string stubgen =
      ProgramOf("stubgen2") + " " + folder.File("stub.cfg") + " -o " + folder.path();
  EXPECT_EQ(Script(stubgen + "/a").status, 0);
  EXPECT_EQ(Script(stubgen + "/b <&- >&- 2>&-").status, 1) << "its list cannot be printed";
  for (const char* const name : {"def.h", "entry.h", "SmallStub.cc"}) {
    EXPECT_NE(folder.Read(std::string("a/") + name), "") << name;
    EXPECT_EQ(folder.Read(std::string("a/") + name), folder.Read(std::string("b/") + name));
  }
  const std::string gzcp = ProgramOf("openr-sdk") + " gzcp " + folder.File("stub.cfg") + " ";
  EXPECT_EQ(Script(gzcp + folder.File("x.gz") + " <&- >&- 2>&-").status, 0);
  EXPECT_EQ(Script("gzip -dc " + folder.File("x.gz")).out, folder.Read("stub.cfg"));
}

// Commands whose product goes to standard output.
std::vector<std::string> Answering(const Recorded& recorded) {
  const std::string mtn = std::string(OPENR_STICK) + "/OPEN-R/MW/DATA/P/WALK.MTN";
  const std::string step = "printf 'step\\nback\\nstep\\nquit\\n' | $openr replay --step ";
  return {"$openr trace " + recorded.file(),
          "$openr trace --format csv " + recorded.file(),
          "$openr trace --format perfetto " + recorded.file(),
          "$openr replay --json " + recorded.file(),
          step + recorded.file(),
          "$openr run $rest --for 100ms --json --stick " + recorded.stick(),
          "$openr explore --runs 2 --for 100ms --jobs 1 --stick " + recorded.stick(),
          "$openr explore --runs 2 --for 100ms --jobs 1 --json --stick " + recorded.stick(),
          "$openr graph --stick " + recorded.stick(),
          "$openr graph --format json --stick " + recorded.stick(),
          "$openr mtn info " + mtn,
          "$openr mtn check --json " + mtn,
          "$openr mtn dump " + mtn,
          "$openr log csv " OPENR_TEST_DATA "/walk.log",
          "$openr log compare " OPENR_TEST_DATA "/walk.log",
          "$openr check --json " + recorded.stick(),
          "$openr help run",
          "$openr run --help",
          "$openr --version",
          "$openr version --json",
          ProgramOf("openr-sdk") + " --help"};
}

TEST(LostOutputTest, AnAnswerThatCannotBeWrittenIsNamedAndExitsOne) {
  const Recorded recorded;
  const std::pair<const char*, const char*> lost[] = {
      {" >/dev/full", "No space left on device"},
      {" >&-", "Bad file descriptor"},
  };
  for (const std::string& command : Answering(recorded)) {
    for (const auto& [where, why] : lost) {
      const ProgramResult result = Script(command + where);
      EXPECT_EQ(result.status, 1) << command << where << result.err;
      EXPECT_THAT(result.err,
                  HasSubstr(std::string(": standard output: cannot be written: ") + why + "\n"))
          << command << where;
    }
  }
}

// Runs a script of bash that can write to descriptor 9, a pipe whose reader has gone.
ProgramResult ScriptWithoutReader(const std::string& script) {
  return Script("exec 9> >(exec true)\nwait $!\n" + script);
}

// The status is that of other programs, which SIGPIPE ends: 128 + 13.
TEST(LostOutputTest, AnAnswerWhoseReaderHasGoneEndsWithoutAWord) {
  const Recorded recorded;
  for (const std::string& command : Answering(recorded)) {
    const ProgramResult result = ScriptWithoutReader(command + " >&9");
    EXPECT_EQ(result.status, 141) << command << result.err;
    EXPECT_THAT(result.err, Not(HasSubstr("standard output"))) << command;
    EXPECT_THAT(result.err, Not(HasSubstr("Broken pipe"))) << command;
  }
}

TEST(LostOutputTest, ARunWhoseReaderHasGoneWritesItsFiles) {
  const ScratchFolder stick, files;
  stick.MakeTrouble("print");
  const ProgramResult result =
      ScriptWithoutReader("$openr run $rest --for 1s --json --stick " + stick.path() +
                          " --report " + files.File("r.json") + " >&9");
  EXPECT_EQ(result.status, 141) << result.err;
  EXPECT_TRUE(json::accept(files.Read("r.json")));
}

TEST(LostOutputTest, AnAnswerWithoutAnEndEndsWhenNobodyReadsIt) {
  ProgramRun run({"run", "--rate", "max", "--no-panel", "--rc-port", "0"});
  ASSERT_TRUE(run.WaitFor("openr rc 127.0.0.1:"));
  const std::string said = run.heard();
  const size_t at = said.find("127.0.0.1:");
  const std::string address = said.substr(at, said.find(' ', at) - at);
  const ProgramResult result = Script("$openr rc " + address +
                                      " sensors --watch --every 1ms | head -1\n"
                                      "exit ${PIPESTATUS[0]}");
  EXPECT_EQ(result.status, 141);
  EXPECT_EQ(result.err, "");
  const ProgramResult two =
      ScriptWithoutReader("$openr rc " + address + " --with " + address + " info >&9");
  EXPECT_EQ(two.status, 141);
  EXPECT_EQ(two.err, "");
}

// Commands that write a file, up to its name.
std::vector<std::string> Writing(const std::string& stick) {
  const std::string run = "$openr run $rest --for 100ms --stick " + stick;
  const std::string explore = "$openr explore --runs 2 --for 100ms --jobs 1 --stick " + stick;
  return {run + " --report",
          run + " --record",
          run + " --console",
          run + " --speaker",
          explore + " --console",
          "$openr graph --stick " + stick + " -o",
          run + " --snapshot size=32x32 -o"};
}

TEST(LostOutputTest, AFileThatCannotBeMadeIsAWrongCommandLine) {
  const ScratchFolder stick;
  stick.MakeTrouble("print");
  const std::pair<std::string, std::string> names[] = {
      {stick.File("none/a"), ": cannot be written: there is no such folder\n"},
      {stick.File("OPEN-R"), ": is a folder; name a file\n"},
      {stick.File("OPEN-R/MW/OBJS/README.TXT/a"), ": cannot be written: Not a directory\n"}};
  std::vector<std::string> commands = Writing(stick.path());
  commands.push_back("$openr explore --runs 1 --stick " + stick.path() + " -o");
  for (const std::string& command : commands) {
    for (const auto& [name, why] : names) {
      const ProgramResult result = Script(command + " " + name);
      EXPECT_EQ(result.status, 2) << command << " " << name;
      EXPECT_THAT(result.err, HasSubstr(name + why)) << command;
    }
  }
}

TEST(LostOutputTest, AFileThatCannotBeWrittenIsNamedAndExitsOne) {
  const Recorded recorded;
  for (const std::string& command : Writing(recorded.stick())) {
    const ProgramResult result = Script(command + " /dev/full");
    EXPECT_EQ(result.status, 1) << command;
    EXPECT_THAT(result.err, HasSubstr("/dev/full: c")) << command;
    EXPECT_THAT(result.err, HasSubstr(": No space left on device\n")) << command;
  }
}

TEST(LostOutputTest, AReportWithoutRoomLeavesTheGoodOne) {
  const ScratchFolder stick, files;
  stick.MakeTrouble("nothing");
  files.Write("r.json", "good");
  const ProgramResult result = Script("ulimit -f 1\n$openr run $rest --for 100ms --stick " +
                                      stick.path() + " --report " + files.File("r.json"));
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr(files.File("r.json") + ": cannot be written: File too large"));
  EXPECT_EQ(files.Read("r.json"), "good");
}

TEST(LostOutputTest, StandardOutputCanBeNamedAsAFile) {
  const ScratchFolder stick;
  stick.MakeTrouble("print");
  const std::string run = "$openr run $rest --for 100ms --stick " + stick.path();
  EXPECT_TRUE(json::accept(Script(run + " --report /dev/stdout").out));
  EXPECT_TRUE(json::accept(Script(run + " --report /dev/fd/1 | cat").out));
  EXPECT_THAT(Script(run + " --console /dev/stdout").out, HasSubstr("printed by an object\n"));
  EXPECT_TRUE(json::accept(Script(run + " --report /dev/stderr 2>&1 >/dev/null | "
                                        "sed -n '/^{/,/^}/p'")
                               .out));
  // Behind what is there already, as the shell means it.
  Script("{ echo before; $openr graph -o /dev/stdout --stick " + stick.path() +
         "; echo after; } > " + stick.File("all.txt"));
  const std::string all = stick.Read("all.txt");
  EXPECT_EQ(all.find("before\ndigraph"), 0u) << all;
  EXPECT_THAT(all, EndsWith("}\nafter\n"));
}

TEST(LostOutputTest, ASecondRunIntoARecordingIsRefused) {
  const ScratchFolder stick, files;
  stick.MakeTrouble("print");
  const std::string file = files.File("r.trace");
  const std::vector<std::string> record = {"run",     "--no-panel", "--rc-port", "0",
                                           "--stick", stick.path(), "--record",  file};
  ProgramRun first(record);
  ASSERT_TRUE(first.WaitFor("Trouble is running"));
  const ProgramResult second = RunProgram(record);
  EXPECT_EQ(second.status, 1);
  EXPECT_EQ(second.err.substr(second.err.rfind("openr: ")),
            "openr: " + file + ": is being written by process " + std::to_string(first.pid()) +
                " (openr); name another file, or wait for its end\n");
  const ProgramResult other = RunProgram(
      {"run", "--for", "100ms", "--rc-port", "0", "--stick", stick.path(), "--report", file});
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr(file + ": is being written by process "));
  first.Signal(SIGINT);
  EXPECT_EQ(first.Finish().status, 0);
  EXPECT_EQ(Script("$openr replay " + file).status, 0) << "the first one has all of its recording";

  ProgramRun killed(record);
  ASSERT_TRUE(killed.WaitFor("Trouble is running"));
  killed.Signal(SIGKILL);
  killed.Finish();
  const ProgramResult third =
      Script("$openr run $rest --for 100ms --stick " + stick.path() + " --record " + file);
  EXPECT_EQ(third.status, 0) << third.err;
}

TEST(LostOutputTest, ATerminalThatClosesDoesNotEndARunWithAnEndOfItsOwn) {
  const ScratchFolder stick;
  stick.MakeTrouble("print");
  ProgramRun run({"run", "--for", "1500ms", "--no-panel", "--rc-port", "0", "--stick", stick.path(),
                  "--json"});
  ASSERT_TRUE(run.WaitFor("Trouble is running"));
  run.Signal(SIGHUP);
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(json::parse(result.out)["virtual_time_s"], 1.5);
}

TEST(LostOutputTest, ATerminalThatClosesIsThePauseButtonOfARunWithoutAnEnd) {
  const ScratchFolder stick;
  stick.MakeTrouble("print");
  ProgramRun run({"run", "--no-panel", "--rc-port", "0", "--stick", stick.path(), "--json"});
  ASSERT_TRUE(run.WaitFor("Trouble is running"));
  run.Signal(SIGHUP);
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("pause button pressed"));
  EXPECT_TRUE(json::accept(result.out)) << result.out;
}

}  // namespace
}  // namespace openr_host

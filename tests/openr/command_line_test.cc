// Tests of the command lines that the program refuses, and of its answers.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/process.h"
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

// The same with --json: `text` is on standard error and in the answer's field "error".
void ExpectJsonRefusal(std::vector<std::string> arguments, int status, const std::string& text) {
  arguments.push_back("--json");
  const ProgramResult result = RunProgram(arguments);
  EXPECT_EQ(result.status, status) << result.err;
  EXPECT_NE(result.err.find(text), std::string::npos) << result.err;
  ASSERT_TRUE(nlohmann::json::accept(result.out)) << result.out;
  const auto error = nlohmann::json::parse(result.out)["error"].get<std::string>();
  EXPECT_NE(error.find(text), std::string::npos) << error;
}

TEST(CommandLineTest, WithoutACommandItListsThem) {
  ExpectRefusal({}, 2, "a command is missing; there are run, join, top, poke, attach, panel, rc, ");
  ExpectRefusal(
      {"mtn"}, 2,
      "a command is missing after 'mtn'; there are info, check, dump, from-csv, plot, oda");
}

TEST(CommandLineTest, AnUnknownCommandIsNamedAndTheNearestOneSuggested) {
  ExpectRefusal({"rnu"}, 2,
                "'rnu' is no command; there are run, join, top, poke, attach, panel, rc, ");
  ExpectRefusal({"rnu"}, 2, "did you mean 'run'?");
  ExpectRefusal({"rc", "127.0.0.1:1", "mvoe", "0", "3"}, 2, "'rc mvoe' is no command");
  ExpectRefusal({"mtn", "chekc", "a.mtn"}, 2, "did you mean 'check'?");
}

TEST(CommandLineTest, TheVersionCanBeAskedForAsAFlag) {
  const ProgramResult result = RunProgram({"--version"});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.out, RunProgram({"version"}).out);
}

// Most runs have one process and no sound file, so they need neither Cyclone DDS with its OpenSSL
// and iceoryx nor libsndfile with its codecs, and loading them takes a fifth of the start.  With
// this variable, the dynamic linker prints what it loads with the program.
TEST(CommandLineTest, LibrariesThatMostRunsDoNotNeedAreNotLoadedWithTheProgram) {
  setenv("LD_TRACE_LOADED_OBJECTS", "1", 1);
  const std::string libraries = RunProgram({}).out;
  unsetenv("LD_TRACE_LOADED_OBJECTS");
  EXPECT_NE(libraries.find("libopenr_runtime.so"), std::string::npos) << libraries;
  for (const char* const name : {"libddsc", "libssl", "libiceoryx", "libsndfile", "libopus"})
    EXPECT_EQ(libraries.find(name), std::string::npos) << libraries;
}

TEST(CommandLineTest, HelpTellsOfTheProgramAndOfItsCommands) {
  const ProgramResult program = RunProgram({"help"});
  EXPECT_EQ(program.status, 0);
  EXPECT_EQ(program.out, RunProgram({"--help"}).out);
  const ProgramResult play = RunProgram({"help", "rc", "mtn", "play"});
  EXPECT_EQ(play.status, 0);
  EXPECT_NE(play.out.find("\nUsage: openr rc HOST mtn play [OPTIONS] FILE\n"), std::string::npos)
      << play.out;
  // --help says the same.
  EXPECT_EQ(RunProgram({"rc", "127.0.0.1", "mtn", "play", "--help"}).out, play.out);
  EXPECT_NE(play.out.find("--loops"), std::string::npos) << play.out;
}

// Without HOST, the program would take `move` for HOST and show the help of rc.
TEST(CommandLineTest, HelpOfARemoteCommandNeedsNoHost) {
  EXPECT_EQ(RunProgram({"rc", "move", "--help"}).out, RunProgram({"help", "rc", "move"}).out);
  EXPECT_EQ(RunProgram({"rc", "mtn", "play", "--help"}).out,
            RunProgram({"help", "rc", "mtn", "play"}).out);
  EXPECT_EQ(RunProgram({"rc", "127.0.0.1", "move", "neck_pan", "--help"}).out,
            RunProgram({"help", "rc", "move"}).out);
  EXPECT_EQ(RunProgram({"rc", "--help"}).out, RunProgram({"help", "rc"}).out);
}

TEST(CommandLineTest, HelpAboutAnUnknownCommandIsRefused) {
  ExpectRefusal({"help", "rc", "sped"}, 2, "did you mean 'speed'?");
}

TEST(CommandLineTest, WrongFlagsGetASuggestion) {
  ExpectRefusal({"run", "--until_idle"}, 2,
                "there is no flag --until_idle; did you mean "
                "'--until-idle'?");
}

TEST(CommandLineTest, WhoAsksForJsonGetsErrorsAsJson) {
  ExpectJsonRefusal({"rnu"}, 2, "'rnu' is no command");
  ExpectJsonRefusal({"run", "--for", "20"}, 2, "'20' has no unit");
  ExpectJsonRefusal({"run", "--world", "nowhere.json"}, 2, "--world nowhere.json: No such file");
  ExpectJsonRefusal({"mtn", "info", "nowhere.mtn"}, 1, "No such file or directory");
  ExpectJsonRefusal({"mtn", "check", "nowhere.mtn"}, 1, "No such file or directory");
  ExpectJsonRefusal({"rc", "127.0.0.1:1", "info"}, 1, "127.0.0.1:1: no program listens there");
}

TEST(CommandLineTest, AFolderIsNoWorldAndNoMotion) {
  const ScratchFolder folder;
  folder.Write("KICK.MTN", "");
  const std::string text = folder.path() + ": is a folder; give a ";
  ExpectRefusal({"run", "--world", folder.path()}, 2,
                "--world " + text + "world file (docs/worlds.md)");
  for (const char* command : {"info", "check", "dump"}) {
    ExpectRefusal({"mtn", command, folder.path()}, 1,
                  text + "motion file, such as " + folder.File("KICK.MTN"));
  }
}

TEST(CommandLineTest, AnInputThatCannotBeReadIsNamedWithItsFlagAndTheReason) {
  const ScratchFolder folder;
  const std::vector<std::vector<std::string>> flags = {
      {"run", "--world"},     {"run", "--cost"},        {"run", "--mic"},
      {"run", "--stdin"},     {"run", "--placement"},   {"run", "--dds-config"},
      {"explore", "--world"}, {"explore", "--cost"},    {"explore", "--replay"},
      {"graph", "--world"},   {"explore", "--property"}};
  for (std::vector<std::string> words : flags) {
    const std::string flag = words[1];
    words.push_back("./nothing");
    ExpectRefusal(words, 2, "openr: " + flag + " ./nothing: No such file or directory\n");
    words.back() = folder.path();
    ExpectRefusal(words, 2, "openr: " + flag + " " + folder.path() + ": is a folder; give a ");
  }
  ExpectRefusal({"run", "--images", "./nothing"}, 2, "--images ./nothing: No such file");
  folder.Write("a.txt", "");
  ExpectRefusal({"run", "--images", folder.File("a.txt")}, 2,
                "--images " + folder.File("a.txt") + ": is a file; give a folder of pictures");
}

TEST(CommandLineTest, ARecordingThatCannotBeReadIsNamedWithTheReason) {
  const ScratchFolder folder;
  for (const char* command : {"trace", "replay"}) {
    ExpectRefusal({command, "nowhere.rec"}, 1, "nowhere.rec: No such file or directory\n");
    ExpectRefusal({command, folder.path()}, 1,
                  folder.path() + ": is a folder; give a recording of openr run --record");
  }
}

TEST(CommandLineTest, FilesThatCannotBeWrittenAreRefusedBeforeTheRun) {
  const std::string text = "/nowhere/a: cannot be written: there is no such folder";
  ExpectRefusal({"run", "--report", "/nowhere/a"}, 2, "--report: " + text);
  ExpectRefusal({"run", "--console", "/nowhere/a"}, 2, "--console: " + text);
  ExpectRefusal({"run", "--snapshot", "t=end", "-o", "/nowhere/a"}, 2, text);
  ExpectRefusal({"graph", "-o", "/nowhere/a"}, 2, text);
}

TEST(CommandLineTest, APictureAfterTheEndOfTheRunIsRefused) {
  const ScratchFolder folder;
  ExpectRefusal({"run", "--for", "1s", "--snapshot", "t=2s", "-o", folder.File("a.png")}, 2,
                "t=2s is after the end of the run (--for 1s); t=end is its end");
  EXPECT_EQ(folder.Read("a.png"), "");
}

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

TEST(CommandLineTest, ThePanelHasAPortAndIsEitherThereOrNot) {
  ExpectRefusal({"run", "--panel", "--no-panel"}, 2, "--no-panel");
  ExpectRefusal({"run", "--panel", "127.0.0.1:8210"}, 2, "'127.0.0.1:8210' is one word too many");
  ExpectRefusal({"run", "--panel-port", "70000"}, 2, "70000");
  ExpectRefusal({"panel", "--port", "x"}, 2, "--port");
  ExpectRefusal({"panel", "--run", "nobody"}, 1, "there is no run 'nobody'");
}

TEST(CommandLineTest, DurationsNeedAUnit) {
  ExpectRefusal({"run", "--for", "20"}, 2, "'20' has no unit; write 20s or 20ms");
}

TEST(CommandLineTest, APortIsANumber) {
  for (const std::string port : {"abc", "-1", "65536", "1x"})
    ExpectRefusal({"run", "--rc-port", port}, 2,
                  "--rc-port: '" + port +
                      "' is no port; give a number from 1 to 65535, or 0 for "
                      "any free port");
}

TEST(CommandLineTest, ATraceFromATimeAfterItsEndIsRefused) {
  ExpectRefusal({"trace", "a.rec", "--from", "2s", "--until", "1s"}, 2,
                "--from: 2s is after --until 1s, so there is nothing to show");
}

TEST(CommandLineTest, NothingButTheAnswerGoesToTheStandardOutputOfJson) {
  for (const std::string flag : {"--report", "--record", "--console", "--speaker"})
    ExpectJsonRefusal({"run", flag, "/dev/stdout"}, 2,
                      flag + ": /dev/stdout is where --json writes the report");
  const ProgramResult result = RunProgram(
      {"run", "--for", "100ms", "--rate", "max", "--rc-port", "0", "--report", "/dev/stdout"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_TRUE(nlohmann::json::accept(result.out)) << result.out;
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
  ExpectRefusal({"run", "--stick", folder.path()}, 1,
                "holds no folder OPEN-R; a stick is a folder like the root of a Memory Stick\n");
}

// field-notes.md 15.1: the folder around the stick, or a folder of the stick itself.
TEST(CommandLineTest, AFolderBesideAStickIsRefusedWithTheNameOfTheStick) {
  const ScratchFolder folder;
  folder.Write("MS/OPEN-R/MW/CONF/OBJECT.CFG", "");
  folder.Write("other/file", "");
  for (const char* wrong : {"", "MS/OPEN-R"}) {
    ExpectRefusal({"run", "--stick", folder.File(wrong)}, 1,
                  "did you mean " + folder.File("MS") + "?\n");
  }
  ExpectRefusal({"run", "--stick", folder.File("other")}, 1, "root of a Memory Stick\n");
  folder.Write("MS2/open-r/MW/CONF/OBJECT.CFG", "");  // with two sticks, no stick is proposed
  ExpectRefusal({"run", "--stick", folder.File("")}, 1, "root of a Memory Stick\n");
}

TEST(CommandLineTest, ANoteTellsOfAStickInTheFolderThatIsNotRun) {
  const ScratchFolder folder;
  folder.Write("MS/OPEN-R/MW/CONF/OBJECT.CFG", "");
  const ProcessResult result =
      RunProcess({OPENR_PROGRAM, "run", "--for", "8ms", "--no-panel", "--rc-port", "0"},
                 {.folder = folder.path(), .captures_error = true, .captures_out = true});
  EXPECT_TRUE(result.good()) << result.output;
  EXPECT_NE(result.output.find("note: the default stick runs; --stick MS runs the stick of this "
                               "folder\n"),
            std::string::npos)
      << result.output;
}

TEST(CommandLineTest, AStickThatIsNotThereOrNoFolderIsRefused) {
  const ScratchFolder folder;
  folder.Write("file", "");
  ExpectRefusal({"run", "--stick", folder.File("none")}, 2, "none: No such file or directory\n");
  ExpectRefusal({"graph", "--stick", folder.File("file")}, 2,
                "is a file; give a folder that holds OPEN-R\n");
  ExpectRefusal({"explore", "--stick", folder.File("none")}, 2, "No such file or directory\n");
}

TEST(CommandLineTest, AStickWithoutObjectsIsRefused) {
  const ScratchFolder folder;
  folder.Write("OPEN-R/MW/CONF/CONNECT.CFG", "");
  ExpectRefusal({"run", "--stick", folder.path(), "--no-panel"}, 1, "OBJECT.CFG: No such file");
}

TEST(CommandLineTest, AWorldThatCannotBeReadIsRefused) {
  ExpectRefusal({"run", "--world", "nowhere.json"}, 2,
                "--world nowhere.json: No such file or directory\n");
}

TEST(CommandLineTest, ControlBytesOfAFileDoNotReachTheTerminal) {
  const ScratchFolder folder;
  folder.Write("w.json", R"({"schema": "openr-host world 2", "name": "w",
                             "things": [{"shape": "a\u001b[2Jb", "name": "c"}]})");
  ExpectRefusal({"run", "--no-panel", "--world", folder.File("w.json")}, 1,
                "things[0].shape: is 'a?[2Jb'; known are");
}

// The JSON library copies JSON by recursion, so a copy of this JSON would overflow the stack.
TEST(CommandLineTest, AWorldOrAScheduleThatIsNestedTooDeeplyIsRefused) {
  constexpr size_t kLevels = 1'000'000;  // enough to overflow the stack
  const ScratchFolder folder;
  folder.Write("deep.json", std::string(kLevels, '[') + std::string(kLevels, ']'));
  const std::string file = folder.File("deep.json");
  ExpectRefusal({"run", "--no-panel", "--world", file}, 1,
                "openr: " + file + ": is nested more than 100 levels deep\n");
  ExpectRefusal({"explore", "--replay", file}, 1,
                "openr: " + file + ": the JSON is nested more than 100 levels deep\n");
}

TEST(CommandLineTest, UnknownRobotsAreRefused) {
  ExpectRefusal({"run", "--robot", "ers1000"}, 2, "ers1000");
}

TEST(CommandLineTest, AMotionThatCannotBeReadIsNamed) {
  for (const char* command : {"info", "check", "dump"}) {
    ExpectRefusal({"mtn", command, "nowhere.mtn"}, 1,
                  "openr: nowhere.mtn: No such file or directory\n");
  }
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

TEST(CommandLineTest, SeveralMotionsAreOneJsonDocument) {
  const std::string sit = std::string(OPENR_STICK) + "/OPEN-R/MW/DATA/P/SIT.MTN";
  for (const char* verb : {"check", "info"}) {
    const ProgramResult result = RunProgram({"mtn", verb, "--json", sit, "nowhere.mtn"});
    EXPECT_EQ(result.status, 1);
    const auto document = nlohmann::json::parse(result.out);
    ASSERT_EQ(document.size(), 2u) << document;
    EXPECT_EQ(document[0]["file"], sit);
    EXPECT_EQ(document[1]["file"], "nowhere.mtn");
    EXPECT_NE(document[1]["error"], "");
  }
}

TEST(CommandLineTest, ASeedOutOfRangeIsRefused) {
  for (const char* seed : {"-1", "18446744073709551616", "1.5", "0x", "many"})
    ExpectRefusal({"run", "--for", "100ms", "--seed", seed}, 2, seed);
}

TEST(CommandLineTest, WhatIsNoPairOfAddressesIsRefusedWithWhatIsWrong) {
  const auto refuses = [](const std::string& pair, const std::string& words) {
    ExpectRefusal({"run", "--for", "100ms", "--ip", pair}, 2, words);
  };
  refuses("10.0.1.2", "'10.0.1.2' is no pair of addresses; write ROBOT=HOST");
  refuses("10.0.1.2=mypc", "'mypc' is no address");
  refuses("10.0.1.2=0.0.0.0", "'0.0.0.0' is no address of one computer");
  ExpectRefusal(
      {"run", "--for", "100ms", "--ip", "10.0.1.2=127.0.0.1", "--ip", "10.0.1.2=127.0.0.2"}, 2,
      "10.0.1.2 stands for 127.0.0.1 already");
}

TEST(CommandLineTest, TwoOutputsInOneFileAreRefused) {
  const ScratchFolder folder;
  const std::string file = folder.File("out");
  ExpectRefusal({"run", "--for", "100ms", "--report", file, "--console", file}, 2, file);
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(CommandLineTest, NobodyAtThePortIsExplained) {
  // Port 1 of loopback: no service of that kind runs there.
  ExpectRefusal({"rc", "127.0.0.1:1", "info"}, 1,
                "no program listens there; is 'openr run' running");
}

TEST(CommandLineTest, APortThatIsNoNumberIsRefused) {
  ExpectRefusal({"rc", "127.0.0.1:door", "info"}, 2, "has no port from 1 to 65535");
}

TEST(CommandLineTest, AnAddressOfIPv6IsRefused) {
  for (const char* address : {"::1", "[::1]", "[::1]:54000"}) {
    ExpectRefusal({"rc", address, "info"}, 2, "there are no IPv6 addresses: write 127.0.0.1:54000");
  }
}

TEST(CommandLineTest, LimitsOfSpeedAndAccelerationArePositive) {
  for (const char* command : {"speed", "accel"}) {
    for (const char* value : {"0", "-5"}) {
      ExpectRefusal({"rc", "127.0.0.1:1", command, "0", value}, 2, "it must be greater than 0");
    }
  }
  ExpectRefusal({"rc", "127.0.0.1:1", "move", "0", "nan"}, 2, "'nan' is no number of degrees");
}

TEST(CommandLineTest, KeyFramesPerVectorAreThoseTheRobotCanTake) {
  for (const char* number : {"3", "10", "-2"}) {
    ExpectRefusal({"rc", "127.0.0.1:1", "mtn", "play", "A.MTN", "--keyframes", number}, 2,
                  "say 2, 4, 6 or 8, or 0 for the robot's own choice");
  }
}

TEST(CommandLineTest, LightsAreOnOrOff) {
  ExpectRefusal({"rc", "127.0.0.1:1", "led", "0", "maybe"}, 2, "maybe");
}

}  // namespace
}  // namespace openr_host

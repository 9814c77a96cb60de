// openr rc with files of the stick, against a robot that runs: a run of the program, whose stick is
// a copy.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using nlohmann::json;

// Returns what a command says on a terminal, which is its standard output and error.
std::string SaidOnATerminal(const std::vector<std::string>& words) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  grantpt(terminal);
  unlockpt(terminal);
  const std::string name = ptsname(terminal);
  const int user = open(name.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
  const pid_t child = fork();
  if (child == 0) {
    dup2(user, STDOUT_FILENO);
    dup2(user, STDERR_FILENO);
    std::vector<char*> argv{const_cast<char*>(OPENR_PROGRAM)};
    for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    execv(OPENR_PROGRAM, argv.data());
    _exit(127);
  }
  close(user);
  std::string said;
  char buffer[4096];
  // At the end of the child reading fails, because nobody has the terminal open.
  for (ssize_t n; (n = read(terminal, buffer, sizeof buffer)) > 0;)
    said.append(buffer, static_cast<size_t>(n));
  close(terminal);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0) << said;
  return said;
}

class RcFilesTest : public testing::Test {
 protected:
  RcFilesTest() {
    std::filesystem::copy(OPENR_STICK, folder_.File("stick"),
                          std::filesystem::copy_options::recursive);
    robot_ = std::make_unique<ProgramRun>(
        std::vector<std::string>{"run", "--stick", folder_.File("stick"), "--rate", "max",
                                 "--no-panel", "--rc-port", "0", "--body", "ideal"});
    is_ready_ = robot_->WaitFor("openr rc 127.0.0.1:") && robot_->WaitFor("state: listening");
  }
  void SetUp() override { ASSERT_TRUE(is_ready_) << robot_->Finish().err; }

  std::vector<std::string> RcWords(std::vector<std::string> words) const {
    const std::string& text = robot_->heard();
    const size_t begin = text.find("127.0.0.1:");
    const std::string address = text.substr(begin, text.find(' ', begin) - begin);
    words.insert(words.begin(), {"rc", address, "--json"});
    return words;
  }
  ProgramResult RunRc(const std::vector<std::string>& words) const {
    return RunProgram(RcWords(words));
  }
  json AnswerOf(const std::vector<std::string>& words) const {
    const ProgramResult result = RunRc(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return result.status == 0 ? json::parse(result.out) : json::object();
  }
  // The error of a command that must fail.
  std::string ErrorOf(const std::vector<std::string>& words) const {
    const ProgramResult result = RunRc(words);
    EXPECT_EQ(result.status, 1) << result.out;
    return result.err;
  }
  static std::string OnStick(const std::string& name) { return "stick/OPEN-R/MW/" + name; }
  static std::string Shown(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos ? "" : text;
  }

  ScratchFolder folder_;
  std::unique_ptr<ProgramRun> robot_;
  bool is_ready_ = false;
};

TEST_F(RcFilesTest, AMotionGoesThereAndBack) {
  const std::string motion = folder_.Read(OnStick("DATA/P/WALK.MTN"));
  folder_.Write("mine.mtn", motion);
  const size_t before = AnswerOf({"mtn", "list"})["motions"].size();
  EXPECT_EQ(AnswerOf({"mtn", "upload", folder_.File("mine.mtn")})["name"], "MINE.MTN");
  EXPECT_EQ(folder_.Read(OnStick("DATA/P/MINE.MTN")), motion);
  const json list = AnswerOf({"mtn", "list"})["motions"];
  EXPECT_EQ(list.size(), before + 1);
  EXPECT_NE(
      std::find(list.begin(), list.end(), json{{"name", "MINE.MTN"}, {"bytes", motion.size()}}),
      list.end())
      << list;
  AnswerOf({"mtn", "download", "MINE.MTN", "-o", folder_.File("back.mtn")});
  EXPECT_EQ(folder_.Read("back.mtn"), motion);
  EXPECT_EQ(AnswerOf({"mtn", "delete", "mine.mtn"})["deleted"], "MINE.MTN");
  EXPECT_EQ(Shown(ErrorOf({"mtn", "delete", "MINE.MTN"}), "MINE.MTN: no such file"), "");
  EXPECT_EQ(AnswerOf({"mtn", "list"})["motions"].size(), before);
}

TEST_F(RcFilesTest, AControllerIsReplacedAndTheOldOneKept) {
  const std::string image = folder_.Read(OnStick("OBJS/CONTROLL.BIN"));
  const std::string other = folder_.Read(OnStick("OBJS/POWERMON.BIN"));
  folder_.Write("new.bin", other);
  EXPECT_EQ(AnswerOf({"controller", "upload", folder_.File("new.bin")})["bytes"], other.size());
  EXPECT_EQ(folder_.Read(OnStick("OBJS/CONTROLL.BIN")), other);
  EXPECT_EQ(folder_.Read(OnStick("OBJS/CONTROLL.OLD")), image);
}

TEST_F(RcFilesTest, AnUploadShowsItsProgressOnATerminalOnly) {
  const std::string image = folder_.Read(OnStick("OBJS/CONTROLL.BIN"));
  folder_.Write("new.bin", image);
  const std::vector<std::string> words = {"controller", "upload", folder_.File("new.bin")};
  const std::string said = SaidOnATerminal(RcWords(words));
  const std::string size = std::to_string((image.size() + 1023) / 1024);
  EXPECT_EQ(Shown(said, "openr: 0 of " + size + " KB of CONTROLL.BIN"), "");
  EXPECT_EQ(RunRc(words).err, "");
}

TEST_F(RcFilesTest, WhatAnUploadCannotReplaceIsCalledWhatItIs) {
  folder_.Write("dir.mtn", folder_.Read(OnStick("DATA/P/WALK.MTN")));
  folder_.Write("link.mtn", folder_.Read("dir.mtn"));
  folder_.Write("outside.mtn", "x");
  std::filesystem::create_directory(folder_.File(OnStick("DATA/P/DIR.MTN")));
  std::filesystem::create_symlink(folder_.File("outside.mtn"),
                                  folder_.File(OnStick("DATA/P/LINK.MTN")));
  EXPECT_EQ(Shown(ErrorOf({"mtn", "upload", folder_.File("dir.mtn")}),
                  "DIR.MTN: is a folder, and a file cannot replace it"),
            "");
  EXPECT_EQ(Shown(ErrorOf({"mtn", "upload", folder_.File("link.mtn")}),
                  "LINK.MTN: cannot be replaced; the stick does not allow it: it is open already, "
                  "or a link that leads out of the stick"),
            "");
  EXPECT_EQ(folder_.Read("outside.mtn"), "x");
  // Opening a FIFO would stop the run.
  folder_.Write("pipe.mtn", folder_.Read("dir.mtn"));
  ASSERT_EQ(mkfifo(folder_.File(OnStick("DATA/P/PIPE.MTN")).c_str(), 0600), 0);
  EXPECT_EQ(Shown(ErrorOf({"mtn", "upload", folder_.File("pipe.mtn")}),
                  "PIPE.MTN: cannot be replaced; the stick does not allow it"),
            "");
  EXPECT_EQ(Shown(ErrorOf({"mtn", "download", "PIPE.MTN"}), "PIPE.MTN: no such file"), "");
}

TEST_F(RcFilesTest, WrongFilesAreNamedWithTheCause) {
  folder_.Write("text.mtn", "hello");
  folder_.Write("robot.bin", std::string("\x7f"
                                         "ELF\1\1\1",
                                         7) +
                                 std::string(11, '\0') + std::string("\x8\0", 2) +
                                 std::string(80, '\0'));
  folder_.Write("longername.mtn", folder_.Read(OnStick("DATA/P/WALK.MTN")));
  EXPECT_EQ(Shown(ErrorOf({"mtn", "upload", folder_.File("text.mtn")}), "text.mtn: header"), "");
  EXPECT_EQ(Shown(ErrorOf({"mtn", "upload", folder_.File("none.mtn")}),
                  "none.mtn: No such file or directory"),
            "");
  EXPECT_EQ(Shown(ErrorOf({"mtn", "upload", folder_.File("longername.mtn")}), "8+3"), "");
  EXPECT_EQ(Shown(ErrorOf({"controller", "upload", folder_.File("robot.bin")}),
                  "robot.bin: is an image for the robot (MIPS); this robot needs one for "
                  "openr-host (x86-64)"),
            "");
  EXPECT_EQ(Shown(ErrorOf({"mtn", "download", "NONE.MTN"}), "NONE.MTN: no such file"), "");
}

TEST_F(RcFilesTest, ShutdownAnswersAndEndsTheRun) {
  EXPECT_EQ(AnswerOf({"shutdown"})["shuts_down"], true);
  const ProgramResult& end = robot_->Finish();
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(Shown(end.err, "ended by power-off: RCServer shut the robot down"), "");
}

TEST_F(RcFilesTest, ARebootStartsTheUploadedController) {
  AnswerOf({"controller", "upload", OPENR_IMAGES "/TIMERUN.BIN"});
  EXPECT_EQ(AnswerOf({"reboot"})["reboots"], true);
  EXPECT_TRUE(robot_->WaitFor("the robot is off, and boots again at t="));
  EXPECT_TRUE(robot_->WaitFor("the robot has booted again; all its images are new loads"));
  EXPECT_TRUE(robot_->WaitFor("iteration 1"));
  robot_->Signal(SIGINT);
  EXPECT_EQ(Shown(robot_->Finish().err, "ended by pause"), "");
}

TEST_F(RcFilesTest, AfterAnUploadThatCannotBeLoadedTheOldControllerRuns) {
  const std::string image = folder_.Read(OnStick("OBJS/CONTROLL.BIN"));
  AnswerOf({"controller", "upload", folder_.File(OnStick("OBJS/POWERMON.BIN"))});
  AnswerOf({"reboot"});
  EXPECT_TRUE(robot_->WaitFor("has booted again"));
  robot_->Signal(SIGINT);
  const std::string end = robot_->Finish().err;
  EXPECT_EQ(Shown(end, "/MS/OPEN-R/MW/OBJS/CONTROLL.BIN is named 'PowerMonitor' like another"), "");
  EXPECT_EQ(Shown(end, "CONTROLL.OLD, the image before the last upload, is loaded instead"), "");
}

}  // namespace
}  // namespace openr_host

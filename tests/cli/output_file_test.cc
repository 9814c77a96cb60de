#include "cli/output_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <algorithm>

#include "cli/growing_file.h"
#include "cli/prepared_file.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

std::vector<std::string> NamesIn(const ScratchFolder& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(OutputFileTest, LookingAtAFileChangesNothing) {
  const ScratchFolder folder;
  folder.Write("old.json", "{}");
  EXPECT_EQ(FileWriteProblem(folder.File("old.json")), "");
  EXPECT_EQ(folder.Read("old.json"), "{}");
  EXPECT_EQ(FileWriteProblem(folder.File("new.json")), "");
  EXPECT_FALSE(std::filesystem::exists(folder.File("new.json")));
}

TEST(OutputFileTest, AFolderIsNoFile) {
  const ScratchFolder folder;
  EXPECT_EQ(FileWriteProblem(folder.path()), folder.path() + ": is a folder; name a file");
}

TEST(OutputFileTest, AFolderThatIsMissingIsNotMade) {
  const ScratchFolder folder;
  const std::string file = folder.File("none/a.json");
  EXPECT_EQ(FileWriteProblem(file), file + ": cannot be written: there is no such folder");
}

TEST(OutputFileTest, ALinkToAFileOfTheFutureIsGoodAndStays) {
  const ScratchFolder folder;
  std::filesystem::create_symlink(folder.File("future"), folder.File("link"));
  EXPECT_EQ(FileWriteProblem(folder.File("link")), "");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.File("link")));
  EXPECT_EQ(WriteFile(folder.File("link"), "now"), "");
  EXPECT_EQ(folder.Read("future"), "now");
}

TEST(OutputFileTest, AFolderMayBeThereOrCanBeMade) {
  const ScratchFolder folder;
  EXPECT_EQ(FolderWriteProblem(folder.path()), "");
  EXPECT_EQ(FolderWriteProblem(folder.File("a/b/c")), "");
  EXPECT_FALSE(std::filesystem::exists(folder.File("a")));
}

TEST(OutputFileTest, WhatIsNoFolderIsSaidInWords) {
  const ScratchFolder folder;
  folder.Write("file", "");
  const std::string file = folder.File("file");
  EXPECT_EQ(FolderWriteProblem(""), "'' names no folder");
  EXPECT_EQ(FolderWriteProblem(file), file + ": is a file; name a folder");
  EXPECT_EQ(FolderWriteProblem(file + "/a"),
            file + "/a: " + file +
                " is a file, so nothing can be in it; name another "
                "folder");
}

TEST(OutputFileTest, CommandsThatMakeFoldersSayItBeforeTheyBegin) {
  const ScratchFolder folder;
  folder.Write("file", "");
  const std::string file = folder.File("file");
  const std::vector<std::vector<std::string>> commands = {
      {"stick", "host", "-o"},
      {"stick", "robot", "-o"},
      {"controller", "build", folder.path(), "-o"},
      {"controller", "new", "wave"},
      {"build", folder.path(), "-o"},
      {"new", "Wave"}};
  for (std::vector<std::string> command : commands) {
    command.push_back(file);
    ProgramResult result = RunProgram(command);
    EXPECT_EQ(result.status, 2) << command[0] << " " << command[1];
    EXPECT_NE(result.err.find(file + ": is a file; name a folder\n"), std::string::npos)
        << result.err;
    command.back() = "";
    result = RunProgram(command);
    EXPECT_EQ(result.status, 2) << command[0] << " " << command[1];
    EXPECT_NE(result.err.find("'' names no folder\n"), std::string::npos) << result.err;
  }
}

TEST(OutputFileTest, AnErrorOfTheFileSystemIsSaidWithThePath) {
  std::error_code error = std::make_error_code(std::errc::no_space_on_device);
  EXPECT_EQ(Explain({"copying", "from", "to/it", error}), "to/it: no room is left on the disk");
  error = std::make_error_code(std::errc::not_a_directory);
  EXPECT_EQ(Explain({"making", "a/b", error}),
            "a/b: a part of this name is a file, where a folder has to be; name another place");
}

TEST(OutputFileTest, ALinkAndThePermissionsOfAFileStay) {
  const ScratchFolder folder;
  folder.Write("there/old", "old");
  const std::string file = folder.File("there/old");
  std::filesystem::create_symlink("there/old", folder.File("link"));
  chmod(file.c_str(), 0640);
  EXPECT_EQ(WriteFile(folder.File("link"), "new"), "");
  EXPECT_EQ(folder.Read("there/old"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.File("link")));
  struct stat status;
  ASSERT_EQ(stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
}

TEST(OutputFileTest, AFileIsReplacedAndNotWrittenOver) {
  const ScratchFolder folder;
  folder.Write("a", "old");
  std::ifstream reader(folder.File("a"));  // another program that has the file open
  EXPECT_EQ(WriteFile(folder.File("a"), "newer"), "");
  std::string text;
  EXPECT_TRUE(reader >> text);
  EXPECT_EQ(text, "old");
  EXPECT_EQ(folder.Read("a"), "newer");
  EXPECT_EQ(NamesIn(folder), std::vector<std::string>{"a"}) << "nothing is left beside it";
}

TEST(OutputFileTest, AllNamesOfAFileGetTheNewContent) {
  const ScratchFolder folder;
  folder.Write("a", "a long old content");
  std::filesystem::create_hard_link(folder.File("a"), folder.File("b"));
  EXPECT_EQ(WriteFile(folder.File("a"), "new"), "");
  EXPECT_EQ(folder.Read("b"), "new");
}

// While it lives, no file of this process grows beyond a kilobyte: as on a disk without room.
class SmallDisk {
 public:
  SmallDisk() : before_(signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit small = {1024, limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    setrlimit(RLIMIT_FSIZE, &limit_);
    signal(SIGXFSZ, before_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  void (*const before_)(int);
  rlimit limit_{};
};

TEST(OutputFileTest, AGoodFileStaysWhenThereIsNoRoomForTheNewOne) {
  const ScratchFolder folder;
  folder.Write("a", "good");
  folder.Write("b", "good as well");
  std::filesystem::create_hard_link(folder.File("b"), folder.File("c"));
  const std::string bytes(10'000, 'x');
  std::string replaced, in_place;
  {
    const SmallDisk disk;
    replaced = WriteFile(folder.File("a"), bytes);
    in_place = WriteFile(folder.File("b"), bytes);
  }
  EXPECT_EQ(replaced, folder.File("a") + ": cannot be written: File too large");
  EXPECT_EQ(in_place, folder.File("b") + ": cannot be written: File too large");
  EXPECT_EQ(folder.Read("a"), "good");
  EXPECT_EQ(folder.Read("b"), "good as well");
  EXPECT_EQ(NamesIn(folder), (std::vector<std::string>{"a", "b", "c"}));
}

TEST(OutputFileTest, AGrowingFileKeepsItsEndWhenThereIsNoRoomForMore) {
  const ScratchFolder folder;
  GrowingFile file(folder.File("a"));
  file.Append("[1", "]");
  file.Append(", 2", "\n]");
  EXPECT_EQ(folder.Read("a"), "[1, 2\n]");
  file.Append("", "]");
  EXPECT_EQ(folder.Read("a"), "[1, 2]") << "a shorter end leaves nothing of the longer one";
  {
    const SmallDisk disk;
    file.Append(std::string(10'000, 'x'), "]");
  }
  EXPECT_EQ(folder.Read("a"), "[1, 2]");
  EXPECT_EQ(file.Problem(), folder.File("a") + ": cannot be written: File too large");
}

TEST(OutputFileTest, FilesThatBelongTogetherChangeTogether) {
  const ScratchFolder folder;
  folder.Write("a", "old");
  {
    PendingFile given_up(folder.File("a"));
    EXPECT_EQ(given_up.Write("new"), "");
    EXPECT_EQ(folder.Read("a"), "old");
  }
  EXPECT_EQ(NamesIn(folder), std::vector<std::string>{"a"});
  PendingFile file(folder.File("a"));
  EXPECT_EQ(file.Write("new"), "");
  EXPECT_EQ(file.Commit(), "");
  EXPECT_EQ(folder.Read("a"), "new");
}

TEST(OutputFileTest, APipeIsWrittenAndStaysAPipe) {
  const ScratchFolder folder;
  const std::string pipe = folder.File("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  EXPECT_EQ(WriteFile(pipe, "text"), "");
  char text[8] = "";
  EXPECT_EQ(read(reader, text, sizeof text - 1), 4);
  EXPECT_STREQ(text, "text");
  RemoveFile(pipe);
  EXPECT_TRUE(std::filesystem::is_fifo(pipe)) << "only files are removed";
  close(reader);
}

TEST(OutputFileTest, ACopyHasThePermissionsOfItsFileAndAPipeKeepsItsOwn) {
  const ScratchFolder folder;
  folder.Write("a", "text");
  chmod(folder.File("a").c_str(), 0750);
  const auto mode_of = [&folder](const std::string& name) {
    struct stat status {};
    stat(folder.File(name).c_str(), &status);
    return status.st_mode & 07777;
  };
  EXPECT_EQ(CopyToFile(folder.File("a"), folder.File("b")), "");
  EXPECT_EQ(mode_of("b"), 0750u);
  ASSERT_EQ(mkfifo(folder.File("pipe").c_str(), 0600), 0);
  const int reader = open(folder.File("pipe").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  EXPECT_EQ(CopyToFile(folder.File("a"), folder.File("pipe")), "");
  EXPECT_EQ(mode_of("pipe"), 0600u);
  close(reader);
}

TEST(OutputFileTest, AFileThatAnotherProcessWritesIsRefusedUntilThatHasEnded) {
  const ScratchFolder folder;
  const std::string file = folder.File("a.trace");
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t writer = fork();
  if (writer == 0) {
    std::string problem;
    const int descriptor = OpenGrowingFile(file, &problem);
    WriteAll(descriptor, "kept");
    WriteAll(ready[1], "x");
    for (;;) pause();
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  std::string problem;
  EXPECT_EQ(OpenGrowingFile(file, &problem), -1);
  EXPECT_EQ(problem, file + ": is being written by process " + std::to_string(writer) +
                         " (openr_tests); name another file, or wait for its end");
  EXPECT_EQ(folder.Read("a.trace"), "kept");
  kill(writer, SIGKILL);
  waitpid(writer, nullptr, 0);
  const int descriptor = OpenGrowingFile(file, &problem);
  EXPECT_GE(descriptor, 0) << "nothing is left of one that was killed";
  close(descriptor);
  close(ready[0]);
  close(ready[1]);
}

TEST(OutputFileTest, AGrowingFileThatIsNewLeavesTheOldOneToItsReaders) {
  const ScratchFolder folder;
  folder.Write("a", "old");
  std::filesystem::create_symlink("a", folder.File("link"));
  chmod(folder.File("a").c_str(), 0640);
  std::ifstream reader(folder.File("a"));
  std::string problem;
  const int descriptor = OpenNewGrowingFile(folder.File("link"), &problem);
  ASSERT_GE(descriptor, 0) << problem;
  WriteAll(descriptor, "new");
  std::string text;
  EXPECT_TRUE(reader >> text);
  EXPECT_EQ(text, "old");
  EXPECT_EQ(folder.Read("a"), "new");
  EXPECT_EQ(NamesIn(folder), (std::vector<std::string>{"a", "link"}));
  struct stat status;
  ASSERT_EQ(stat(folder.File("a").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0640u);
  EXPECT_EQ(OpenNewGrowingFile(folder.File("a"), &problem), -1) << "the new file is locked, too";
  EXPECT_NE(problem.find("is being written by process"), std::string::npos) << problem;
  EXPECT_EQ(folder.Read("a"), "new");
  close(descriptor);
}

TEST(OutputFileTest, AGrowingFileWithTwoNamesKeepsThem) {
  const ScratchFolder folder;
  folder.Write("a", "a long old content");
  std::filesystem::create_hard_link(folder.File("a"), folder.File("b"));
  std::string problem;
  const int descriptor = OpenNewGrowingFile(folder.File("a"), &problem);
  ASSERT_GE(descriptor, 0) << problem;
  WriteAll(descriptor, "new");
  close(descriptor);
  EXPECT_EQ(folder.Read("b"), "new");
}

TEST(OutputFileTest, AnEndingThatMayNotAllocateReplacesAFileAsWell) {
  const ScratchFolder folder;
  folder.Write("a", "old");
  std::filesystem::create_symlink("a", folder.File("link"));
  PreparedFile file(folder.File("link"));
  const int descriptor = file.Open();
  WriteAll(descriptor, "the end");
  EXPECT_EQ(folder.Read("a"), "old");
  file.Close();
  EXPECT_EQ(folder.Read("a"), "the end");
  EXPECT_EQ(NamesIn(folder), (std::vector<std::string>{"a", "link"}));
}

TEST(OutputFileTest, AFullDiskIsReportedWithTheFile) {
  EXPECT_EQ(WriteFile("/dev/full", "text"),
            "/dev/full: cannot be written: No space left on device");
}

// Not even root makes a folder in /proc, although access() lets it.
TEST(OutputFolderTest, AFolderThatCannotBeMadeIsFoundOutBeforehand) {
  for (const char* folder : {"/proc/x", "/proc/x/y", "/proc"}) {
    EXPECT_EQ(FolderWriteProblem(folder),
              std::string(folder) + ": " +
                  (geteuid() == 0 ? "nothing can be made in /proc: No such "
                                    "file or directory; name another folder"
                                  : "you may not write in /proc; name "
                                    "another folder"));
  }
}

TEST(OutputFolderTest, AFolderThatCanBeMadeIsNotLeftBehind) {
  const ScratchFolder folder;
  EXPECT_EQ(FolderWriteProblem(folder.File("a/b")), "");
  EXPECT_EQ(FolderWriteProblem(folder.path()), "");
  EXPECT_FALSE(std::filesystem::exists(folder.File("a")));
}

TEST(OutputFolderTest, ABuildIsRefusedBeforeAnythingIsCompiled) {
  const ProgramResult result = RunProgram({"build", "/nowhere", "-o", "/proc/x"});
  EXPECT_EQ(result.status, 2);
  EXPECT_NE(result.err.find("openr: --output: /proc/x: "), std::string::npos) << result.err;
}

}  // namespace
}  // namespace openr_host

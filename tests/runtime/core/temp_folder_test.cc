#include "runtime/base/temp_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace openr_host {
namespace {

namespace fs = std::filesystem;

pid_t DeadProcess() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return child;
}

// A folder of its own for temporary files, because the programs that run beside this one remove old
// folders from the common one.
class OwnTmpdir {
 public:
  OwnTmpdir() { setenv("TMPDIR", folder_.path().c_str(), 1); }
  ~OwnTmpdir() { had_ ? setenv("TMPDIR", kept_.c_str(), 1) : unsetenv("TMPDIR"); }
  OwnTmpdir(const OwnTmpdir&) = delete;
  OwnTmpdir& operator=(const OwnTmpdir&) = delete;

 private:
  const bool had_ = std::getenv("TMPDIR") != nullptr;
  const std::string kept_ = had_ ? std::getenv("TMPDIR") : "";
  const TempFolder folder_;
};

// "openr-host-run-SPACE-PID-XXXXXX"
TEST(TempFolderTest, FoldersOfDeadProcessesAreRemovedAlsoThoseOfOtherContainers) {
  const OwnTmpdir place;
  const fs::path own = TempFolder().path();
  const std::string name = own.filename();
  const std::string pid = std::to_string(DeadProcess());
  const size_t at = name.rfind("-" + std::to_string(getpid()) + "-");
  ASSERT_NE(at, std::string::npos) << name;
  const fs::path dead = own.parent_path() / (name.substr(0, at) + "-" + pid + "-abcdef");
  const fs::path elsewhere = own.parent_path() / (name.substr(0, at) + "1-" + pid + "-abcdef");
  ASSERT_TRUE(fs::create_directory(dead) && fs::create_directory(elsewhere));
  const int lock = open(elsewhere.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  ASSERT_EQ(flock(lock, LOCK_EX | LOCK_NB), 0);
  const TempFolder next;
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(elsewhere)) << "a living process has locked it";
  close(lock);
  const TempFolder after;
  EXPECT_FALSE(fs::exists(elsewhere));
  EXPECT_TRUE(fs::exists(next.path()));
}

// A fork goes on with the folder if the process that has made the folder was killed.
TEST(TempFolderTest, AFolderIsLockedAsLongAsAForkOfItsProcessLives) {
  const OwnTmpdir place;
  prctl(PR_SET_CHILD_SUBREAPER, 1);  // lets this process wait for the fork of its child
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  pid_t fork_of_maker = 0;
  std::string path(200, '\0');
  const pid_t maker = fork();
  if (maker == 0) {
    const TempFolder folder;
    fork_of_maker = fork();
    if (fork_of_maker == 0) pause();
    std::string text = folder.path();
    text.resize(path.size());
    write(ends[1], &fork_of_maker, sizeof fork_of_maker);
    write(ends[1], text.data(), text.size());
    _exit(0);  // without the destructor, as if killed
  }
  waitpid(maker, nullptr, 0);
  ASSERT_EQ(read(ends[0], &fork_of_maker, sizeof fork_of_maker), ssize_t{sizeof fork_of_maker});
  ASSERT_EQ(read(ends[0], path.data(), path.size()), static_cast<ssize_t>(path.size()));
  path.resize(path.find('\0'));
  const TempFolder next;
  EXPECT_TRUE(fs::exists(path)) << path;
  kill(fork_of_maker, SIGKILL);
  waitpid(fork_of_maker, nullptr, 0);
  const TempFolder after;
  EXPECT_FALSE(fs::exists(path)) << path;
  close(ends[0]);
  close(ends[1]);
}

// Objects see the numbers of their descriptors.
TEST(TempFolderTest, AFolderTakesNoLowDescriptor) {
  const int before = dup(0);
  close(before);
  const TempFolder folder;
  const int after = dup(0);
  close(after);
  EXPECT_EQ(after, before);
}

TEST(TempFolderTest, SmallFilesAreWhereTMPDIRSaysAndElseInMemoryOrAmongTheOthers) {
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  const TempFolder place;
  setenv("TMPDIR", place.path().c_str(), 1);
  EXPECT_EQ(fs::path(TempFolder(TempUse::kSmallFiles).path()).parent_path(), place.path());
  unsetenv("TMPDIR");
  const fs::path parent = fs::path(TempFolder(TempUse::kSmallFiles).path()).parent_path();
  EXPECT_TRUE(parent == "/dev/shm" || parent == fs::temp_directory_path()) << parent;
  EXPECT_EQ(fs::path(TempFolder().path()).parent_path(), fs::temp_directory_path());
  if (before != nullptr) setenv("TMPDIR", kept.c_str(), 1);
}

// Returns what TemporaryFiles() throws if TMPDIR has this value; "" if it throws nothing.
std::string ProblemWith(const std::string& value) {
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  setenv("TMPDIR", value.c_str(), 1);
  std::string problem;
  try {
    TemporaryFiles();
  } catch (const std::runtime_error& error) {
    problem = error.what();
  }
  before == nullptr ? unsetenv("TMPDIR") : setenv("TMPDIR", kept.c_str(), 1);
  return problem;
}

TEST(TempFolderTest, AFolderThatDoesNotExistIsNamedWithItsVariable) {
  const TempFolder folder;
  const std::string missing = folder.path() + "/missing";
  EXPECT_EQ(ProblemWith(missing),
            missing +
                ": is no folder for temporary files, but the environment variable TMPDIR names it; "
                "set TMPDIR to a folder that exists, or unset it");
}

TEST(TempFolderTest, AnEmptyVariableIsNamed) {
  EXPECT_EQ(ProblemWith(""),
            "the environment variable TMPDIR is empty; set it to a folder, or unset it");
}

TEST(TempFolderTest, AFolderThatCannotBeMadeIsNamedWithTheReasonAndTheRemedy) {
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  setenv("TMPDIR", "/proc", 1);  // where not even root makes a folder
  std::string problem;
  try {
    const TempFolder folder;
  } catch (const std::runtime_error& error) {
    problem = error.what();
  }
  before == nullptr ? unsetenv("TMPDIR") : setenv("TMPDIR", kept.c_str(), 1);
  EXPECT_EQ(problem,
            "/proc: no temporary folder can be made there: No such file or directory; the "
            "environment variable TMPDIR names another place for them");
}

}  // namespace
}  // namespace openr_host

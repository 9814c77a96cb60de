#include "runtime/base/temp_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

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

// "openr-host-run-SPACE-PID-XXXXXX"
TEST(TempFolderTest, FoldersOfDeadProcessesAreRemovedButForThoseOfOtherContainers) {
  const fs::path own = TempFolder().path();
  const std::string name = own.filename();
  const std::string pid = std::to_string(DeadProcess());
  const size_t at = name.rfind("-" + std::to_string(getpid()) + "-");
  ASSERT_NE(at, std::string::npos) << name;
  const fs::path dead = own.parent_path() / (name.substr(0, at) + "-" + pid + "-abcdef");
  const fs::path elsewhere = own.parent_path() / (name.substr(0, at) + "1-" + pid + "-abcdef");
  ASSERT_TRUE(fs::create_directory(dead) && fs::create_directory(elsewhere));
  const TempFolder next;
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(elsewhere));
  fs::remove(elsewhere);
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

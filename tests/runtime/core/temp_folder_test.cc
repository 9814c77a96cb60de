#include "runtime/core/temp_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
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

}  // namespace
}  // namespace openr_host

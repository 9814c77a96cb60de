// Copies of files and folders; a disk that becomes full is in tests/fault/bad_sticks.py.
#include "cli/copy_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

TEST(CopyFileTest, AFolderIsCopiedWithAllThatIsInIt) {
  const ScratchFolder folder;
  folder.Write("from/a/b.txt", "b");
  folder.Write("from/c.txt", "c");
  fs::create_directory_symlink("a", folder.File("from/link"));
  fs::create_directory(folder.File("from/empty"));
  CopyFolder(folder.File("from"), folder.File("to"));
  EXPECT_EQ(folder.Read("to/a/b.txt"), "b");
  EXPECT_EQ(folder.Read("to/c.txt"), "c");
  EXPECT_EQ(folder.Read("to/link/b.txt"), "b");
  EXPECT_FALSE(fs::is_symlink(folder.File("to/link")));
  EXPECT_TRUE(fs::is_directory(folder.File("to/empty")));
}

TEST(CopyFileTest, AFileThatIsThereIsReplacedOnlyIfThatIsWanted) {
  const ScratchFolder folder;
  folder.Write("from/a.txt", "new");
  folder.Write("to/a.txt", "old");
  const std::string from = folder.File("from"), to = folder.File("to");
  EXPECT_THROW(CopyFolder(from, to), fs::filesystem_error);
  CopyFolder(from, to, fs::copy_options::skip_existing);
  EXPECT_EQ(folder.Read("to/a.txt"), "old");
  CopyFolder(from, to, fs::copy_options::overwrite_existing);
  EXPECT_EQ(folder.Read("to/a.txt"), "new");
}

TEST(CopyFileTest, AnErrorNamesBothFiles) {
  const ScratchFolder folder;
  try {
    CopyFile(folder.File("none"), folder.File("to"));
    FAIL() << "nothing was thrown";
  } catch (const fs::filesystem_error& error) {
    EXPECT_EQ(error.path1(), folder.File("none"));
    EXPECT_EQ(error.path2(), folder.File("to"));
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
  }
  EXPECT_FALSE(fs::exists(folder.File("to")));
}

// std::filesystem reports an input/output error if a part of the file could be copied.
TEST(CopyFileTest, AFileThatIsLargerThanTheLimitOfTheShellIsTooLarge) {
  const ScratchFolder folder;
  folder.Write("from", std::string(100'000, 'x'));
  rlimit limit;
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small = {50'000, limit.rlim_max};
  void (*const handler)(int) = signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const std::error_code error = TryCopyFile(folder.File("from"), folder.File("to"));
  setrlimit(RLIMIT_FSIZE, &limit);
  signal(SIGXFSZ, handler);
  EXPECT_EQ(error, std::errc::file_too_large) << error.message();
  EXPECT_FALSE(fs::exists(folder.File("to")));
}

}  // namespace
}  // namespace openr_host

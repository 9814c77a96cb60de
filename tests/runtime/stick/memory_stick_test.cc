// Tests of FolderStick with large files and with files that may not be read.
#include "runtime/stick/memory_stick.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "runtime/base/hasher.h"
#include "runtime/base/temp_folder.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

TEST(MemoryStickTest, TheHashOfAFileIsThatOfItsNameSizeAndBytes) {
  const TempFolder folder;
  fs::create_directories(folder.path() + "/OPEN-R");
  const std::string text(3 << 20, 'x');  // more than one piece of HashFile()
  std::ofstream(folder.path() + "/OPEN-R/A.TXT") << text;
  Hasher expected;
  expected.AddText("OPEN-R/A.TXT");
  expected.AddText(text);
  EXPECT_EQ(FolderStick(folder.path()).ContentHash(), expected.Digest());
}

long PeakKb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

// Runs in a process of its own, whose memory has not grown before.
TEST(MemoryStickTest, ALargeFileIsNotReadIntoMemoryWhole) {
  constexpr uint64_t kFileBytes = 256 << 20;
  constexpr long kRoomKb = 32 << 10;
  const TempFolder folder;
  fs::create_directories(folder.path() + "/OPEN-R");
  std::ofstream(folder.path() + "/OPEN-R/BIG.DAT") << "x";
  fs::resize_file(folder.path() + "/OPEN-R/BIG.DAT",
                  kFileBytes);  // a sparse file, which uses no disk space
  const pid_t child = fork();
  if (child == 0) {
    const long before_kb = PeakKb();
    FolderStick stick(folder.path());
    stick.NoteWritten("/MS/OPEN-R/BIG.DAT");
    Hasher hasher;
    stick.HashState(&hasher);
    _exit(stick.ContentHash() != 0 && PeakKb() - before_kb < kRoomKb ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

TEST(MemoryStickTest, NoLinkLeadsOutOfTheStick) {
  const TempFolder folder, outside;
  std::ofstream(outside.path() + "/OLD.TXT") << "old";
  const auto link = [&](const std::string& to, const std::string& name) {
    fs::create_symlink(to, folder.path() + "/" + name);
  };
  link(outside.path() + "/OLD.TXT", "FILE.TXT");
  link(outside.path() + "/NEW.TXT", "DANGLING.TXT");
  link(outside.path(), "DIR");
  link("/proc/self/fd/0", "FD.TXT");
  FolderStick stick(folder.path());
  for (const char* const name :
       {"FILE.TXT", "DANGLING.TXT", "DIR", "DIR/OLD.TXT", "DIR/NEW.TXT", "FD.TXT"}) {
    EXPECT_EQ(stick.Locate(std::string("/MS/") + name).error, EACCES) << name;
  }
  // Links within the stick work, and new files can be made through them.
  fs::create_directory(folder.path() + "/REAL");
  link("REAL", "NEAR");
  const MemoryStick::Location made = stick.Locate("/MS/NEAR/NEW.TXT");
  EXPECT_EQ(made.error, 0);
  EXPECT_EQ(made.path, folder.path() + "/NEAR/NEW.TXT");
}

TEST(MemoryStickTest, AFifoIsNoFileOfTheStick) {
  const TempFolder folder;
  fs::create_directories(folder.path() + "/OPEN-R");
  std::ofstream(folder.path() + "/OPEN-R/A.TXT") << "x";
  FolderStick stick(folder.path());
  const uint64_t hash = stick.ContentHash();
  EXPECT_TRUE(stick.special_files().empty());
  ASSERT_EQ(mkfifo((folder.path() + "/OPEN-R/PIPE.TXT").c_str(), 0600), 0);
  fs::create_symlink("PIPE.TXT", folder.path() + "/OPEN-R/LINK.TXT");
  EXPECT_EQ(stick.ContentHash(), hash);
  EXPECT_EQ(stick.special_files(),
            (std::vector<std::string>{"OPEN-R/LINK.TXT", "OPEN-R/PIPE.TXT"}));
  for (const char* const name :
       {"/MS/OPEN-R/PIPE.TXT", "/MS/open-r/pipe.txt", "/MS/OPEN-R/LINK.TXT"}) {
    EXPECT_EQ(stick.Locate(name).error, EACCES) << name;
    EXPECT_EQ(stick.ReadError(name), EACCES) << name;
    EXPECT_FALSE(stick.ReadFile(name)) << name;
  }
  // The state hash reads the files that objects have written, and somebody may have put a FIFO in
  // the place of such a file.
  stick.NoteWritten("/MS/OPEN-R/PIPE.TXT");
  Hasher hasher;
  stick.HashState(&hasher);
}

TEST(MemoryStickTest, WhatIsNotThereIsToldFromWhatIsNoFile) {
  const TempFolder folder;
  fs::create_directories(folder.path() + "/OPEN-R/MW");
  FolderStick stick(folder.path());
  EXPECT_EQ(stick.ReadError("/MS/OPEN-R/A.TXT"), ENOENT);
  EXPECT_EQ(stick.ReadError("/MS/NOWHERE/A.TXT"), ENOENT);
  EXPECT_EQ(stick.ReadError("/MS/OPEN-R/MW"), EISDIR);
}

// Runs the check as another user, because root may read every file.
TEST(MemoryStickTest, WhatMayNotBeReadIsNotCalledMissing) {
  constexpr uid_t kNobody = 65534;
  const TempFolder folder;
  fs::permissions(folder.path(), fs::perms(0755));
  fs::create_directories(folder.path() + "/OPEN-R/CLOSED");
  std::ofstream(folder.path() + "/OPEN-R/CLOSED/A.TXT") << "x";
  std::ofstream(folder.path() + "/OPEN-R/B.TXT") << "x";
  fs::permissions(folder.path() + "/OPEN-R/CLOSED", fs::perms::none);
  fs::permissions(folder.path() + "/OPEN-R/B.TXT", fs::perms::none);
  const pid_t child = fork();
  if (child == 0) {
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(2);
    FolderStick stick(folder.path());
    const bool good = stick.ReadError("/MS/OPEN-R/CLOSED/A.TXT") == EACCES &&
                      stick.Locate("/MS/OPEN-R/CLOSED/A.TXT").error == EACCES &&
                      stick.ReadError("/MS/OPEN-R/B.TXT") == EACCES;
    _exit(good ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  fs::permissions(folder.path() + "/OPEN-R/CLOSED", fs::perms::owner_all);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << WEXITSTATUS(status);
}

}  // namespace
}  // namespace openr_host

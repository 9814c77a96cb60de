#include "cli/process_copy.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>

#include "cli/exit_code.h"
#include "runtime/base/read_file.h"
#include "runtime/base/temp_folder.h"

namespace openr_host {
namespace {

// Returns the content of a file that has got one line from a stream, if the process is copied while
// the line is in the stream's buffer.
std::string FileAfterCopy(Flushed flushed) {
  const TempFolder folder;
  const std::string path = folder.path() + "/text";
  std::FILE* const file = std::fopen(path.c_str(), "we");
  std::fputs("a line\n", file);
  std::fflush(stdout);  // the copy writes all buffers at its end
  const pid_t copy = CopyProcess(flushed, Orphan::kGoesOn);
  if (copy == 0) EndCopy();
  WaitForEnd(copy);
  std::fclose(file);
  return ReadFileOrThrow(path);
}

TEST(ProcessCopyTest, FlushedTextIsWrittenOnce) {
  EXPECT_EQ(FileAfterCopy(Flushed::kAll), "a line\n");
}

// Returns what a process has written to its standard output, a file, if a line was in the buffer
// when the process made a copy of itself.
std::string OutputAfterCopy(Flushed flushed) {
  const TempFolder folder;
  const std::string path = folder.path() + "/output";
  const ProcessCopy process = StartCopy(Orphan::kGoesOn, [&](int) {
    if (std::freopen(path.c_str(), "w", stdout) == nullptr) return;
    std::fputs("a line\n", stdout);
    const pid_t copy = CopyProcess(flushed, Orphan::kGoesOn);
    if (copy == 0) EndCopy();
    WaitForEnd(copy);
  });
  close(process.answers);
  WaitForEnd(process.pid);
  return ReadFileOrThrow(path);
}

TEST(ProcessCopyTest, OurOwnOutputIsWrittenOnce) {
  EXPECT_EQ(OutputAfterCopy(Flushed::kOwn), "a line\n");
  EXPECT_EQ(OutputAfterCopy(Flushed::kNone), "a line\na line\n");
}

TEST(ProcessCopyTest, FilesOfOthersAreNotFlushedWithOurOwnStreams) {
  EXPECT_EQ(FileAfterCopy(Flushed::kOwn), "a line\na line\n");
  EXPECT_EQ(FileAfterCopy(Flushed::kNone), "a line\na line\n");
}

// The process `middle` is a copy of the test, makes a copy of itself and ends.  The second copy
// would write "alive" after 20 s, but the kernel kills it at the end of `middle`, its original.
TEST(ProcessCopyTest, CopyIsKilledWhenItsOriginalEnds) {
  const ProcessCopy middle = StartCopy(Orphan::kIsKilled, [](int answers) {
    if (CopyProcess(Flushed::kNone, Orphan::kIsKilled) != 0) return;
    sleep(20);
    [[maybe_unused]] const ssize_t count = write(answers, "alive", 5);
    _exit(0);
  });
  EXPECT_EQ(ReadToEnd(middle.answers), "");
  close(middle.answers);
  EXPECT_EQ(ExitCodeOf(WaitForEnd(middle.pid)), kExitGood);
}

TEST(ProcessCopyTest, CopyGoesOnWhenItsOriginalEnds) {
  int gone[2];  // a pipe; closed when the original of the second copy has ended
  ASSERT_EQ(pipe2(gone, O_CLOEXEC), 0);
  const ProcessCopy middle = StartCopy(Orphan::kGoesOn, [&gone](int answers) {
    if (CopyProcess(Flushed::kNone, Orphan::kGoesOn) != 0) return;
    close(gone[1]);
    ReadToEnd(gone[0]);
    [[maybe_unused]] const ssize_t count = write(answers, "alive", 5);
    _exit(0);
  });
  WaitForEnd(middle.pid);
  close(gone[1]);
  EXPECT_EQ(ReadToEnd(middle.answers), "alive");
  close(gone[0]);
  close(middle.answers);
}

TEST(ProcessCopyTest, ExitCodeAfterASignalIsThatOfAnError) {
  const pid_t good = CopyProcess(Flushed::kAll, Orphan::kIsKilled);
  if (good == 0) _exit(3);
  EXPECT_EQ(ExitCodeOf(WaitForEnd(good)), 3);
  const pid_t killed = CopyProcess(Flushed::kAll, Orphan::kIsKilled);
  if (killed == 0) {
    raise(SIGKILL);
    _exit(0);
  }
  EXPECT_EQ(ExitCodeOf(WaitForEnd(killed)), kExitWrong);
}

TEST(ProcessCopyTest, ACopyThatFailsToStartAProgramGivesTheReason) {
  EXPECT_EQ(StartThroughCopy([] { return 0; }), "");
  EXPECT_EQ(StartThroughCopy([] { return ENOENT; }), "No such file or directory");
  EXPECT_EQ(StartThroughCopy([] {
              kill(getpid(), SIGKILL);
              return 0;
            }),
            "the process that was to start it was killed by signal 9 (Killed)");
}

}  // namespace
}  // namespace openr_host

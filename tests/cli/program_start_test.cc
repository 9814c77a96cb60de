#include "runtime/base/program_start.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "cli/process_copy.h"

namespace openr_host {
namespace {

// Starts a shell that carries out `script` as `prepare` has set, and returns the status that
// waitpid() gives.
template <typename Prepare>
int StatusOfShell(const std::string& script, Prepare prepare) {
  ProgramStart shell({"sh", "-c", script});
  prepare(&shell);
  pid_t process = -1;
  EXPECT_EQ(shell.Start(&process), 0);
  return WaitForEnd(process);
}

int StatusOfShell(const std::string& script) {
  return StatusOfShell(script, [](ProgramStart*) {});
}

TEST(ProgramStartTest, ProgramThatDoesNotExistIsAnError) {
  const ProgramStart missing({"/proc/no/such/program"});
  pid_t process = -1;
  EXPECT_EQ(missing.Start(&process), ENOENT);
  const ProgramStart other({"a-name"});
  EXPECT_EQ(other.Start("true", &process), 0);
  EXPECT_EQ(WaitForEnd(process), 0);
}

TEST(ProgramStartTest, IgnoredSigpipeIsNotInherited) {
  const auto before = signal(SIGPIPE, SIG_IGN);
  const int status = StatusOfShell("kill -PIPE $$; exit 0");
  signal(SIGPIPE, before);
  ASSERT_TRUE(WIFSIGNALED(status)) << status;
  EXPECT_EQ(WTERMSIG(status), SIGPIPE);
}

// A descriptor that is given under its own number stays open in the program, although O_CLOEXEC
// asks to close it when a program is started.
TEST(ProgramStartTest, DescriptorMayBeGivenUnderItsOwnNumber) {
  const int descriptor = open("/dev/null", O_RDONLY | O_CLOEXEC);
  ASSERT_GT(descriptor, 2);
  const std::string script = "test -e /proc/self/fd/" + std::to_string(descriptor);
  EXPECT_NE(StatusOfShell(script), 0);
  EXPECT_EQ(StatusOfShell(script, [&](ProgramStart* s) { s->Give(descriptor, descriptor); }), 0);
  close(descriptor);
}

TEST(ProgramStartTest, CloseFromClosesWhatWouldBeInherited) {
  const int descriptor = open("/dev/null", O_RDONLY);
  ASSERT_GT(descriptor, 2);
  const std::string script = "test -e /proc/self/fd/" + std::to_string(descriptor);
  EXPECT_EQ(StatusOfShell(script), 0);
  EXPECT_NE(StatusOfShell(script, [](ProgramStart* shell) { shell->CloseFrom(3); }), 0);
  close(descriptor);
}

TEST(ProgramStartTest, ProgramMayLeadAGroupOrASession) {
  // Fields 5 and 6 are the process group and the session of the shell (proc(5)).
  const std::string leads_group = "test $(cut -d' ' -f5 /proc/$$/stat) = $$";
  const std::string leads_session = "test $(cut -d' ' -f6 /proc/$$/stat) = $$";
  EXPECT_NE(StatusOfShell(leads_group), 0);
  EXPECT_EQ(StatusOfShell(leads_group, [](ProgramStart* shell) { shell->LeaveGroup(); }), 0);
  EXPECT_NE(StatusOfShell(leads_session), 0);
  EXPECT_EQ(StatusOfShell(leads_session, [](ProgramStart* shell) { shell->LeaveSession(); }), 0);
}

TEST(ProgramStartTest, BlockedSignalsAreUnblockedOnRequest) {
  sigset_t term, before;
  sigemptyset(&term);
  sigaddset(&term, SIGTERM);
  sigprocmask(SIG_BLOCK, &term, &before);
  const int blocked = StatusOfShell("kill -TERM $$; exit 0");
  const int unblocked =
      StatusOfShell("kill -TERM $$; exit 0", [](ProgramStart* shell) { shell->UnblockSignals(); });
  sigprocmask(SIG_SETMASK, &before, nullptr);
  EXPECT_EQ(blocked, 0);
  ASSERT_TRUE(WIFSIGNALED(unblocked)) << unblocked;
  EXPECT_EQ(WTERMSIG(unblocked), SIGTERM);
}

TEST(ProgramStartTest, EnvironmentIsReplaced) {
  const auto set = [](ProgramStart* shell) { shell->SetEnvironment({"COLOUR=blue"}); };
  EXPECT_EQ(StatusOfShell("test \"$COLOUR\" = blue", set), 0);
  EXPECT_NE(StatusOfShell("test \"$COLOUR\" = blue"), 0);
}

}  // namespace
}  // namespace openr_host

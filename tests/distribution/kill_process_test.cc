// KillProcess() never signals more than one process.
#include "tests/distribution/kill_process.h"

#include <gtest/gtest.h>
#include <unistd.h>

namespace openr_host {
namespace {

// Signal 0 harms no process, should the test fail.
TEST(KillProcessTest, AnUnknownProcessIdIsRefused) {
  for (const int64_t pid : {-1, 0, 1}) EXPECT_THROW(KillProcess(pid, 0), std::runtime_error) << pid;
  EXPECT_THROW(KillProcess(0x7fff'ffff, 0), std::runtime_error);
  KillProcess(getpid(), 0);
}

}  // namespace
}  // namespace openr_host

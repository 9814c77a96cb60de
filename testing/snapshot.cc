#include "testing/snapshot.h"

#include <fmt/format.h>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "testing/control.h"
#include "testing/story_teller.h"

namespace openr::testing {
namespace {

using ::testing::TestPartResult;

// One result on its way from a copy to its original.
struct ResultHeader {
  TestPartResult::Type type;
  int line;
  size_t file_size;
  size_t message_size;
};

void WriteAll(int pipe, const void* data, size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t count = write(pipe, at, size);
    if (count <= 0) return;  // the original is gone
    at += count;
    size -= static_cast<size_t>(count);
  }
}

// Takes every result of a copy, also in the middle of an EXPECT_NONFATAL_FAILURE(), and sends
// it at once, so that nothing is lost when the copy dies.
class ResultSender : public ::testing::ScopedFakeTestPartResultReporter {
 public:
  explicit ResultSender(int pipe)
      : ScopedFakeTestPartResultReporter(INTERCEPT_ONLY_CURRENT_THREAD, nullptr), pipe_(pipe) {}

  void ReportTestPartResult(const TestPartResult& result) override {
    if (result.fatally_failed()) NoteFatalFailure();
    const std::string file = result.file_name() == nullptr ? "" : result.file_name();
    // The story of this copy; the original's would be another one.
    const std::string message =
        result.failed() ? StoryTeller::WithStory(result.message()) : result.message();
    const ResultHeader header{result.type(), result.line_number(), file.size(), message.size()};
    WriteAll(pipe_, &header, sizeof header);
    WriteAll(pipe_, file.data(), file.size());
    WriteAll(pipe_, message.data(), message.size());
  }

 private:
  const int pipe_;
};

[[noreturn]] void LiveAsCopy(const std::function<void()>& body, int pipe) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // not longer than its original
  const ResultSender sender(pipe);
  try {
    body();
  } catch (const std::exception& e) {
    ADD_FAILURE() << "uncaught exception: " << e.what();
  } catch (...) {
    ADD_FAILURE() << "uncaught exception of unknown type";
  }
  std::fflush(nullptr);
  _exit(0);
}

std::string ReadAll(int pipe) {
  std::string bytes;
  char buffer[4096];
  for (ssize_t count = 0; (count = read(pipe, buffer, sizeof buffer)) > 0;)
    bytes.append(buffer, static_cast<size_t>(count));
  return bytes;
}

// The results of a copy become results here.
void AddResults(const std::string& bytes) {
  for (size_t at = 0; at + sizeof(ResultHeader) <= bytes.size();) {
    ResultHeader header;
    std::memcpy(&header, bytes.data() + at, sizeof header);
    at += sizeof header;
    const std::string file = bytes.substr(at, header.file_size);
    at += header.file_size;
    const std::string message = bytes.substr(at, header.message_size);
    at += header.message_size;
    if (header.type == TestPartResult::kSuccess) continue;
    GTEST_MESSAGE_AT_(file.c_str(), header.line, message.c_str(), header.type);
  }
}

std::string DescribeEnd(int status) {
  if (WIFSIGNALED(status)) {
    return fmt::format("The copy of the process died of signal {} ({}); what it printed is above",
                       WTERMSIG(status), strsignal(WTERMSIG(status)));
  }
  return fmt::format("The copy of the process ended itself with status {}", WEXITSTATUS(status));
}

}  // namespace

void RunInCopy(const std::function<void()>& body, const Place& place) {
  if (const int threads = ThreadCount(); threads != 1) {
    Fail(place, fmt::format("This process has {} threads; only one can be copied", threads));
    return;
  }
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe to a copy of this process");
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("this process cannot be copied: fork failed");
  if (child == 0) {
    close(ends[0]);
    LiveAsCopy(body, ends[1]);
  }
  close(ends[1]);
  const std::string results = ReadAll(ends[0]);
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  AddResults(results);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) Fail(place, DescribeEnd(status));
}

}  // namespace openr::testing

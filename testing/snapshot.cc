#include "testing/snapshot.h"

#include <fmt/format.h>
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <string>
#include <vector>

#include "cli/output_file.h"
#include "cli/process_copy.h"
#include "testing/control.h"
#include "testing/story_teller.h"

namespace openr::testing {
namespace {

using openr_host::WriteAll;
using ::testing::TestPartResult;

// The header of a test result that a copy of the process sends to the original process.
struct ResultHeader {
  TestPartResult::Type type;
  int line;
  size_t file_size;
  size_t message_size;
};

// Sends every test result from a copy of the process (made by fork()) to the original process at
// once, so that no result is lost when the copy crashes.  If the copy was made inside of
// EXPECT_NONFATAL_FAILURE(), this macro gets the results in the original process (AddResults()).
class ResultSender : public ::testing::ScopedFakeTestPartResultReporter {
 public:
  explicit ResultSender(int pipe)
      : ScopedFakeTestPartResultReporter(INTERCEPT_ONLY_CURRENT_THREAD, nullptr), pipe_(pipe) {}

  void ReportTestPartResult(const TestPartResult& result) override {
    if (result.fatally_failed()) NoteFatalFailure();
    const std::string file = result.file_name() == nullptr ? "" : result.file_name();
    // Adds the story (last messages, objects that wait) in the copy, because the original process
    // does not know what happened in the copy.
    const std::string message =
        result.failed() ? StoryTeller::WithStory(result.message()) : result.message();
    const ResultHeader header{result.type(), result.line_number(), file.size(), message.size()};
    // Ignores errors of WriteAll().  An error means that the original process has ended, and then
    // nobody needs the results.
    WriteAll(pipe_, {reinterpret_cast<const char*>(&header), sizeof header});
    WriteAll(pipe_, file);
    WriteAll(pipe_, message);
  }

 private:
  const int pipe_;
};

void LiveAsCopy(const std::function<void()>& body, int pipe) {
  const ResultSender sender(pipe);
  try {
    body();
  } catch (const std::exception& e) {
    ADD_FAILURE() << "uncaught exception: " << e.what();
  } catch (...) {
    ADD_FAILURE() << "uncaught exception of unknown type";
  }
}

// Adds results of checks to the running test.  `bytes` are the results that a copy of the process
// has sent (ResultSender).
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
  const openr_host::ProcessCopy copy = openr_host::StartCopy(
      openr_host::Orphan::kIsKilled, [&body](int pipe) { LiveAsCopy(body, pipe); });
  const std::string results = openr_host::ReadToEnd(copy.answers);
  close(copy.answers);
  const int status = openr_host::WaitForEnd(copy.pid);
  AddResults(results);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) Fail(place, DescribeEnd(status));
}

}  // namespace openr::testing

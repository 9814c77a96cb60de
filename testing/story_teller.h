// Adds to every failure of a test what happened on its bench: to failures of the bench's own
// functions, of plain EXPECTs, to crashes, and to handlers that do not return.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace testing {
class TestInfo;
}

namespace openr::testing {

// The object of a bench that adds its story to failures.  Each bench has a StoryTeller.
class StoryTeller {
 public:
  // `story` returns Bench::Story().  It is called while GoogleTest reports a failure, so it must
  // not call GoogleTest.  A handler that uses more than `handler_limit_us` of processor time (0: no
  // limit) ends the process, as a crash of an object does.
  StoryTeller(std::function<std::string()> story, int64_t handler_limit_us);
  ~StoryTeller();
  StoryTeller(const StoryTeller&) = delete;
  StoryTeller& operator=(const StoryTeller&) = delete;

  // Starts the timer again and notes the running test.  Called in a copy of the process, which
  // inherits no timer and may belong to another test.
  void OnCopied();

  // Returns `failure` followed by the story of the test's newest bench.  Returns `failure`
  // unchanged if it has a story already or the test has no bench.  The bench of a Snapshot belongs
  // to a test only in the copy of the process, so failures in the original do not get its story.
  static std::string WithStory(const std::string& failure);

 private:
  struct Guards;

  const std::function<std::string()> story_;
  const int64_t handler_limit_us_;
  StoryTeller* outer_;                         // that of the bench before
  const ::testing::TestInfo* test_ = nullptr;  // test of the bench
};

}  // namespace openr::testing

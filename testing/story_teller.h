// StoryTeller adds a text, the story, to each failure of a test: what happened on the bench of the
// test.  A failure may come from a function of the bench, a plain EXPECT, a crash, or a handler
// that does not return.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace testing {
class TestInfo;
}

namespace openr::testing {

// The part of a bench that adds the story to failures: a text with the last messages, the objects
// that wait, and what they wait for.
class StoryTeller {
 public:
  // `story` is a function that returns the story of the bench (Bench::Story()).  It is called when
  // a failure is reported.  GoogleTest holds a lock meanwhile, so `story` must not call GoogleTest.
  // A handler that uses more than `handler_limit_us` of processor time ends the process like a
  // crash; 0: no limit.
  StoryTeller(std::function<std::string()> story, int64_t handler_limit_us);
  ~StoryTeller();
  StoryTeller(const StoryTeller&) = delete;
  StoryTeller& operator=(const StoryTeller&) = delete;

  // Restarts the timer that ends a handler at its limit of processor time, and notes the running
  // test.  Called in a copy of the process (made by fork(), see snapshot.h), because a copy
  // inherits no timer and may run another test.
  void WatchRunningTest();

  // Returns `failure`, the text of a failure, followed by the story of the running test's newest
  // bench.  Returns `failure` unchanged if it has a story already, or if the test has no bench.  In
  // a copy of the process (made by fork(), see snapshot.h), the copied bench counts as a bench of
  // the test that runs in the copy.
  static std::string WithStory(const std::string& failure);

 private:
  struct Guards;

  const std::function<std::string()> story_;
  const int64_t handler_limit_us_;
  StoryTeller* outer_;                         // StoryTeller of the next older bench; null: none
  const ::testing::TestInfo* test_ = nullptr;  // test to which the bench belongs
};

}  // namespace openr::testing

// Makes every failure of a test end with what happened on its bench: those of a bench's own verbs,
// plain EXPECTs, crashes and handlers that do not return.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace testing {
class TestInfo;
}

namespace openr::testing {

// One per bench, as long as it lives.
class StoryTeller {
 public:
  // `story`: what Bench::Story() says; it is told while GoogleTest reports, and must ask it
  // nothing. A handler that uses more than `handler_limit_us` of processor time (0: never) ends the
  // process, as a crash of an object does.
  StoryTeller(std::function<std::string()> story, int64_t handler_limit_us);
  ~StoryTeller();
  StoryTeller(const StoryTeller&) = delete;
  StoryTeller& operator=(const StoryTeller&) = delete;

  // In a copy of the process, which has inherited no timer, and may be another test's.
  void OnCopied();

  // `failure` with the story of the test's newest bench, unless it has a story already; as it is
  // when the test has no bench.  Those of a Snapshot belong to the test only in its copy.
  static std::string WithStory(const std::string& failure);

 private:
  struct Guards;

  const std::function<std::string()> story_;
  const int64_t handler_limit_us_;
  StoryTeller* outer_;                         // the one before
  const ::testing::TestInfo* test_ = nullptr;  // whose bench it is
};

}  // namespace openr::testing

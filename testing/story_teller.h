// Makes every failure of a test end with what happened on its bench: those of a bench's own verbs,
// plain EXPECTs, crashes and handlers that do not return.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace openr::testing {

// One per bench, as long as it lives.
class StoryTeller {
 public:
  // `story`: what Bench::Story() says.  A handler that uses more than `handler_limit_us` of
  // processor time (0: never) ends the process, as a crash of an object does.
  StoryTeller(std::function<std::string()> story, int64_t handler_limit_us);
  ~StoryTeller();
  StoryTeller(const StoryTeller&) = delete;
  StoryTeller& operator=(const StoryTeller&) = delete;

  // In a copy of the process, which has inherited no timer.
  void OnCopied();

  // `failure` with the story of the newest bench, unless it has a story already; as it is when
  // there is no bench.
  static std::string WithStory(const std::string& failure);

 private:
  struct Guards;  // against crashes and endless handlers: of the process, the first bench's

  void Arm();

  const std::function<std::string()> story_;
  const int64_t handler_limit_us_;
  StoryTeller* const outer_;
  std::unique_ptr<Guards> guards_;
};

}  // namespace openr::testing

#include "testing/story_teller.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <utility>

#include "openr/ending/end_guards.h"
#include "runtime/base/terminal_text.h"

namespace openr::testing {
namespace {

// The words with which the last line of a story begins.  A story is the text that Bench::Story()
// returns and that is added to the text of a failure.  A failure whose text contains these words
// already has a story, so it gets no second one.
constexpr char kMark[] = "To see it again: ";

StoryTeller* g_newest = nullptr;
// The running test.  It is stored here, because GoogleTest holds a lock while it reports a failure:
// a call that asks GoogleTest for the running test would then wait for ever.
const ::testing::TestInfo* g_test = nullptr;

// After the first failure of a test, prints the story: a text about what happened on the bench of
// the test (story_teller.h).  Later failures of the same test get no story, because it would be
// almost the same text.
class Listener : public ::testing::EmptyTestEventListener {
 public:
  void OnTestStart(const ::testing::TestInfo& test) override {
    g_test = &test;
    has_told_ = false;
  }
  void OnTestEnd(const ::testing::TestInfo&) override { g_test = nullptr; }
  void OnTestPartResult(const ::testing::TestPartResult& result) override {
    const std::string message = result.message() == nullptr ? "" : result.message();
    if (!result.failed() || std::exchange(has_told_, result.failed())) return;
    const std::string told = StoryTeller::WithStory(message);
    if (told.size() == message.size()) return;
    std::printf("%s\n", openr_host::TerminalText(told.substr(message.size())).c_str());
    std::fflush(stdout);
  }

 private:
  bool has_told_ = false;
};

void Listen() {
  static const bool once = [] {
    ::testing::UnitTest* const all = ::testing::UnitTest::GetInstance();
    g_test = all->current_test_info();
    all->listeners().Append(new Listener);
    return true;
  }();
  (void)once;
}

}  // namespace

// Makes the process print the story, the text with the last messages (story_teller.h), also when
// the process crashes or when a handler of an object does not return.  Only the newest bench of the
// process has Guards.
struct StoryTeller::Guards {
  explicit Guards(int64_t handler_limit_us)
      : guards({.prints_end = false,
                .handler_limit_us = handler_limit_us,
                .limit_name = "BenchOptions::handler_limit"}) {}

  const openr_host::EndGuards guards;
  const openr_host::EndingAction ending_action{[](openr_host::Ending*) {
    std::fprintf(stderr, "%s\n", openr_host::TerminalText(WithStory("")).c_str());
    std::fflush(nullptr);
  }};

  // The Guards of the newest bench, which print its story when the process crashes; null: no bench
  // exists.
  static inline std::unique_ptr<Guards> now;
};

StoryTeller::StoryTeller(std::function<std::string()> story, int64_t handler_limit_us)
    : story_(std::move(story)),
      handler_limit_us_(handler_limit_us),
      outer_(std::exchange(g_newest, this)) {
  Listen();
  WatchRunningTest();
}

// Removes this StoryTeller from the list that begins with `g_newest`.  A test may destroy its
// benches in any order, so this StoryTeller may be anywhere in the list.
StoryTeller::~StoryTeller() {
  StoryTeller** link = &g_newest;
  while (*link != this) link = &(*link)->outer_;
  *link = outer_;
  Guards::now.reset();
  if (g_newest != nullptr) Guards::now = std::make_unique<Guards>(g_newest->handler_limit_us_);
}

void StoryTeller::WatchRunningTest() {
  test_ = g_test;
  Guards::now.reset();
  Guards::now = std::make_unique<Guards>(handler_limit_us_);
}

std::string StoryTeller::WithStory(const std::string& failure) {
  const StoryTeller* teller = g_newest;
  while (teller != nullptr && teller->test_ != g_test) teller = teller->outer_;
  if (teller == nullptr || failure.find(kMark) != std::string::npos) return failure;
  return failure + (failure.empty() || failure.ends_with('\n') ? "" : "\n") + teller->story_();
}

}  // namespace openr::testing

#include "testing/story_teller.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <utility>

#include "openr/ending/crash_log.h"
#include "openr/ending/ending.h"
#include "openr/ending/watchdog.h"

namespace openr::testing {
namespace {

// The beginning of the last part of a story; see Bench::Story().
constexpr char kMark[] = "To see it again: ";

StoryTeller* g_newest = nullptr;
// The running test.  It is kept here, because GoogleTest holds a lock while it reports a failure,
// so that asking for the test would block.
const ::testing::TestInfo* g_test = nullptr;

// Prints the story after the first failure of each test.
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
    std::printf("%s\n", told.c_str() + message.size());
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

// The objects that handle crashes and handlers that do not return, in this process.
struct StoryTeller::Guards {
  explicit Guards(int64_t handler_limit_us) : watchdog(handler_limit_us) {}

  const openr_host::CrashLog crash_log{{}};
  const openr_host::Watchdog watchdog;
  const openr_host::EndingAction ending_action{[](openr_host::Ending*) {
    std::fprintf(stderr, "%s\n", WithStory("").c_str());
    std::fflush(nullptr);
  }};

  static inline std::unique_ptr<Guards> now;  // of the newest bench
};

StoryTeller::StoryTeller(std::function<std::string()> story, int64_t handler_limit_us)
    : story_(std::move(story)),
      handler_limit_us_(handler_limit_us),
      outer_(std::exchange(g_newest, this)) {
  Listen();
  OnCopied();
}

// Takes this StoryTeller out of the list.  It need not be the newest, because a test may destroy
// its benches in any order.
StoryTeller::~StoryTeller() {
  StoryTeller** link = &g_newest;
  while (*link != this) link = &(*link)->outer_;
  *link = outer_;
  Guards::now.reset();
  if (g_newest != nullptr) Guards::now = std::make_unique<Guards>(g_newest->handler_limit_us_);
}

void StoryTeller::OnCopied() {
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

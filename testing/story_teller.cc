#include "testing/story_teller.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <utility>

#include "openr/crash_log.h"
#include "openr/last_words.h"
#include "openr/watchdog.h"

namespace openr::testing {
namespace {

// How stories begin to end; see Bench::Story().
constexpr char kMark[] = "To see it again: ";

StoryTeller* g_newest = nullptr;

// After the first failure of each test.
class Listener : public ::testing::EmptyTestEventListener {
 public:
  void OnTestStart(const ::testing::TestInfo&) override { has_told_ = false; }
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
    ::testing::UnitTest::GetInstance()->listeners().Append(new Listener);
    return true;
  }();
  (void)once;
}

}  // namespace

struct StoryTeller::Guards {
  explicit Guards(int64_t handler_limit_us) : watchdog(handler_limit_us) {}

  const openr_host::CrashLog crash_log{{}};
  const openr_host::Watchdog watchdog;
  const openr_host::LastWords last_words{[] {
    std::fprintf(stderr, "%s\n", WithStory("").c_str());
    std::fflush(nullptr);
  }};
};

StoryTeller::StoryTeller(std::function<std::string()> story, int64_t handler_limit_us)
    : story_(std::move(story)),
      handler_limit_us_(handler_limit_us),
      outer_(std::exchange(g_newest, this)) {
  Listen();
  if (outer_ == nullptr) guards_ = std::make_unique<Guards>(handler_limit_us_);
}

StoryTeller::~StoryTeller() {
  if (g_newest == this) g_newest = outer_;
}

void StoryTeller::OnCopied() {
  if (guards_ == nullptr) return;
  guards_.reset();
  guards_ = std::make_unique<Guards>(handler_limit_us_);
}

std::string StoryTeller::WithStory(const std::string& failure) {
  if (g_newest == nullptr || failure.find(kMark) != std::string::npos) return failure;
  return failure + (failure.empty() || failure.ends_with('\n') ? "" : "\n") + g_newest->story_();
}

}  // namespace openr::testing

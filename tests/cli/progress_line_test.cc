#include "cli/progress_line.h"

#include <gmock/gmock.h>
#include <pty.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>

namespace openr_host {
namespace {

using ::testing::EndsWith;
using ::testing::StartsWith;

TEST(ProgressLineTest, TellsHowManyAreDoneAndHowLongTheOthersTake) {
  EXPECT_EQ(ProgressText(0, 100, "seeds", 4), "openr: 0 of 100 seeds");
  EXPECT_EQ(ProgressText(40, 100, "seeds", 60), "openr: 40 of 100 seeds, about 90 s left");
  EXPECT_EQ(ProgressText(1, 100, "seeds", 10), "openr: 1 of 100 seeds, about 17 min left");
  EXPECT_EQ(ProgressText(100, 100, "seeds", 60), "openr: 100 of 100 seeds, about 0 s left");
  EXPECT_EQ(ProgressText(40, std::nullopt, "seeds", 60), "openr: 40 seeds");
}

// Returns what a ProgressLine writes during its life to a terminal or to a pipe.  `between` is
// called after a drawing.
std::string Written(
    bool is_terminal, int64_t quiet_ns = 0,
    const std::function<void(int writer)>& between = [](int) {}) {
  int reader = -1, writer = -1;
  int ends[2] = {-1, -1};
  if (is_terminal) {
    EXPECT_EQ(openpty(&reader, &writer, nullptr, nullptr, nullptr), 0);
  } else {
    EXPECT_EQ(pipe(ends), 0);
    reader = ends[0];
    writer = ends[1];
  }
  {
    ProgressLine line(writer, 100, "seeds", quiet_ns);
    line.Show(0);
    between(writer);
  }
  close(writer);
  // A terminal hands over what was written in pieces.
  std::string text;
  char buffer[4096];
  for (ssize_t n = 0; (n = read(reader, buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<size_t>(n));
  close(reader);
  return text;
}

// Returns the quiet time that `value` of OPENR_HOST_PROGRESS_MS means.
int64_t QuietNsFor(const char* value) {
  setenv("OPENR_HOST_PROGRESS_MS", value, 1);
  const int64_t quiet_ns = ProgressQuietNs();
  unsetenv("OPENR_HOST_PROGRESS_MS");
  return quiet_ns;
}

TEST(ProgressLineTest, BeginsAfterTwoSecondsUnlessTheEnvironmentSaysOtherwise) {
  EXPECT_EQ(ProgressQuietNs(), 2'000'000'000);
  EXPECT_EQ(QuietNsFor("0"), 0);
  EXPECT_EQ(QuietNsFor("500"), 500'000'000);
  for (const char* const wrong : {"", "soon", "5s", "-1"})
    EXPECT_EQ(QuietNsFor(wrong), 2'000'000'000) << wrong;
}

TEST(ProgressLineTest, IsDrawnInOnePlaceOfATerminalAndWipedAtTheEnd) {
  const std::string text = Written(true);
  EXPECT_THAT(text, StartsWith("\r\x1b[Kopenr: 0 of 100 seeds"));
  EXPECT_THAT(text, EndsWith("\r\x1b[K"));
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(ProgressLineTest, IsNotShownByACommandThatEndsSoon) {
  EXPECT_EQ(Written(true, INT64_MAX), "");
}

TEST(ProgressLineTest, IsClearedBeforeOtherTextAndOnlyOnce) {
  const std::string text = Written(true, 0, [](int writer) {
    ClearProgressLine();
    ClearProgressLine();
    EXPECT_EQ(write(writer, "hello\r\n", 7), 7);
  });
  EXPECT_THAT(text, EndsWith("openr: 0 of 100 seeds\r\x1b[Khello\r\r\n"));
}

TEST(ProgressLineTest, SaysNothingWhereThereIsNoTerminal) { EXPECT_EQ(Written(false), ""); }

}  // namespace
}  // namespace openr_host

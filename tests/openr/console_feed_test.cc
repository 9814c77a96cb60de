#include "openr/run/console_feed.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/temp_folder.h"
#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// A pipe in place of the standard input of this process.
class PipedInput {
 public:
  PipedInput() : saved_(dup(STDIN_FILENO)) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    dup2(ends[0], STDIN_FILENO);
    close(ends[0]);
    writer_ = ends[1];
    fcntl(writer_, F_SETFL, O_NONBLOCK);
  }
  ~PipedInput() {
    close(writer_);
    dup2(saved_, STDIN_FILENO);
    close(saved_);
  }
  PipedInput(const PipedInput&) = delete;
  PipedInput& operator=(const PipedInput&) = delete;

  // Writes `text` until the pipe is full, and returns the number of bytes written.
  size_t Write(std::string_view text) const {
    size_t count = 0;
    while (count < text.size()) {
      const ssize_t written = write(writer_, text.data() + count, text.size() - count);
      if (written <= 0) break;
      count += static_cast<size_t>(written);
    }
    return count;
  }

 private:
  const int saved_;  // descriptor of the previous standard input
  int writer_ = -1;
};

// Appends to `typed` the text that inputs `type` give to `system` from now on.
void ListenToTyping(System* system, std::string* typed) {
  system->inputs().OnAdd([typed](int, std::string_view line) {
    typed->append(line.substr(std::string_view("type ").size()));
  });
}

// Reads the console of its robot, without an end.
class LineReader : public CodeObject {
 public:
  LineReader() {
    entry_ = AddExtra("Read", [this](void*) {
      char line[1024];
      for (;;) text.append(line, system().console_input().Read(line, sizeof line));
    });
  }
  // Makes the object begin to read.
  void Begin() {
    const CurrentScope scope(&system(), &host());
    system().Post(system().NewMessage(host().id, entry_));
  }

  std::string text;  // all text that was read

 private:
  Selector entry_ = 0;
};

// Two robots, on which a long file is typed.
class TwoConsolesTest : public testing::Test {
 protected:
  TwoConsolesTest() {
    while (lines_.size() < 3 * ConsoleInput::kUnreadMax) lines_ += std::string(99, 'x') + '\n';
    std::ofstream(file()) << lines_;
    for (int robot = 0; robot < 2; ++robot) {
      system_.AddRobot("ERS-210", nullptr);
      readers_.push_back(system_.AddObject<LineReader>(robot, "reader"));
    }
    system_.inputs().OnAdd([this](int robot, std::string_view line) {
      typed_[static_cast<size_t>(robot)] += line.substr(std::string_view("type ").size());
    });
    system_.Boot();
  }
  std::string file() const { return folder_.path() + "/typed.txt"; }
  static SystemOptions Options() {
    SystemOptions options;
    options.console = [](std::string_view) {};  // the echo of what is read
    return options;
  }
  void Feed(ConsoleFeed* feed, int frames = 20) {
    for (int i = 0; i < frames; ++i) {
      feed->Feed(&system_);
      system_.RunFor(kFrameUs);
    }
  }
  size_t CountFindings() const {
    return static_cast<size_t>(std::count_if(
        system_.findings().all().begin(), system_.findings().all().end(), [](const Finding& one) {
          return one.text.find("typed text is missed") != std::string::npos;
        }));
  }

  static constexpr int kFrameUs = 8000;
  // Frames after which a robot that has not read misses text.
  static constexpr int kPatience = 20 + ConsoleFeed::kPatienceUs / kFrameUs;

  const TempFolder folder_;
  System system_{Options()};
  std::vector<LineReader*> readers_;
  std::string lines_;
  std::array<std::string, 2> typed_;
};

TEST_F(TwoConsolesTest, ARobotThatNeverReadsDoesNotStopTheOthers) {
  ConsoleFeed feed(file());
  readers_[1]->Begin();
  Feed(&feed, kPatience);
  EXPECT_EQ(typed_[1], lines_);
  EXPECT_EQ(readers_[1]->text, lines_);
  EXPECT_LE(typed_[0].size(), ConsoleInput::kUnreadMax);
  EXPECT_TRUE(lines_.starts_with(typed_[0]));
  EXPECT_FALSE(typed_[0].empty());
  EXPECT_EQ(CountFindings(), 1u);
}

TEST_F(TwoConsolesTest, ARobotThatReadsALittleLaterMissesNothing) {
  ConsoleFeed feed(file());
  for (const size_t robot : {1, 0}) {
    Feed(&feed, kPatience / 2);
    readers_[robot]->Begin();
  }
  Feed(&feed);
  for (const LineReader* const reader : readers_) EXPECT_EQ(reader->text, lines_);
  EXPECT_EQ(CountFindings(), 0u);
}

// The last line would fit on the terminal of the robot that misses text.
TEST_F(TwoConsolesTest, ARobotMissesAllTextUntilItReads) {
  const PipedInput input;
  ConsoleFeed feed("-");
  const std::string lines = lines_ + "short\n";
  readers_[1]->Begin();
  size_t written = 0;
  for (int i = 0; i < kPatience; ++i) {
    written += input.Write(std::string_view(lines).substr(written));
    Feed(&feed, 1);
  }
  EXPECT_EQ(readers_[1]->text, lines);
  EXPECT_TRUE(lines_.starts_with(typed_[0]));
  const std::string before = typed_[0];
  readers_[0]->Begin();
  Feed(&feed);
  EXPECT_EQ(input.Write("late\n"), 5u);
  Feed(&feed);
  EXPECT_EQ(readers_[0]->text, before + "late\n");
  EXPECT_EQ(readers_[1]->text, lines + "late\n");
  EXPECT_EQ(CountFindings(), 1u);
}

TEST_F(TwoConsolesTest, NothingIsMissedWhileNoRobotReads) {
  ConsoleFeed feed(file());
  Feed(&feed);
  EXPECT_EQ(typed_[0], typed_[1]);
  EXPECT_LE(typed_[0].size(), ConsoleInput::kUnreadMax);
  EXPECT_EQ(CountFindings(), 0u);
  for (LineReader* const reader : readers_) reader->Begin();
  Feed(&feed);
  EXPECT_EQ(readers_[0]->text, lines_);
  EXPECT_EQ(readers_[1]->text, lines_);
  EXPECT_EQ(CountFindings(), 0u);
}

TEST(ConsoleFeedTest, AFileIsTypedOnceOnEveryRobot) {
  const TempFolder folder;
  const std::string file = folder.path() + "/typed.txt";
  std::ofstream(file) << "one\ntwo";
  System system;
  system.AddRobot("ERS-210", nullptr);
  system.AddRobot("ERS-210", nullptr);
  std::string heard;
  system.inputs().OnAdd([&](int robot, std::string_view line) {
    heard += std::to_string(robot) + ":" + std::string(line);
  });
  ConsoleFeed feed(file);
  feed.Feed(&system);
  feed.Feed(&system);
  EXPECT_EQ(heard, "0:type one\ntwo1:type one\ntwo");
}

TEST(ConsoleFeedTest, AFileThatCannotBeReadIsNamed) {
  EXPECT_THROW(ConsoleFeed("/no/such/file"), std::runtime_error);
}

TEST(ConsoleFeedTest, StandardInputIsNotReadWhileNoProgramReadsWhatCameBefore) {
  const PipedInput input;
  System system;
  system.AddRobot("ERS-210", nullptr);
  std::string typed;
  ListenToTyping(&system, &typed);
  ConsoleFeed feed("-");
  std::string lines;
  while (lines.size() < 4 * ConsoleInput::kUnreadMax) lines += "1234567\n";
  size_t written = 0;
  for (int i = 0; i < 20; ++i) {
    written += input.Write(std::string_view(lines).substr(written));
    feed.Feed(&system);
  }
  EXPECT_EQ(typed, lines.substr(0, ConsoleInput::kUnreadMax));
  EXPECT_LT(written, lines.size());  // the writer has to wait
}

TEST(ConsoleFeedTest, ALineThatIsLongerThanTheConsoleIsBroken) {
  const PipedInput input;
  System system;
  system.AddRobot("ERS-210", nullptr);
  std::string typed;
  ListenToTyping(&system, &typed);
  ConsoleFeed feed("-");
  const std::string line(2 * ConsoleInput::kUnreadMax, 'x');
  size_t written = 0;
  for (int i = 0; i < 20; ++i) {
    written += input.Write(std::string_view(line).substr(written));
    feed.Feed(&system);
  }
  EXPECT_EQ(typed, line.substr(0, ConsoleInput::kUnreadMax - 1));
}

TEST(ConsoleFeedTest, ALongFileIsTypedInParts) {
  const TempFolder folder;
  const std::string file = folder.path() + "/typed.txt";
  std::string lines = "12\n";
  while (lines.size() < ConsoleInput::kUnreadMax + 100) lines += "1234567\n";
  std::ofstream(file) << lines;
  System system;
  system.AddRobot("ERS-210", nullptr);
  std::string typed;
  ListenToTyping(&system, &typed);
  ConsoleFeed feed(file);
  feed.Feed(&system);
  feed.Feed(&system);
  // The first part is the complete lines within 65,536 bytes: 3 bytes, and 8,191 times 8 bytes.
  EXPECT_EQ(typed, lines.substr(0, 3 + 8191 * 8));
}

}  // namespace
}  // namespace openr_host

// PromptHistory, and what Tab inserts.
#include "cli/prompt.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace openr_host {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

using Words = std::vector<std::string>;

TEST(PromptHistoryTest, KeepsLinesWithoutRepeats) {
  PromptHistory history;
  EXPECT_THAT(history.Lines(), IsEmpty());
  for (const char* const line : {"step", "", "back 5", "back 5", "step"}) history.Add(line);
  EXPECT_THAT(history.Lines(), ElementsAre("step", "back 5", "step"));
}

TEST(PromptHistoryTest, TheOldestLinesGiveWay) {
  PromptHistory history;
  for (int i = 0; i < 3000; ++i) history.Add("line " + std::to_string(i));
  const Words lines = history.Lines();
  EXPECT_EQ(lines.back(), "line 2999");
  EXPECT_GT(lines.size(), 1000u);
  EXPECT_EQ(lines.front(), "line " + std::to_string(3000 - lines.size()));
  history.Add(std::string(100'000, 'x'));  // larger than the history: is not kept
  EXPECT_EQ(history.Lines(), lines);
}

TEST(PromptHistoryTest, ACopyOfItsBytesHasTheSameLines) {
  PromptHistory history;
  history.Add("print hash");
  alignas(PromptHistory) char bytes[sizeof(PromptHistory)];
  std::memcpy(bytes, static_cast<const void*>(&history), sizeof bytes);
  EXPECT_THAT(reinterpret_cast<PromptHistory*>(bytes)->Lines(), ElementsAre("print hash"));
}

class ContinuationTest : public testing::Test {
 protected:
  // Returns what Tab inserts behind `begin`, and the choices that it shows.
  std::string After(const std::string& begin, Words* choices) {
    return Prompt(&history_,
                  [this](const Words& words, const std::string& start) -> Words {
                    start_ = start;
                    if (words.empty()) return {"step", "state", "print"};
                    if (words == Words{"print"}) return {"hash", "queue"};
                    return {};
                  })
        .Continuation(begin, choices);
  }
  std::string After(const std::string& begin) {
    Words choices;
    const std::string more = After(begin, &choices);
    EXPECT_THAT(choices, IsEmpty()) << begin;
    return more;
  }

  PromptHistory history_;
  std::string start_;  // beginning of the word that was completed last
};

TEST_F(ContinuationTest, TheSourceOfWordsKnowsWhatWasTyped) {
  After("print h");
  EXPECT_EQ(start_, "h");
  After("s");
  EXPECT_EQ(start_, "s");
  After("none ");
  EXPECT_EQ(start_, "");
}

TEST_F(ContinuationTest, AnOnlyWordIsCompletedWithABlank) {
  EXPECT_EQ(After("p"), "rint ");
  EXPECT_EQ(After("print h"), "ash ");
  EXPECT_EQ(After("  print   q"), "ueue ");
  EXPECT_EQ(After("print"), " ");
}

TEST_F(ContinuationTest, SeveralWordsAreCompletedAsFarAsTheyAgree) {
  EXPECT_EQ(After("s"), "t");
  Words choices;
  EXPECT_EQ(After("st", &choices), "");
  EXPECT_THAT(choices, ElementsAre("state", "step"));
  EXPECT_EQ(After("print ", &choices), "");
  EXPECT_THAT(choices, ElementsAre("hash", "queue"));
  EXPECT_EQ(After("", &choices), "");
  EXPECT_THAT(choices, ElementsAre("print", "state", "step"));
}

TEST_F(ContinuationTest, WhereNothingFitsNothingIsInserted) {
  EXPECT_EQ(After("x"), "");
  EXPECT_EQ(After("print hash "), "");
}

}  // namespace
}  // namespace openr_host

// The end of the process when what is to be said at it fails as well.
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "openr/ending/end_guards.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

// Ends this process as a crash would, with `action` as its EndingAction.
void End(const EndGuardOptions& options, const std::function<void(Ending*)>& action) {
  const EndGuards guards(options);
  const EndingAction ending_action(action);
  Ending ending;
  ending.record.Add("EXCEPTION here\n");
  ending.finding.Add("crash: here");
  BeginEnding(&ending);
  FinishEnding();
}

void ExpectShortReport(const std::string& text) {
  const nlohmann::json report = nlohmann::json::parse(text, nullptr, false);
  ASSERT_TRUE(report.is_object()) << text;
  EXPECT_EQ(report["error"], "EXCEPTION here");
  EXPECT_EQ(report["findings"].at(0)["severity"], "error");
  EXPECT_EQ(report["findings"].at(0)["text"], "crash: here");
}

TEST(EndingActionTest, TheAnswerIsGivenWhenNoActionGivesIt) {
  const ScratchFolder folder;
  EXPECT_EXIT(End({.answer_file = folder.File("r.json")}, [](Ending*) {}),
              ::testing::ExitedWithCode(1), "");
  ExpectShortReport(folder.Read("r.json"));
}

TEST(EndingActionTest, TheAnswerIsGivenWhenTheActionCrashesOrAborts) {
  const ScratchFolder folder;
  const auto crash = [](Ending*) { *reinterpret_cast<volatile int*>(16) = 1; };
  EXPECT_EXIT(End({.answer_file = folder.File("r.json")}, crash), ::testing::ExitedWithCode(1), "");
  ExpectShortReport(folder.Read("r.json"));
  EXPECT_EXIT(End({.answer_file = folder.File("a.json")}, [](Ending*) { std::abort(); }),
              ::testing::ExitedWithCode(1), "");
  ExpectShortReport(folder.Read("a.json"));
}

TEST(EndingActionTest, AnAnswerThatAnActionGaveIsNotGivenAgain) {
  const ScratchFolder folder;
  EXPECT_EXIT(
      End({.answer_file = folder.File("r.json")}, [](Ending* ending) { ending->answered = true; }),
      ::testing::ExitedWithCode(1), "");
  EXPECT_EQ(folder.Read("r.json"), "");
}

TEST(EndingActionTest, AProgramThatWaitsIsAnsweredThoughTheActionCrashes) {
  const ScratchFolder folder;
  const EndGuardOptions options{.answer_first = [&folder](Ending* ending) {
    folder.Write("first", std::string(ending->finding.text()));
  }};
  EXPECT_EXIT(End(options, [](Ending*) { std::abort(); }), ::testing::ExitedWithCode(1),
              "ended by crash: crash: here");
  EXPECT_EQ(folder.Read("first"), "crash: here");
}

TEST(EndingActionTest, TheLastLineIsLeftOutIfTheRunGoesOnWithoutThisProcess) {
  EXPECT_EXIT(End({.prints_end = false}, [](Ending*) {}), ::testing::ExitedWithCode(1), "^$");
}

}  // namespace
}  // namespace openr_host

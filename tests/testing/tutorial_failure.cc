// Tests that a failure prints what docs/testing.md shows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace {

using testing::HasSubstr;

std::string FileText(const char* name) {
  std::ifstream file(name);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// The tests of the page, on a Meter without its last line.
TEST(TutorialTest, TheFailureOfThePageIsTheRealOne) {
  std::string page = FileText(TUTORIAL "/failure.txt");
  ASSERT_GT(page.size(), 20u);
  page.pop_back();  // the last newline: a time follows
  FILE* const pipe = popen(FORGETFUL_TEST " 2>&1", "r");
  std::string output;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) output += static_cast<char>(c);
  EXPECT_NE(pclose(pipe), 0);
  EXPECT_THAT(output, HasSubstr(page));
  EXPECT_THAT(output, HasSubstr("Last messages:"));
  EXPECT_THAT(output, HasSubstr("bench.StepToMessage("));
}

// GoogleTest prints nothing at the start with --gtest_brief, so an object is the first to write to
// standard output.
TEST(BriefTest, TestsOfTheLibraryPassWhenNobodyPrintsBeforeTheObjects) {
  EXPECT_EQ(std::system(TESTING_TESTS " --gtest_brief=1 > brief.txt 2>&1"), 0)
      << FileText("brief.txt");
}

}  // namespace

// Scripts of timed inputs: openr run --events.
#include "openr/run/event_script.h"

#include <gmock/gmock.h>

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "runtime/base/temp_folder.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

class EventScriptTest : public ::testing::Test {
 protected:
  EventScriptTest() {
    system_.AddRobot("ERS-210", nullptr);
    system_.AddRobot("ERS-210", nullptr);
    system_.inputs().OnAdd([this](int robot, std::string_view line) {
      heard_.push_back(std::to_string(system_.now_us()) + " " + std::to_string(robot) + " " +
                       std::string(line));
    });
  }

  EventScript Script(const std::string& text) {
    std::ofstream(file_) << text;
    return EventScript(file_);
  }

  // Returns the error in the script `text`, without the folder of its file.
  std::string Error(const std::string& text) {
    try {
      const std::string problem = Script(text).Check(system_);
      return problem.empty() ? "" : problem.substr(folder_.path().size() + 1);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(folder_.path().size() + 1);
    }
  }

  const TempFolder folder_;
  const std::string file_ = folder_.path() + "/a.events";
  System system_;
  std::vector<std::string> heard_;
};

TEST_F(EventScriptTest, InputsComeWhenTheirTimeHasCome) {
  EventScript script = Script(
      "# a comment\n"
      "\n"
      "8ms   type one\r\n"
      "+16ms robot 1 type two   # so long after the line above\n"
      "24ms  type \"a # b\"");
  for (int i = 0; i < 5; ++i) {
    script.Feed(&system_);
    system_.RunFor(8000);
  }
  EXPECT_EQ(heard_, (std::vector<std::string>{"8000 0 type one", "24000 1 type two",
                                              "24000 0 type \"a # b\""}));
  script.ReportRest(&system_);
  EXPECT_FALSE(system_.findings().HasError());
}

TEST_F(EventScriptTest, MistakesAreNamedWithFileAndLine) {
  EXPECT_EQ(Error(""), "");
  EXPECT_EQ(Error("8ms type one\n"), "");
  EXPECT_THAT(Error("\nsoon type one\n"), HasSubstr("a.events:2: 'soon' is no duration"));
  EXPECT_THAT(Error("8 type one\n"), HasSubstr("a.events:1: '8' has no unit"));
  EXPECT_EQ(Error("8ms\n"), "a.events:1: has a time and no input");
  EXPECT_EQ(Error("8ms type a\n4ms type b\n"),
            "a.events:2: 4ms is before the time of the line above, 8ms");
  EXPECT_EQ(Error("8ms robot x type a\n"), "a.events:1: 'x' is no number of a robot");
  EXPECT_EQ(Error("8ms robot 2 type a\n"), "a.events:1: there is no robot 2; this run has 2");
  EXPECT_THAT(Error("8ms typo a\n"), HasSubstr("a.events:1: 'typo' is no input"));
  EXPECT_EQ(Error("\xef\xbb\xbf"
                  "8ms type a\n"),
            "a.events:1: the file starts with a UTF-8 byte order mark; save it without");
  EXPECT_THROW(EventScript("/no/such/file"), std::runtime_error);
}

TEST_F(EventScriptTest, InputsThatDoNotComeAreAnError) {
  EventScript script = Script("8ms type a\n1s type b\n2s type c\n");
  system_.RunFor(8000);
  script.Feed(&system_);
  script.ReportRest(&system_);
  ASSERT_EQ(system_.findings().all().size(), 1u);
  EXPECT_THAT(system_.findings().all()[0].text,
              HasSubstr("a.events:2: the run was over before t=1s; 2 inputs of the script"));
}

}  // namespace
}  // namespace openr_host

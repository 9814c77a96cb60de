// openr log, on logs of real play-back: those of the walk of the default stick.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

std::string StickMotion(const std::string& name) {
  return std::string(OPENR_STICK) + "/OPEN-R/MW/DATA/P/" + name;
}

const std::string kData = OPENR_TEST_DATA;

TEST(LogCommandTest, InfoNamesTheCaseOfTheReport) {
  const ProgramResult result = RunProgram({"log", "info", "--json", kData + "/walk.log"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["format"], "AIBO_1.1");
  EXPECT_EQ(json["robot"], "ERS-210");
  EXPECT_EQ(json["case"], "play-back on the robot");
  EXPECT_EQ(json["records"], 21);
  EXPECT_EQ(json["measured"], 21);
  EXPECT_EQ(json["simulated"], 0);
  EXPECT_DOUBLE_EQ(json["duration_s"].get<double>(), 0.64);
}

TEST(LogCommandTest, TimesOfAnInterpolatedMotionComeFromItsFile) {
  const std::string log = kData + "/bow.log";
  const auto alone = nlohmann::json::parse(RunProgram({"log", "info", "--json", log}).out);
  EXPECT_TRUE(alone["duration_s"].is_null());
  EXPECT_NE(alone["no_times"].get<std::string>().find("interpolated frames"), std::string::npos);
  const auto with = nlohmann::json::parse(
      RunProgram({"log", "info", "--json", log, "--motion", StickMotion("BOW.MTN")}).out);
  EXPECT_DOUBLE_EQ(with["duration_s"].get<double>(), 3.52);
  const ProgramResult wrong =
      RunProgram({"log", "plot", log, "--motion", StickMotion("WALK.MTN"), "-o", "none.svg"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.err.find("record 1: key frame 0 does not follow in the motion"),
            std::string::npos)
      << wrong.err;
}

TEST(LogCommandTest, CsvHasALineForEachRecord) {
  const ProgramResult result = RunProgram({"log", "csv", kData + "/walk.log"});
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.out.find("record,key_frame,time_ms,neck_tilt_commanded_deg,"), 0u);
  size_t lines = 0, commas = 0;
  for (const char c : result.out) {
    lines += c == '\n';
    commas += c == ',';
  }
  EXPECT_EQ(lines, 22u);
  EXPECT_EQ(commas, lines * (2 + 15 + 19 + 19));
}

TEST(LogCommandTest, ALogIsComparedWithWhatWasCommanded) {
  const ProgramResult result = RunProgram({"log", "compare", "--json", kData + "/walk.log"});
  ASSERT_EQ(result.status, 0) << result.err;
  const auto json = nlohmann::json::parse(result.out);
  EXPECT_EQ(json["a"], "commanded");
  EXPECT_EQ(json["b"], "measured");
  const auto& knee = json["joints"][5];
  EXPECT_EQ(knee["joint"], "LF_j3");
  EXPECT_GT(knee["lag_ms"], 10);
  EXPECT_LT(knee["lag_ms"], 40);
  EXPECT_LT(knee["rms_after_lag_deg"], knee["rms_deg"]);
  EXPECT_TRUE(json["joints"][1]["lag_ms"].is_null()) << "the head does not move";
}

TEST(LogCommandTest, AGroupIsNotComparedWithItself) {
  const struct {
    const char *flag, *group, *a, *b;
  } cases[] = {{"--group", "measured", "measured", "commanded"},
               {"--other-group", "measured", "commanded", "measured"},
               {"--group", "commanded", "commanded", "measured"},
               {"--other-group", "commanded", "measured", "commanded"}};
  for (const auto& c : cases) {
    const ProgramResult result =
        RunProgram({"log", "compare", "--json", kData + "/walk.log", c.flag, c.group});
    ASSERT_EQ(result.status, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    EXPECT_EQ(json["a"], c.a) << c.flag << " " << c.group;
    EXPECT_EQ(json["b"], c.b) << c.flag << " " << c.group;
  }
}

TEST(LogCommandTest, ALogEqualsItself) {
  const std::string log = kData + "/walk.log";
  const auto json = nlohmann::json::parse(RunProgram({"log", "compare", "--json", log, log}).out);
  for (const auto& joint : json["joints"]) {
    EXPECT_EQ(joint["rms_deg"], 0);
    if (joint["lag_ms"].is_null()) continue;
    EXPECT_NEAR(joint["lag_ms"].get<double>(), 0, 0.01);
  }
}

TEST(LogCommandTest, ChartsAreSvgAndPng) {
  const ScratchFolder folder;
  const ProgramResult svg =
      RunProgram({"log", "plot", kData + "/walk.log", "-o", folder.File("walk.svg")});
  if (svg.err.find("they need Cairo") != std::string::npos) GTEST_SKIP() << svg.err;
  EXPECT_EQ(svg.status, 0) << svg.err;
  EXPECT_NE(folder.Read("walk.svg").find("<svg"), std::string::npos);
  EXPECT_EQ(
      RunProgram({"log", "compare", kData + "/walk.log", "-o", folder.File("walk.png")}).status, 0);
  EXPECT_EQ(folder.Read("walk.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
}

TEST(LogCommandTest, MistakesAreNamed) {
  const ScratchFolder folder;
  folder.Write("BAD.LOG", "AIBO_1.1?");
  const struct {
    std::vector<std::string> words;
    int status;
    const char* complaint;
  } cases[] = {
      {{"log", "info", folder.File("BAD.LOG")}, 1, "BAD.LOG: offset 8: record 0: the file ends"},
      {{"log", "info", folder.File("NONE.LOG")}, 1, "NONE.LOG: No such file"},
      {{"log", "plot", kData + "/walk.log", "-o", "walk.pdf"}, 2, "ends in .svg or .png"},
      {{"log", "plot", kData + "/walk.log"}, 2, "--output"},
      {{"log", "compare", kData + "/walk.log", "--group", "simulated"},
       1,
       "walk.log: has no simulated values"},
  };
  for (const auto& c : cases) {
    const ProgramResult result = RunProgram(c.words);
    EXPECT_EQ(result.status, c.status) << c.complaint;
    EXPECT_NE(result.err.find(c.complaint), std::string::npos) << result.err;
  }
}

}  // namespace
}  // namespace openr_host

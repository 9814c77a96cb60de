// Logs of play-back in the three cases of Hohl 2004, section 3.3.6, from robots that run.
#include <gtest/gtest.h>

#include "cli/process.h"
#include "openr/motion/log_merge.h"
#include "tests/openr/rc_robot.h"

namespace openr_host {
namespace {

class RcPlayWithTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    real_ = new RcRobot;
    other_ = new RcRobot;
  }
  static void TearDownTestSuite() {
    delete real_;
    delete other_;
  }
  void SetUp() override {
    ASSERT_EQ(real_->Problem(), "");
    ASSERT_EQ(other_->Problem(), "");
  }

  static RcRobot* real_;
  static RcRobot* other_;
};

RcRobot* RcPlayWithTest::real_ = nullptr;
RcRobot* RcPlayWithTest::other_ = nullptr;

nlohmann::json InfoOf(const std::string& log) {
  const ProgramResult result = RunProgram({"log", "info", "--json", log});
  EXPECT_EQ(result.status, 0) << result.err;
  return nlohmann::json::parse(result.out);
}

// Lets the reader that was made from the report alone read the log, and counts its lines that
// contain `text`.
int LinesOfReader(const std::string& log, const std::string& text) {
  ProcessOptions options;
  options.captures_out = true;
  const ProcessResult read = RunProcess({"python3", OPENR_LOG_READER, log}, options);
  EXPECT_EQ(read.status, 0);
  int count = 0;
  for (size_t at = 0; at < read.output.size(); at = read.output.find('\n', at) + 1) {
    const std::string line = read.output.substr(at, read.output.find('\n', at) - at);
    count += line.find(text) != std::string::npos;
  }
  return count;
}

TEST_F(RcPlayWithTest, ALogOfTheRobotHasMeasuredValues) {
  const ScratchFolder folder;
  const std::string log = folder.File("REAL.LOG");
  real_->Answers({"mtn", "play", "WALK.MTN", "--log", log});
  EXPECT_EQ(InfoOf(log)["case"], "play-back on the robot");
  EXPECT_EQ(LinesOfReader(log, " simulated -"), 21);
}

TEST_F(RcPlayWithTest, ALogOfASimulationHasSimulatedValues) {
  const ScratchFolder folder;
  const std::string log = folder.File("SIM.LOG");
  real_->Answers({"mtn", "play", "WALK.MTN", "--log", log, "--simulated"});
  EXPECT_EQ(InfoOf(log)["case"], "simulated play-back");
  EXPECT_EQ(LinesOfReader(log, " measured - simulated "), 21);
}

TEST_F(RcPlayWithTest, ASynchronisedLogHasTheValuesOfBothAtTheSameKeyFrame) {
  const ScratchFolder folder;
  const std::string log = folder.File("BOTH.LOG");
  const auto answers = real_->Answers(
      {"mtn", "play", "BOW.MTN", "--loops", "2", "--log", log, "--with", other_->address()});
  ASSERT_EQ(answers.size(), 1u);
  const nlohmann::json info = InfoOf(log);
  EXPECT_EQ(info["case"], "synchronised play-back");
  EXPECT_EQ(info["records"], answers[0]["records"]);
  EXPECT_EQ(info["measured"], info["records"]);
  EXPECT_EQ(info["simulated"], info["records"]);
  EXPECT_EQ(LinesOfReader(log, " paws "), info["records"]);
  // Ideal joints are where they are commanded: a value of another key frame would show.
  const LogFile read = ParseLog(folder.Read("BOTH.LOG"));
  for (size_t i = 1; i < read.records.size(); ++i) {
    EXPECT_EQ(read.records[i].measured->positions_cdeg, read.records[i].commanded_cdeg) << i;
    EXPECT_EQ(read.records[i].simulated->positions_cdeg, read.records[i].commanded_cdeg) << i;
  }
}

TEST_F(RcPlayWithTest, WhenTheOtherRobotRefusesNoneGoesOn) {
  const ScratchFolder folder;
  folder.Write("ONLY.MTN", [] {
    std::ifstream file(std::string(OPENR_STICK) + "/OPEN-R/MW/DATA/P/BOW.MTN", std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  }());
  ASSERT_EQ(real_->Rc({"mtn", "upload", folder.File("ONLY.MTN")}).status, 0);
  const ProgramResult refused = real_->Rc({"mtn", "play", "ONLY.MTN", "--loops", "1000", "--log",
                                           folder.File("NO.LOG"), "--with", other_->address()});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find(other_->address()), std::string::npos) << refused.err;
  EXPECT_FALSE(std::filesystem::exists(folder.File("NO.LOG")));
  EXPECT_EQ(real_->Answers({"mtn", "play", "WALK.MTN"}).size(), 1u) << "the first one was stopped";
}

TEST_F(RcPlayWithTest, WhenTheOtherRobotIsNotThereNothingPlays) {
  const ScratchFolder folder;
  const ProgramResult refused = real_->Rc({"mtn", "play", "WALK.MTN", "--loops", "1000", "--log",
                                           folder.File("NO.LOG"), "--with", "127.0.0.1:1"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("127.0.0.1:1: no program listens there"), std::string::npos)
      << refused.err;
  EXPECT_EQ(real_->Answers({"info"})[0]["state"], "accepting-commands");
}

TEST_F(RcPlayWithTest, FlagsThatDoNotFitAreRefused) {
  const ScratchFolder folder;
  EXPECT_EQ(real_
                ->Rc({"mtn", "play", "WALK.MTN", "--log", folder.File("NO.LOG"), "--simulated",
                      "--with", other_->address()})
                .status,
            2);
  EXPECT_EQ(real_->Rc({"mtn", "play", "WALK.MTN", "--simulated"}).status, 2);
}

// ---- Putting logs together -----------------------------------------------------------

LogFile SmallLog(const std::vector<int>& key_frames, int16_t commanded_cdeg) {
  LogFile log{FindRobot("ERS-210"), {}};
  for (const int key_frame : key_frames) {
    LogRecord record;
    record.key_frame = key_frame;
    record.commanded_cdeg.assign(15, commanded_cdeg);
    record.measured = LogValues{record.commanded_cdeg, {}};
    log.records.push_back(record);
  }
  return log;
}

std::string MergeProblem(const LogFile& real, const LogFile& other) {
  try {
    MergeLogs(real, other);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(MergeLogsTest, ARobotThatEndsEarlierLeavesRecordsWithoutItsValues) {
  const LogFile merged = MergeLogs(SmallLog({0, 2, 4}, 100), SmallLog({0, 2}, 101));
  ASSERT_EQ(merged.records.size(), 3u);
  EXPECT_TRUE(merged.records[1].simulated.has_value());
  EXPECT_FALSE(merged.records[2].simulated.has_value());
}

TEST(MergeLogsTest, DifferentMotionsAreRefused) {
  EXPECT_EQ(MergeProblem(SmallLog({0, 2, 4}, 0), SmallLog({0, 2, 6}, 0)),
            "record 2 is of key frame 4 of the first robot and 6 of the other: they have not "
            "played the same motion");
  EXPECT_EQ(MergeProblem(SmallLog({0, 2}, 0), SmallLog({0, 2}, 300)),
            "key frame 2: neck_tilt was commanded to 0.00 degrees by the first robot and to 3.00 "
            "by the other: the files on their sticks differ");
}

// The script moves two simulated dogs of which one has other servos.
TEST(SimToRealTest, TheLogGivesBackTheDifferencesThatWerePutIn) {
  ProcessOptions options;
  options.captures_out = true;
  const std::filesystem::path build = std::filesystem::path(OPENR_PROGRAM).parent_path() / "..";
  const ProcessResult run =
      RunProcess({"python3", OPENR_SIM_TO_REAL, "--build", build.string(), "--json"}, options);
  ASSERT_TRUE(nlohmann::json::accept(run.output)) << run.output;
  const auto rows = nlohmann::json::parse(run.output);
  ASSERT_EQ(rows.size(), 15u);
  for (const auto& row : rows) {
    SCOPED_TRACE(row.dump());
    // The weight of the head, which the equation of the servo leaves out, acts on one joint.
    const bool has_weight = row["joint"] == "neck_tilt";
    EXPECT_NEAR(row["lag_ms"].get<double>(), row["lag_put_in_ms"].get<double>(),
                has_weight ? 6 : 1);
    EXPECT_NEAR(row["gain"].get<double>(), row["gain_put_in"].get<double>(),
                has_weight ? 0.02 : 0.005);
    if (has_weight) continue;
    const double p = row["p_real"].get<double>();
    EXPECT_NEAR(row["p_given_back"].get<double>(), p, 0.05 * p);
  }
  EXPECT_EQ(run.status, 0);
}

}  // namespace
}  // namespace openr_host

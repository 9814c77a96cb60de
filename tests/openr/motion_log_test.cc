// Log files of motions (AIBO_1.1): reader, writer, times and comparison.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "cli/process.h"
#include "openr/motion/log_compare.h"
#include "openr/motion/log_file.h"
#include "openr/motion/log_times.h"
#include "tests/objects/mtn_bytes.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

constexpr int kLogJoints = 15;  // joints in a log of the ERS-210

LogValues ValuesFrom(int first_cdeg) {
  LogValues values;
  for (int j = 0; j < kLogJoints; ++j)
    values.positions_cdeg.push_back(static_cast<int16_t>(first_cdeg - 100 * j));
  values.paws = {1, 0, 0, 1};
  return values;
}

LogRecord RecordOf(int key_frame, bool measured, bool simulated) {
  LogRecord record;
  record.key_frame = key_frame;
  record.commanded_cdeg = ValuesFrom(3000).positions_cdeg;
  if (measured) record.measured = ValuesFrom(2950);
  if (simulated) record.simulated = ValuesFrom(-7);
  return record;
}

LogFile LogOf(std::vector<LogRecord> records) { return {FindRobot("ERS-210"), std::move(records)}; }

std::string ParseProblem(const std::string& bytes) {
  try {
    ParseLog(bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(MotionLogFileTest, ARecordHasTheBytesOfTable39) {
  const std::string bytes = FormatLog(LogOf({RecordOf(258, true, false)}));
  EXPECT_EQ(bytes.substr(0, 8), "AIBO_1.1");
  ASSERT_EQ(bytes.size(), 8u + 2 + 30 + 1 + 38 + 1);
  EXPECT_EQ(bytes.substr(8, 4), std::string("\x02\x01\xb8\x0b", 4)) << "258, then 30.00 degrees";
  EXPECT_EQ(bytes[8 + 32], 19);
  EXPECT_EQ(bytes.substr(8 + 33 + 30, 8), std::string("\x01\0\0\0\0\0\x01\0", 8)) << "paws";
  EXPECT_EQ(bytes.back(), 0) << "no simulated values";
}

TEST(MotionLogFileTest, WhatIsWrittenIsReadAgain) {
  const LogFile log = LogOf({RecordOf(0, true, true), RecordOf(2, false, true),
                             RecordOf(4, true, false), RecordOf(6, false, false)});
  EXPECT_EQ(ParseLog(FormatLog(log)).records, log.records);
}

TEST(MotionLogFileTest, ALogOfTheErs7HasItsOwnJoints) {
  LogFile log{FindRobot("ERS-7"), {}};
  const size_t joints = LoggedJoints(*log.robot).size();
  EXPECT_EQ(joints, 18u);
  LogRecord record;
  record.commanded_cdeg.assign(joints, 100);
  record.measured = LogValues{record.commanded_cdeg, {1, 1, 1, 1}};
  log.records = {record, record};
  const LogFile read = ParseLog(FormatLog(log));
  EXPECT_STREQ(read.robot->design, "ERS-7");
  EXPECT_EQ(read.records, log.records);
}

TEST(MotionLogFileTest, MistakesAreNamedWithTheirOffset) {
  const std::string good = FormatLog(LogOf({RecordOf(0, true, true)}));
  EXPECT_EQ(ParseProblem("AIBO_1.0" + good.substr(8)),
            "offset 0: a log file begins with 'AIBO_1.1', this one does not");
  EXPECT_EQ(ParseProblem("AIB"), "offset 0: a log file begins with 'AIBO_1.1', this one does not");
  std::string bytes = good;
  bytes[9] = '\xff';
  EXPECT_EQ(ParseProblem(bytes), "offset 8: record 0: key frame is -256, must be 0 to 32767");
  bytes = good;
  bytes[40] = 18;
  EXPECT_EQ(ParseProblem(bytes), "offset 40: record 0: says 18 measured values, must be 0 or 19");
  bytes = good;
  bytes[41 + 30 + 2] = 2;
  EXPECT_EQ(ParseProblem(bytes),
            "offset 73: record 0: measured paw left hind is 2, must be 0 or 1");
}

TEST(MotionLogFileTest, AFileThatEndsInsideARecordIsRefusedWhereverItEnds) {
  const std::string good = FormatLog(LogOf({RecordOf(0, true, true), RecordOf(2, true, true)}));
  const size_t record_size = (good.size() - 8) / 2;
  for (size_t size = 9; size < good.size(); ++size) {
    if (size == 8 + record_size) continue;  // a whole record
    EXPECT_NE(ParseProblem(good.substr(0, size)), "") << size;
  }
  EXPECT_EQ(ParseProblem(good.substr(0, 60)),
            "offset 41: record 0: the file ends, 19 of 30 bytes of its measured positions are "
            "there");
}

TEST(MotionLogFileTest, AReaderMadeFromTheReportAloneReadsAllThreeCases) {
  const ScratchFolder folder;
  const struct { bool measured, simulated; } cases[] = {{false, true}, {true, false}, {true, true}};
  const std::string values =
      "29.50 28.50 27.50 26.50 25.50 24.50 23.50 22.50 21.50 20.50 19.50 "
      "18.50 17.50 16.50 15.50 paws 1001";
  for (const auto& c : cases) {
    folder.Write("LOG.LOG", FormatLog(LogOf({RecordOf(0, c.measured, c.simulated),
                                             RecordOf(32767, c.measured, c.simulated)})));
    ProcessOptions options;
    options.captures_out = true;
    const ProcessResult read =
        RunProcess({"python3", OPENR_LOG_READER, folder.File("LOG.LOG")}, options);
    EXPECT_EQ(read.status, 0);
    EXPECT_EQ(read.output.find("0 commanded 30.00 29.00 "), 0u) << read.output;
    EXPECT_NE(read.output.find("\n32767 commanded 30.00 29.00 "), std::string::npos);
    EXPECT_NE(read.output.find("measured " + (c.measured ? values : "-") + " simulated"),
              std::string::npos)
        << read.output;
    EXPECT_NE(read.output.find(c.simulated ? "simulated -0.07 -1.07 " : "simulated -\n"),
              std::string::npos)
        << read.output;
  }
}

// ---- Times ---------------------------------------------------------------------------

LogFile LogWithKeyFrames(const std::vector<int>& key_frames) {
  LogFile log = LogOf({});
  for (const int key_frame : key_frames) log.records.push_back(RecordOf(key_frame, true, false));
  return log;
}

std::string TimesProblem(const LogFile& log) {
  try {
    TimesOf(log);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(MotionLogTimesTest, KeyFramesAre16MillisecondsApart) {
  EXPECT_EQ(TimesOf(LogWithKeyFrames({0, 2, 4, 5})), (std::vector<double>{0, 32, 64, 80}));
}

TEST(MotionLogTimesTest, TheNextLoopBeginsWhereTheOneBeforeEnds) {
  EXPECT_EQ(TimesOf(LogWithKeyFrames({0, 2, 4, 5, 2, 4, 5})),
            (std::vector<double>{0, 32, 64, 80, 112, 144, 160}));
}

TEST(MotionLogTimesTest, WithoutTheMotionInterpolatedFramesAreRefused) {
  EXPECT_EQ(TimesProblem(LogWithKeyFrames({0, 2, 2, 4})).find("record 2: key frame 2 again"), 0u);
  EXPECT_NE(TimesProblem(LogWithKeyFrames({0, 2, 2, 2})).find("or is short and repeats"),
            std::string::npos);
  EXPECT_EQ(TimesProblem(LogWithKeyFrames({0, 2, 4, 0, 2})),
            "record 3: another motion begins; a log to be read has one motion");
}

TEST(MotionLogTimesTest, TheLogOfAMotionWithOneKeyFrameHasThisKeyFrame) {
  const std::vector<uint8_t> bytes = MtnBytes::OneJoint("PRM:/r1/c1-Joint2:j1", {0}).Bytes();
  MtnFile motion;
  ASSERT_TRUE(motion.Read(bytes.data(), bytes.size())) << motion.Error();
  EXPECT_EQ(TimesOf(LogWithKeyFrames({}), motion), std::vector<double>{});
  EXPECT_EQ(TimesOf(LogWithKeyFrames({0}), motion), std::vector<double>{0});
  EXPECT_THROW(TimesOf(LogWithKeyFrames({5}), motion), std::runtime_error);
  EXPECT_THROW(TimesOf(LogWithKeyFrames({0, 0}), motion), std::runtime_error);
}

// ---- Comparison ----------------------------------------------------------------------

// All joints move as `degrees` says.
template <typename Function>
JointTraces Moving(Function degrees, double step_ms = 32) {
  JointTraces traces;
  traces.deg.resize(kLogJoints);
  for (double time = 0; time <= 2400; time += step_ms) {
    traces.times_ms.push_back(time);
    for (auto& joint : traces.deg) joint.push_back(degrees(time));
  }
  return traces;
}

double SwingAngle(double time_ms) { return 20 * std::sin(2 * M_PI * time_ms / 1000); }

TEST(MotionLogCompareTest, ALagBelowOneKeyFrameIsFound) {
  for (const double lag_ms : {-50.0, -7.0, 0.0, 3.0, 21.5, 90.0}) {
    const auto differences =
        CompareTraces(Moving(SwingAngle), Moving([&](double t) { return SwingAngle(t - lag_ms); }));
    ASSERT_EQ(differences.size(), static_cast<size_t>(kLogJoints));
    ASSERT_TRUE(differences[4].lag_ms.has_value());
    EXPECT_NEAR(*differences[4].lag_ms, lag_ms, 0.5);
    EXPECT_NEAR(*differences[4].rms_after_lag_deg, 0, 0.1);
  }
}

TEST(MotionLogCompareTest, OffsetAndGainDoNotMoveTheLag) {
  const auto differences = CompareTraces(
      Moving(SwingAngle), Moving([](double t) { return 5 + 0.8 * SwingAngle(t - 40); }, 40));
  EXPECT_NEAR(differences[0].lag_ms.value_or(0), 40, 1);
  EXPECT_NEAR(differences[0].gain.value_or(0), 0.8, 0.01);
}

TEST(MotionLogCompareTest, WhatIsLeftAfterTheLagIsTheOffset) {
  const auto differences =
      CompareTraces(Moving(SwingAngle), Moving([](double t) { return 3 + SwingAngle(t - 40); }));
  EXPECT_GT(differences[0].rms_deg, 4);
  EXPECT_NEAR(differences[0].rms_after_lag_deg.value_or(0), 3, 0.05);
}

TEST(MotionLogCompareTest, ErrorsAreThoseOfTheSameTime) {
  const auto differences =
      CompareTraces(Moving(SwingAngle), Moving([](double t) { return SwingAngle(t) - 3; }));
  EXPECT_NEAR(differences[7].mean_deg, -3, 1e-9);
  EXPECT_NEAR(differences[7].max_deg, 3, 1e-9);
  EXPECT_NEAR(differences[7].rms_deg, 3, 1e-9);
}

TEST(MotionLogCompareTest, AJointAtRestHasNoLag) {
  const auto rest = Moving([](double t) { return 0.2 * SwingAngle(t) / 20; });
  const auto differences = CompareTraces(rest, Moving(SwingAngle));
  EXPECT_FALSE(differences[0].lag_ms.has_value());
  EXPECT_FALSE(differences[0].gain.has_value());
}

TEST(MotionLogCompareTest, OppositeMotionsHaveNoLag) {
  const auto ramp = Moving([](double t) { return t / 100; });
  const auto back = Moving([](double t) { return -t / 100; });
  EXPECT_FALSE(CompareTraces(ramp, back)[0].lag_ms.has_value());
}

}  // namespace
}  // namespace openr_host

#include "openr/motion/log_compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

constexpr double kDegPerCdeg = 0.01;
// The first search for the lag between two motions tries only shifts of time that are multiples of
// this time.
constexpr double kShiftStepMs = 4;
// The second search for the lag between two motions tries only shifts of time that differ by at
// most this much from the best shift of the first search.
constexpr double kNearMs = 16;
constexpr double kLagToleranceMs = 0.01;

// A cubic curve through the positions of a joint, which gives the positions between the records of
// a log.  Its slope at a record is the slope of the line through both neighbours of the record.
class Curve {
 public:
  // Makes a curve through the points (time, position in degrees).  REQUIRES: two or more points,
  // and rising times.
  Curve(const std::vector<double>& times, const std::vector<double>& values)
      : times_(times), values_(values), slopes_(times.size()) {
    ASSERT(times.size() >= 2 && values.size() == times.size(), "{} times, {} values", times.size(),
           values.size());
    const size_t last = times.size() - 1;
    for (size_t i = 0; i <= last; ++i) {
      const size_t from = i > 0 ? i - 1 : 0, to = std::min(i + 1, last);
      slopes_[i] = (values[to] - values[from]) / (times[to] - times[from]);
    }
  }

  double At(double time) const {
    const auto above = std::upper_bound(times_.begin() + 1, times_.end() - 1, time);
    const auto i = static_cast<size_t>(above - times_.begin()) - 1;
    const double width = times_[i + 1] - times_[i];
    const double u = (time - times_[i]) / width, v = 1 - u;
    return v * v * (1 + 2 * u) * values_[i] + u * u * (1 + 2 * v) * values_[i + 1] +
           width * u * v * (v * slopes_[i] - u * slopes_[i + 1]);
  }

 private:
  const std::vector<double>& times_;
  const std::vector<double>& values_;
  std::vector<double> slopes_;
};

// The straight line that best describes the positions in motion B as a function of the positions in
// motion A.
struct FittedLine {
  double gain = 0;
  // Fraction of the variance of motion B that the straight line (offset and gain) does not explain,
  // 0 to 1.
  double unexplained = 1;
};

FittedLine FitLine(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double sum_a = 0, sum_b = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    sum_a += a[i];
    sum_b += b[i];
  }
  double aa = 0, bb = 0, ab = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    const double da = a[i] - sum_a / n, db = b[i] - sum_b / n;
    aa += da * da;
    bb += db * db;
    ab += da * db;
  }
  // Returns no fit (unexplained = 1) if the joint does not move in motion A or in motion B, or if
  // it moves in opposite directions in A and B, because A and B are not the same movement then.
  if (aa <= 0 || bb <= 0 || ab <= 0) return {};
  return {ab / aa, 1 - ab * ab / (aa * bb)};
}

double RootMeanSquare(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += (b[i] - a[i]) * (b[i] - a[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

bool Moves(const std::vector<double>& deg) {
  const auto [low, high] = std::minmax_element(deg.begin(), deg.end());
  return *high - *low >= kMovesDeg;
}

// Finds the lag of one joint in two searches.  Each search uses the same records for all its
// shifts, so that the number of records does not influence the result.  A record of motion A can be
// used only if no shift moves it out of the time that A and motion B have in common.  The first
// search tries large shifts, so it has to leave out many records.  The second search tries only
// shifts near the result of the first one, so it uses nearly all records.
class LagSearch {
 public:
  LagSearch(const JointTraces& a, const JointTraces& b, size_t joint)
      : a_(a),
        joint_(joint),
        curve_(b.times_ms, b.deg[joint]),
        begin_ms_(std::max(a.times_ms.front(), b.times_ms.front())),
        end_ms_(std::min(a.times_ms.back(), b.times_ms.back())) {}

  void Search(JointDifference* found) {
    // Limits the lag to a quarter of the time that both motions have in common.  CopyRecords()
    // leaves out the records in this much time at each end, so at least half of the common time is
    // left for the comparison.
    const double most = std::min(kLagMaxMs, (end_ms_ - begin_ms_) / 4);
    CopyRecords(most);
    if (times_.size() < static_cast<size_t>(kSamplesMin) || !Moves(a_.deg[joint_])) return;
    const int steps = static_cast<int>(most / kShiftStepMs);
    int best = -steps;
    for (int s = -steps; s <= steps; ++s) {
      if (Unexplained(s * kShiftStepMs) < Unexplained(best * kShiftStepMs)) best = s;
    }
    // Reports no lag if the best lag is the first or the last of the tried lags, because the real
    // minimum may then lie outside of the range.
    if (best == -steps || best == steps) return;
    const double near_ms = best * kShiftStepMs;
    CopyRecords(std::abs(near_ms) + kNearMs);
    const double lag_ms = Minimum(near_ms - kNearMs, near_ms + kNearMs);
    found->lag_ms = lag_ms;
    const std::vector<double> shifted = Shifted(lag_ms);
    found->gain = FitLine(a_deg_, shifted).gain;
    found->rms_after_lag_deg = RootMeanSquare(a_deg_, shifted);
  }

 private:
  // Copies the records (positions at key frames) of motion A.  Leaves out a record if a shift by up
  // to `margin_ms` could move it out of the time that A and motion B have in common.
  void CopyRecords(double margin_ms) {
    times_.clear();
    a_deg_.clear();
    for (size_t i = 0; i < a_.times_ms.size(); ++i) {
      const double time = a_.times_ms[i];
      if (time < begin_ms_ + margin_ms || time > end_ms_ - margin_ms) continue;
      times_.push_back(time);
      a_deg_.push_back(a_.deg[joint_][i]);
    }
  }

  // Returns the shift of time between `low_ms` and `high_ms` with which the positions in motion B
  // are best described by those in motion A (least unexplained variance).  Uses golden-section
  // search: each step keeps 0.618 of the interval.
  double Minimum(double low_ms, double high_ms) const {
    constexpr double kGolden = 0.6180339887498949;
    while (high_ms - low_ms > kLagToleranceMs) {
      const double width = kGolden * (high_ms - low_ms);
      if (Unexplained(high_ms - width) < Unexplained(low_ms + width)) {
        high_ms = low_ms + width;
      } else {
        low_ms = high_ms - width;
      }
    }
    return (low_ms + high_ms) / 2;
  }

  std::vector<double> Shifted(double shift_ms) const {
    std::vector<double> values;
    for (const double time : times_) values.push_back(curve_.At(time + shift_ms));
    return values;
  }
  double Unexplained(double shift_ms) const {
    return FitLine(a_deg_, Shifted(shift_ms)).unexplained;
  }

  const JointTraces& a_;
  const size_t joint_;
  const Curve curve_;
  const double begin_ms_, end_ms_;  // limits of the time that the motions A and B have in common
  std::vector<double> times_, a_deg_;
};

JointDifference CompareJoint(const JointTraces& a, const JointTraces& b, size_t joint) {
  const Curve curve(b.times_ms, b.deg[joint]);
  std::vector<double> a_deg, b_deg;
  JointDifference difference;
  for (size_t i = 0; i < a.times_ms.size(); ++i) {
    const double time = a.times_ms[i];
    if (time < b.times_ms.front() || time > b.times_ms.back()) continue;
    a_deg.push_back(a.deg[joint][i]);
    b_deg.push_back(curve.At(time));
    const double error = b_deg.back() - a_deg.back();
    difference.mean_deg += error;
    difference.max_deg = std::max(difference.max_deg, std::abs(error));
  }
  if (a_deg.empty()) throw std::runtime_error("the logs have no time in common");
  difference.mean_deg /= static_cast<double>(a_deg.size());
  difference.rms_deg = RootMeanSquare(a_deg, b_deg);
  LagSearch(a, b, joint).Search(&difference);
  return difference;
}

const std::vector<int16_t>* PositionsOf(const LogRecord& record, LogGroup group) {
  if (group == LogGroup::kCommanded) return &record.commanded_cdeg;
  const auto& values = group == LogGroup::kMeasured ? record.measured : record.simulated;
  return values ? &values->positions_cdeg : nullptr;
}

}  // namespace

const char* NameOf(LogGroup group) {
  switch (group) {
    case LogGroup::kCommanded:
      return "commanded";
    case LogGroup::kMeasured:
      return "measured";
    default:
      return "simulated";
  }
}

JointTraces TracesOf(const LogFile& log, const std::vector<double>& times_ms, LogGroup group) {
  ASSERT(times_ms.size() == log.records.size(), "{} times", times_ms.size());
  JointTraces traces;
  traces.deg.resize(LoggedJoints(*log.robot).size());
  for (size_t i = 0; i < log.records.size(); ++i) {
    const std::vector<int16_t>* const positions = PositionsOf(log.records[i], group);
    if (positions == nullptr) continue;
    traces.times_ms.push_back(times_ms[i]);
    for (size_t j = 0; j < traces.deg.size(); ++j)
      traces.deg[j].push_back((*positions)[j] * kDegPerCdeg);
  }
  return traces;
}

std::vector<JointDifference> CompareTraces(const JointTraces& a, const JointTraces& b) {
  ASSERT(a.deg.size() == b.deg.size(), "{} and {} joints", a.deg.size(), b.deg.size());
  if (a.times_ms.size() < 2 || b.times_ms.size() < 2)
    throw std::runtime_error("a comparison needs two records of each log");
  std::vector<JointDifference> differences;
  for (size_t j = 0; j < a.deg.size(); ++j) differences.push_back(CompareJoint(a, b, j));
  return differences;
}

std::string Rounded(double value, int decimals) {
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return is_zero && text[0] == '-' ? text.substr(1) : text;
}

}  // namespace openr_host

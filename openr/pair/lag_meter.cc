#include "openr/pair/lag_meter.h"

#include <algorithm>
#include <limits>

namespace openr_host {
namespace {

constexpr int64_t kStepMs = 4;
constexpr size_t kSamplesMin = 10;
// Largest misfit between the movements of two robots at which LagMs() still returns a lag; the
// misfit is 0 if the follower repeats the leader's movement exactly.  A larger misfit means that
// the follower does not follow the leader.
constexpr double kMisfitMax = 0.25;
// A misfit (difference between the movements of two robots) counts as equally good as the smallest
// one if it is at most this much larger.
constexpr double kNearBest = 0.05;

}  // namespace

void LagMeter::Add(Series* series, int64_t time_ms, const std::vector<int32_t>& joints) {
  if (!series->empty() && series->front().joints.size() != joints.size()) return;
  // Keeps the times of the positions in order: `time_ms` may be earlier than the time of the last
  // positions, because RemotePair changes its estimate of the travel time of packets.
  if (!series->empty()) time_ms = std::max(time_ms, series->back().time_ms);
  series->push_back({time_ms, joints});
  while (series->front().time_ms < time_ms - kWindowMs - kLagMaxMs) series->pop_front();
}

void LagMeter::AddLeader(int64_t time_ms, const std::vector<int32_t>& joints) {
  Add(&leader_, time_ms, joints);
}

void LagMeter::AddFollower(int64_t time_ms, const std::vector<int32_t>& joints) {
  Add(&follower_, time_ms, joints);
}

void LagMeter::Clear() {
  leader_.clear();
  follower_.clear();
}

// Returns the joint of the leader that has moved most since `from_ms`; -1 if no joint has moved
// enough.
int LagMeter::LiveliestJoint(int64_t from_ms) const {
  int liveliest = -1;
  int64_t range_max = kRangeMin - 1;
  for (size_t j = 0; j < leader_.back().joints.size(); ++j) {
    int32_t low = std::numeric_limits<int32_t>::max(), high = std::numeric_limits<int32_t>::min();
    for (const Sample& sample : leader_) {
      if (sample.time_ms < from_ms || j >= sample.joints.size()) continue;
      low = std::min(low, sample.joints[j]);
      high = std::max(high, sample.joints[j]);
    }
    const int64_t range = int64_t{high} - low;
    if (range <= range_max) continue;
    range_max = range;
    liveliest = static_cast<int>(j);
  }
  return liveliest;
}

// Returns how badly the follower's positions since `from_ms` fit the leader's positions `lag_ms`
// earlier: the variance of the difference of the positions, divided by the variance of the leader's
// positions.  A constant difference counts as a perfect fit.
double LagMeter::RelativeError(int joint, int64_t lag_ms, int64_t from_ms) const {
  const auto j = static_cast<size_t>(joint);
  double n = 0, sum = 0, squares = 0, leader_sum = 0, leader_squares = 0;
  size_t after = 1;
  for (const Sample& sample : follower_) {
    const int64_t time_ms = sample.time_ms - lag_ms;
    if (sample.time_ms < from_ms || time_ms < leader_.front().time_ms) continue;
    while (after < leader_.size() && leader_[after].time_ms < time_ms) ++after;
    if (after >= leader_.size()) break;
    const Sample &a = leader_[after - 1], &b = leader_[after];
    const auto gap_ms = static_cast<double>(std::max<int64_t>(1, b.time_ms - a.time_ms));
    const double share = static_cast<double>(time_ms - a.time_ms) / gap_ms;
    const double leader = a.joints[j] + share * (static_cast<double>(b.joints[j]) - a.joints[j]);
    const double difference = sample.joints[j] - leader;
    n += 1;
    sum += difference;
    squares += difference * difference;
    leader_sum += leader;
    leader_squares += leader * leader;
  }
  const double variance = leader_squares - leader_sum * leader_sum / std::max(n, 1.0);
  if (n < kSamplesMin || variance <= 0) return std::numeric_limits<double>::infinity();
  return (squares - sum * sum / n) / variance;
}

std::optional<int64_t> LagMeter::LagMs() const {
  if (leader_.size() < kSamplesMin || follower_.size() < kSamplesMin) return std::nullopt;
  const int64_t from_ms = follower_.back().time_ms - kWindowMs;
  const int joint = LiveliestJoint(from_ms - kLagMaxMs);
  if (joint < 0) return std::nullopt;
  std::vector<double> misfits;
  for (int64_t lag_ms = 0; lag_ms <= kLagMaxMs; lag_ms += kStepMs)
    misfits.push_back(RelativeError(joint, lag_ms, from_ms));
  const double best = *std::min_element(misfits.begin(), misfits.end());
  if (best > kMisfitMax) return std::nullopt;
  // Finds the smallest lag whose misfit is near the least misfit, and then goes on to the next
  // minimum.  Does not use the lag with the least misfit: a periodic movement fits again one period
  // later, and this larger lag would be wrong.
  size_t at = 0;
  while (misfits[at] > best + kNearBest) ++at;
  while (at + 1 < misfits.size() && misfits[at + 1] < misfits[at]) ++at;
  return static_cast<int64_t>(at) * kStepMs;
}

}  // namespace openr_host

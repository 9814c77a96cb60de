// Compares the motions of joints: two groups of positions (commanded, measured, simulated) from one
// log of a motion, or from two such logs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "openr/motion/log_file.h"

namespace openr_host {

enum class LogGroup { kCommanded, kMeasured, kSimulated };

const char* NameOf(LogGroup group);  // returns the name of a group, such as "commanded"

// The positions of all joints over time.
struct JointTraces {
  std::vector<double> times_ms;          // times of the positions, in rising order
  std::vector<std::vector<double>> deg;  // positions in degrees: [joint][time]
};

// Returns the positions of the group `group` (commanded, measured or simulated) with the times of
// their records.  Leaves out records that do not have this group.  `times_ms` has the time of each
// record of `log` (log_times.h).
JointTraces TracesOf(const LogFile& log, const std::vector<double>& times_ms, LogGroup group);

// The difference of one joint between two motions, A and B.
//
// The lag is the shift of time with which both motions fit best: the position in B at the time t +
// lag is about offset + gain * the position in A at the time t.  So B may also differ from A by an
// offset and a gain.  Positions between records are interpolated by cubic curves, so the lag need
// not be a multiple of the time between key frames.
struct JointDifference {
  double mean_deg = 0;  // mean of B - A, the position in motion B minus the position in motion A
  double max_deg = 0;   // largest |B - A|, the distance of the positions in the motions A and B
  double rms_deg = 0;   // root of the mean square of B - A, the difference of the positions
  // The lag of motion B behind motion A; nullopt when the joint moves by less than kMovesDeg, when
  // fewer than kSamplesMin records are left for the comparison, or when the best shift is the
  // largest that was tried.
  std::optional<double> lag_ms;
  // The factor by which the positions in motion A are multiplied to get those in B, after B was
  // shifted by the lag; nullopt when lag_ms is nullopt.
  std::optional<double> gain;
  // Root of the mean square of the difference between motions B and A, after B was shifted by the
  // lag.
  std::optional<double> rms_after_lag_deg;
};

constexpr double kMovesDeg = 1;
// The largest shift of time, in ms, that is tried to find the lag between two motions; for a short
// motion, 1/4 of its length is the limit.
constexpr double kLagMaxMs = 320;
constexpr int kSamplesMin = 8;

// Compares motion B with motion A, joint by joint, over the time that both cover.  REQUIRES: A and
// B have the same number of joints.  Throws std::runtime_error when A and B cover no common time.
std::vector<JointDifference> CompareTraces(const JointTraces& a, const JointTraces& b);

// Returns `value` as text with this number of decimals.  A value that rounds to 0 has no minus
// sign.
std::string Rounded(double value, int decimals);

}  // namespace openr_host

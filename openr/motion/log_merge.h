// Merges the logs of two robots that have played the same motion into one log (synchronised
// play-back, Hohl 2004, section 3.3.6).
#pragma once

#include "openr/motion/log_file.h"

namespace openr_host {

// Moves the measured values in the log of a motion to the group of simulated values and returns the
// log.  This makes the log of a simulated play-back (Hohl 2004, section 3.3.6).
LogFile AsSimulated(LogFile log);

// Returns the log `real`, with the measured values of `other` as simulated values.  `other` is the
// log of another robot that has played the same motion.
//
// Values are merged by key frame; the times at which the robots reached the key frame do not
// matter.  This compensates the delay between the two robots; Hohl 2004 has to shift the values by
// one key frame instead.  If the motion of `other` has ended earlier, the last records have no
// simulated values.
//
// Throws std::runtime_error if the key frames of the records differ, or if commanded positions
// differ by more than kSameCommandCdeg, because the motions were not the same then.
LogFile MergeLogs(const LogFile& real, const LogFile& other);

// Largest difference at which two commanded positions count as equal.  Equal commands may differ a
// little in two logs of the same motion, because each log rounds to 0.01 degree.
constexpr int kSameCommandCdeg = 2;

}  // namespace openr_host

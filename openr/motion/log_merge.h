// Merges the logs of two robots into the log of a synchronised play-back.
#pragma once

#include "openr/motion/log_file.h"

namespace openr_host {

// Returns the log with its measured values moved to the group of simulated values: the log of a
// simulated play-back (Hohl 2004, section 3.3.6).
LogFile AsSimulated(LogFile log);

// Returns the log `real`, with the measured values of `other` as simulated values.  `other` is the
// log of another robot that has played the same motion.
//
// Values are merged by key frame, whatever the times at which the robots have reached it.  This
// compensates the delay between the two robots; Hohl 2004 has to shift the values by one key frame
// instead.  If the motion of `other` has ended earlier, the last records have no simulated values.
//
// Throws std::runtime_error if the key frames of the records differ, or if commanded positions
// differ by more than kSameCommandCdeg, because the motions were not the same then.
LogFile MergeLogs(const LogFile& real, const LogFile& other);

constexpr int kSameCommandCdeg = 2;  // largest difference of equal commands, which are rounded to
                                     // 0.01 degree in each log

}  // namespace openr_host

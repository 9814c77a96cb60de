// Puts logs of robots together to the log of a synchronised play-back.
#pragma once

#include "openr/motion/log_file.h"

namespace openr_host {

// Returns the log with its measured values in the group of simulated values: the log of a simulated
// play-back (Hohl 2004, section 3.3.6).
LogFile AsSimulated(LogFile log);

// Returns the log of `real` with the measured values of `other`, which has played the same motion,
// as simulated values.
//
// A value belongs to the record of its key frame, whenever the robots have reached it.  So the
// delay between the two robots is compensated without shifting values by one key frame, as the
// report has to.  Records that `other` does not have, because its motion has ended before, have no
// simulated values.
//
// Throws std::runtime_error when the records are of different key frames, or the commanded
// positions differ by more than kSameCommandCdeg: then the motions were not the same.
LogFile MergeLogs(const LogFile& real, const LogFile& other);

constexpr int kSameCommandCdeg = 2;  // positions are rounded to 1

}  // namespace openr_host

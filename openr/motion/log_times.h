// Finds the times of the records in the log of a motion, because the records have numbers of key
// frames but no times.
#pragma once

#include <vector>

#include "MtnFile.h"
#include "openr/motion/log_file.h"

namespace openr_host {

// Both functions below return the time of each record in the log of a motion, in ms after the first
// key frame of the motion.  They throw std::runtime_error with the reason when the times cannot be
// known.

// Returns the time of each record of `log`, the log of a motion, in ms.  Assumes that key frames
// are 16 ms apart, as in a motion without interpolated frames.  A key frame with a smaller number
// than the key frame before belongs to the next repetition of the motion.  Refuses a log in which a
// key frame repeats, because its motion has interpolated frames.
std::vector<double> TimesOf(const LogFile& log);

// Returns the time of each record of `log`, in ms.  Plays `motion`, the motion of the log, to find
// when each record was made.  Tries 2, 4, 6 and 8 key frames per command vector, and uses the
// number that gives the key frames of the log.
std::vector<double> TimesOf(const LogFile& log, const MtnFile& motion);

}  // namespace openr_host

// Finds the times of the records in the log of a motion, because the records have numbers of key
// frames but no times.
#pragma once

#include <vector>

#include "MtnFile.h"
#include "openr/motion/log_file.h"

namespace openr_host {

// Returns the time of each record of `log`, the log of a motion, in ms after the first key frame of
// the motion.  Assumes that key frames are 16 ms apart, as in a motion without interpolated frames.
// A key frame with a smaller number than the key frame before belongs to the next repetition of the
// motion.  Throws std::runtime_error with the reason if the times cannot be known, for instance if
// a key frame comes twice in a row: the motion has interpolated frames, or is so short that each
// repetition makes only one record.
std::vector<double> TimesOf(const LogFile& log);

// Returns the time of each record of `log`, in ms after the first key frame of `motion`, the motion
// of the log.  Plays the motion to find when each record was made.  Tries 2, 4, 6 and 8 key frames
// per command vector, and uses the number that gives the key frames of the log.  Throws
// std::runtime_error if no number gives them.
std::vector<double> TimesOf(const LogFile& log, const MtnFile& motion);

}  // namespace openr_host

// The times of the records of a log.  A log has numbers of key frames and no times.
#pragma once

#include <vector>

#include "MtnFile.h"
#include "openr/motion/log_file.h"

namespace openr_host {

// Return the time of each record, in ms after the first key frame of the motion.  Throw
// std::runtime_error with the reason when the times cannot be known.

// Takes the key frames as 16 ms apart, as they are in a motion without interpolated frames.  A
// smaller key frame than the one before belongs to the next loop of the motion.  Refuses a log in
// which a key frame repeats, because then the motion has interpolated frames.
std::vector<double> TimesOf(const LogFile& log);

// Plays `motion`, which the log must be of, to find when each record was made.  The number of key
// frames per command vector is the one that gives the key frames of the log.
std::vector<double> TimesOf(const LogFile& log, const MtnFile& motion);

}  // namespace openr_host

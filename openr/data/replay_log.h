// Replays a recording and writes files about it: the data of each frame, a timeline.
#pragma once

#include <cstdint>
#include <string>

#include "openr/data/data_log.h"

namespace openr_host {

class Replayer;

// Replays a recording up to `until_us`.  Writes a log of data if `options.file` is not "", and a
// timeline if `timeline` is not "".  Returns "", or the error that happened while a file was
// written.  Throws std::runtime_error when a file cannot be created or another run is writing to
// it.
std::string LogReplay(Replayer* replayer, const DataLogOptions& options,
                      const std::string& timeline, int64_t until_us);

}  // namespace openr_host

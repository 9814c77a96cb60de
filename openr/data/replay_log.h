// Replays a recording and writes files about it: the data of each frame, a timeline.
#pragma once

#include <cstdint>
#include <string>

#include "openr/data/data_log.h"

namespace openr_host {

class Replayer;

// Replays a recording up to `until_us`.  Writes a log of data if `options.file` is not "", and a
// timeline if `timeline` is not "".  Shows the progress on the terminal `descriptor`; -1: shows
// none.  Returns "", or the error that happened while a file was
// written.  Throws std::runtime_error when a file cannot be created or another run is writing to
// it.
std::string LogReplay(Replayer* replayer, const DataLogOptions& options,
                      const std::string& timeline, int64_t until_us, int descriptor);

}  // namespace openr_host

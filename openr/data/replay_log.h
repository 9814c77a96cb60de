// Replays a recording and writes files about it: the quantities of each frame, and a timeline that
// shows when each handler ran.
#pragma once

#include <cstdint>
#include <string>

#include "openr/data/data_log.h"

namespace openr_host {

class Replayer;

// Replays a recording up to `until_us`.  Writes the quantities of each frame to `options.file`, and
// a timeline of the handlers to `timeline`; "": writes no such file.  Shows the progress on the
// terminal `descriptor`; -1: shows none.  Returns "", or the error that happened while a file was
// written.  Throws std::runtime_error when a file cannot be created or another run is writing to
// it.
std::string LogReplay(Replayer* replayer, const DataLogOptions& options,
                      const std::string& timeline, int64_t until_us, int descriptor);

}  // namespace openr_host

// What can be said about a robot path ("/MS/OPEN-R/MW/OBJS/MOVER.BIN") by its looks alone.
#pragma once

#include <vector>

#include "runtime/config/diagnostic.h"
#include "runtime/config/line_file.h"

namespace openr_host {

// True iff `word`, found at `place`, can be the path of a file on the Memory Stick: it begins with
// /MS/ (any case), uses '/', and has no empty, '.' or '..' part; otherwise reports an error that
// calls it `what` ("object path").  A part that is not an 8.3 name is only a warning: the host
// could open it, the robot's FAT file system cannot hold it.
bool CheckStickPath(const Word& word, const FilePosition& place, const char* what,
                    std::vector<Diagnostic>* diagnostics);

}  // namespace openr_host

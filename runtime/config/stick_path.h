// Checks the form of a path of the robot ("/MS/OPEN-R/MW/OBJS/MOVER.BIN") without looking at files.
#pragma once

#include <vector>

#include "runtime/config/diagnostic.h"
#include "runtime/config/line_file.h"

namespace openr_host {

// Returns true if `word`, found at `place`, can be the path of a file on the Memory Stick: it
// begins with /MS/ (in upper or lower case), uses '/', and has no empty, '.' or '..' part.
// Otherwise reports an error that names the path by `what`, such as "object path".  If a part of
// the path is not an 8.3 name, only warns: the host can open such a file, but the robot's FAT file
// system cannot contain it.
bool CheckStickPath(const Word& word, const FilePosition& place, const char* what,
                    std::vector<Diagnostic>* diagnostics);

}  // namespace openr_host

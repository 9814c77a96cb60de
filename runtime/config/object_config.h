// Parses OBJECT.CFG, which lists the objects that the robot loads from its Memory Stick, in the
// order of loading.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

struct ObjectRecord {
  // The path of an image as OBJECT.CFG has it, e.g. /MS/OPEN-R/MW/OBJS/MOVER.BIN.  Paths that
  // differ only in upper and lower case name the same image.
  std::string path;
  std::string section;  // the robot design for which the line is valid; "" for every robot
  FilePosition place;
};

struct ObjectConfig {
  std::vector<ObjectRecord> objects;  // in the order of loading
  std::vector<Diagnostic> diagnostics;
};

// Parses the text of OBJECT.CFG, one path per line, for one robot design ("ERS-210", or
// kEveryDesign).  A bad line is reported and skipped; all other lines are used.  A path that is
// listed twice is loaded once, with a warning; upper and lower case count as equal.  `file` is the
// file's name for messages.
ObjectConfig ParseObjectConfig(const std::string& file, std::string_view text,
                               std::string_view design);

}  // namespace openr_host

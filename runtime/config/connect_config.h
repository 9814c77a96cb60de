// Parses CONNECT.CFG, the file that names for each subject the observers to which the subject
// sends.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"
#include "runtime/config/service_name.h"

namespace openr_host {

struct ConnectRecord {
  ServiceName subject;  // name of the subject, with direction 'S'
  // Name of the observer, with direction 'O' and the data type of the subject.
  ServiceName observer;
  std::string section;         // the robot design for which the line is valid; "" for every robot
  FilePosition subject_place;  // position of the subject's name, for messages
  FilePosition observer_place;
};

struct ConnectConfig {
  std::vector<ConnectRecord> connections;  // in the order of the lines; connected in this order
  std::vector<Diagnostic> diagnostics;
};

// Parses the text of CONNECT.CFG, one "subject observer" per line, for one robot design ("ERS-210",
// or kEveryDesign).  A bad line (a name without four parts, a subject and an observer in the wrong
// order, data types that differ) is reported and skipped.  All other lines are used, as Sony's
// library does (measured.md 1.4).  A pair that is listed twice is connected once, with a warning.
// Does not check whether the services exist; the object manager does that when it makes the
// connections.  `consequence` is the end of each error message: what happens because of the error.
ConnectConfig ParseConnectConfig(const std::string& file, std::string_view text,
                                 std::string_view design,
                                 std::string_view consequence = " (the line is skipped)");

}  // namespace openr_host

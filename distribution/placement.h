// The placement of a run: which object is in which process.  CONNECT.CFG does not contain the
// placement and objects do not know it, so the same stick runs in one process or in several.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// Returns the reason why `name` is no valid name; "" if it is valid.  `what` is "process" or "run".
std::string NameProblem(const std::string& what, const std::string& name);

struct Placement {
  // The name of the process in which an object is.  The key is the object's name.  Objects that are
  // not listed are in openr run itself.
  std::map<std::string, std::string> process_of;
  // The address of the host of a process that a user starts (openr join).  The key is the process's
  // name.
  std::map<std::string, std::string> host_of;
  // The lines of the placement file that name hosts, for messages about wrong hosts.  The key is
  // the process's name.
  std::map<std::string, FilePosition> host_lines;

  bool empty() const { return process_of.empty(); }
  // Returns the names of all processes, sorted, each once.
  std::vector<std::string> Processes() const;
};

// Parses a placement file.  The file has a line per object, and a line per process on another host:
//
//   # object        process
//   RCServer        network
//   BallTracker     vision
//   # process       host
//   @vision         192.168.1.7
//
// Errors are added to `diagnostics`.
Placement ParsePlacement(const std::string& file, std::string_view text,
                         std::vector<Diagnostic>* diagnostics);

// Returns errors about the hosts of the placement.  One error is that the address of a host is not
// found.  The other error is that a host is another machine although `own_address` (--dds-address)
// is a loopback address, which no other machine can reach.  Queries the name service.
std::vector<Diagnostic> WrongHosts(const Placement& placement, const std::string& own_address);

// Adds an object and its process, given on the command line as "RCServer=network".  Returns "" or
// the error in `text`.
std::string AddPlace(const std::string& text, Placement* placement);

}  // namespace openr_host

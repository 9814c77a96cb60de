// Where each object of a run lives.  The wiring does not say it, and objects do not know.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

// "" or why this is no name for a process, or a run.
std::string WhyNoName(const std::string& what, const std::string& name);

struct Placement {
  // Name of an object -> name of a process; who is not named is in the program itself.
  std::map<std::string, std::string> process_of;
  // Processes that somebody starts on another host (openr join), and its address.
  std::map<std::string, std::string> host_of;
  std::map<std::string, Place> host_lines;  // where the file says so

  bool empty() const { return process_of.empty(); }
  // In order of their names, each once.
  std::vector<std::string> Processes() const;
};

// A placement file has a line per object, and one per process of another host:
//
//   # object        process
//   RCServer        network
//   BallTracker     vision
//   # process       host
//   @vision         192.168.1.7
//
// What is wrong is added to `diagnostics`.
Placement ParsePlacement(const std::string& file, std::string_view text,
                         std::vector<Diagnostic>* diagnostics);

// What is wrong with the hosts: they cannot be found, or could not reach a run at this address
// (--dds-address).  Asks the name service.
std::vector<Diagnostic> WrongHosts(const Placement& placement, const std::string& own_address);

// "RCServer=network" of the command line.  "" or what is wrong with it.
std::string AddPlace(const std::string& text, Placement* placement);

}  // namespace openr_host

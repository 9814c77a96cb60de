// The commands of openr serve (docs/python.md), as data: what docs/python.md lists, what the module
// openr_host has methods for, and what RunServer checks requests against.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace openr_host {

struct CommandParameter {
  const char* name;
  const char* type;       // "text", "number", "integer", "flag" or "texts"
  const char* otherwise;  // the value without it, as JSON; null: the parameter is required
  const char* help;
};

struct RunCommand {
  const char* name;
  const char* help;
  std::vector<CommandParameter> parameters;
  const char* answer;      // members of the answer, "time_s: number"; "bytes" are its further bytes
  const char* takes = "";  // what the further bytes of the request are; "": there are none
};

// Returns all commands in the order of the documentation.
const std::vector<RunCommand>& RunCommands();

// Returns the command `name`; null if there is none.
const RunCommand* FindRunCommand(const std::string& name);

// Returns the commands as JSON, for `openr serve --describe`.
nlohmann::ordered_json DescribeRunCommands();

// Returns the error in `request`: an unknown command, a parameter that is missing, unknown or of
// another type.  "": none; then parameters that were left out have their values in `request`.
std::string CompleteRequest(nlohmann::json* request);

}  // namespace openr_host

// The commands of openr serve as data.  RunServer checks requests against them, docs/python.md
// lists them, and the module openr_host has a method for each of them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace openr_host {

struct CommandParameter {
  const char* name;
  const char* type;       // type of the value: "text", "number", "integer", "flag" or "texts"
  const char* otherwise;  // value if a request leaves the parameter out, as JSON; null: the
                          // parameter is required
  const char* help;
};

struct RunCommand {
  const char* name;
  const char* help;
  std::vector<CommandParameter> parameters;
  const char* answer;      // members of the answer, such as "time_s: number"; "bytes" stands for
                           // bytes after the JSON text
  const char* takes = "";  // meaning of the bytes after the JSON text of the request; "": there are
                           // none
};

// Returns all commands in the order of the documentation.
const std::vector<RunCommand>& RunCommands();

// Returns the command `name`; null if there is none.
const RunCommand* FindRunCommand(const std::string& name);

// Returns the commands as JSON, for `openr serve --describe`.
nlohmann::ordered_json DescribeRunCommands();

// Returns the error in `request`: an unknown command, or a parameter that is missing, unknown or of
// another type.  If there is no error, adds the parameters that were left out to `request`, with
// their values, and returns "".
std::string CompleteRequest(nlohmann::json* request);

}  // namespace openr_host

// The table of the commands of openr serve.  RunServer checks requests against this table,
// docs/python.md lists the commands, and the module openr_host has a method for each command.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace openr_host {

struct CommandParameter {
  const char* name;
  const char* type;  // type of the parameter: "text", "number", "integer", "flag" or "texts"
  // Value of the parameter, as JSON, if a request leaves the parameter out; null: the parameter is
  // required.
  const char* otherwise;
  const char* help;
};

struct RunCommand {
  const char* name;
  const char* help;
  std::vector<CommandParameter> parameters;
  // Members of the command's answer, such as "time_s: number"; "bytes" stands for bytes after the
  // JSON text.
  const char* answer;
  // Meaning of the bytes that follow the JSON text of a request with this command; "": no bytes
  // follow.
  const char* takes = "";
};

// Returns all commands of openr serve, in the order in which docs/python.md lists them.
const std::vector<RunCommand>& RunCommands();

// Returns the command with the name `name`; null if no command has this name.
const RunCommand* FindRunCommand(const std::string& name);

// Returns a description of all commands as JSON, for `openr serve --describe`.
nlohmann::ordered_json DescribeRunCommands();

// Returns the error in `request`: an unknown command, or a parameter that is missing, unknown or of
// a wrong type.  If there is no error, returns "" and completes `request`: parameters that were
// left out are added with their default values.
std::string CompleteRequest(nlohmann::json* request);

}  // namespace openr_host

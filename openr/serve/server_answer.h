// RunServer::Answer and RunServer::Request, for the sources of RunServer only.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "openr/serve/run_server.h"

namespace openr_host {

// The answer to a command: members of a JSON object, and the bytes after the JSON text.
struct RunServer::Answer {
  nlohmann::ordered_json json;
  std::string bytes;
};

// A request: all its parameters, including the parameters that the program which drives the run has
// left out, and the bytes after its JSON text.
struct RunServer::Request {
  const Json& json;
  const std::string& bytes;
};

}  // namespace openr_host

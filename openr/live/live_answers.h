// Answers the requests that a run gets through its socket (live_server.h).
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace openr_host {

struct LiveContext;

// Returns the answer to `request`, an object that has the name of the request in "do".  The answer
// to a wrong request is an object with the error text in "error". docs/inputs.md, "The socket of a
// run", lists the requests.  Only the request "input" changes what happens in the run; the request
// "clock" changes only how fast the run goes on and when it pauses.  Throws
// std::runtime_error if a member of the request has a wrong type.  REQUIRES: not called in a
// handler.
nlohmann::ordered_json AnswerLive(const LiveContext& context, const nlohmann::json& request);

}  // namespace openr_host

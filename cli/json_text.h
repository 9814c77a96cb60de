// Converts JSON to text.  The strings in it come from objects, sticks and people, so they may not
// be UTF-8.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace openr_host {

// Returns the text of `json`.  Bytes that are not UTF-8 become U+FFFD.  With `indent` -1 the text
// is one line.
template <typename Json>
std::string JsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace openr_host

// JSON as text.  What objects, sticks and people say goes into it, and that need not be UTF-8.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace openr_host {

// Bytes that are no UTF-8 become U+FFFD.  `indent` -1: on one line.
template <typename Json>
std::string JsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace openr_host

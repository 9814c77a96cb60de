// Converts JSON to text and back.  The strings in it come from objects, sticks and people, so they
// may not be UTF-8.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace openr_host {

// Returns the text of `json`.  Bytes that are not UTF-8 become U+FFFD.  With `indent` -1 the text
// is one line.
template <typename Json>
std::string JsonText(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

// Which numbers with a fraction or an exponent ParseJson() accepts.
enum class Fractions {
  kNone,
  kBounded,  // those between -2^31 and 2^31, which fit into each signed integer
};

// Returns the JSON of a file or a message that another program may have written.  C++ gives no
// meaning to the conversion of a number like 1e30 to an integer, and the JSON library converts
// without a check.  So such a number is refused here, before anybody asks for an integer.
//
// Throws Json::parse_error if `text` is no JSON, and std::runtime_error for a refused number.
template <typename Json>
Json ParseJson(std::string_view text, Fractions fractions) {
  return Json::parse(text, [fractions](int, typename Json::parse_event_t event, Json& value) {
    if (event != Json::parse_event_t::value || !value.is_number_float()) return true;
    if (fractions == Fractions::kNone)
      throw std::runtime_error(fmt::format("the number {} is no whole number", value.dump()));
    if (std::abs(value.template get<double>()) >= 0x1p31)
      throw std::runtime_error(fmt::format("the number {} is too large", value.dump()));
    return true;
  });
}

}  // namespace openr_host

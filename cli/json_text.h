// Converts JSON to text and back, for both types of the JSON library: nlohmann::json and
// nlohmann::ordered_json.  The parser and the writer of the library are large, so they are compiled
// only in json_text.cc.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

namespace openr_host {

// Returns the text of `json`.  The strings in `json` come from objects, sticks and people, so they
// can contain bytes that are not valid UTF-8.  Such bytes become U+FFFD.  With `indent` -1 the text
// is one line.
template <typename Json>
std::string JsonText(const Json& json, int indent = -1);

// Thrown for JSON that is nested too deeply (IsJsonTooDeep()).
class JsonTooDeep : public std::runtime_error {
 public:
  JsonTooDeep();
};

// Returns the JSON in `text`.  Throws Json::parse_error if `text` is no JSON, and JsonTooDeep if
// the JSON is nested too deeply.
template <typename Json>
Json ParseJson(std::string_view text);

// Tells CheckFractions() which numbers to accept of those that have a fraction or an exponent.
enum class Fractions {
  kBounded,  // numbers between -2^31 and 2^31, which fit into an int
  kNone,
};

// Checks all numbers in `json` that have a fraction or an exponent.  Throws std::runtime_error if
// there is such a number with Fractions::kNone, or one that does not fit into an int with
// Fractions::kBounded.  Numbers without fraction and exponent are not checked.
//
// C++ gives no meaning to the conversion of a number like 1e30 to an integer, and the JSON library
// converts without a check.  So code that reads the JSON of a file or of another program must call
// this function before it asks the JSON for an integer.
template <typename Json>
void CheckFractions(const Json& json, Fractions fractions);

// Returns the JSON in `text`.  If `text` is no JSON, or if the JSON is nested too deeply, returns a
// value of which is_discarded() is true.
template <typename Json>
Json TryParseJson(std::string_view text);

// Returns the JSON in `text` without its lists.  A member whose value was a list is missing in the
// result, or has a value that is_discarded().  Returns a value that is no JSON object if `text` is
// no JSON.  The result may be nested as deeply as the JSON objects in `text` are, so the caller
// must not copy or write it, which would overflow the stack.
nlohmann::json ParseWithoutLists(std::string_view text);

// Returns the member `name` of the JSON object in `text`, however deeply other members are nested.
// Returns null if there is no such member, if the member is a list or an object, or if `text` is no
// JSON object.  Used to answer JSON that is refused because it is nested too deeply.
nlohmann::json PlainMember(std::string_view text, const char* name);

}  // namespace openr_host

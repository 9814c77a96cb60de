#include "cli/json_text.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "runtime/base/json_depth.h"

namespace openr_host {
namespace {

// Returns `text`, which is JSON, with escape sequences in place of the characters U+007F to U+009F.
// JSON allows these characters in strings, but terminals obey them.  JSON has escape sequences in
// place of all other control characters already.
std::string WithEscapes(std::string text) {
  constexpr char kDelete = 0x7f, kFirstByte = static_cast<char>(0xc2);
  const bool may_have_one =
      text.find(kDelete) != std::string::npos || text.find(kFirstByte) != std::string::npos;
  if (!may_have_one) return text;
  std::string escaped;
  for (size_t i = 0; i < text.size(); ++i) {
    const auto next = static_cast<unsigned char>(i + 1 < text.size() ? text[i + 1] : 0);
    if (text[i] == kDelete) {
      escaped += "\\u007f";
    } else if (text[i] == kFirstByte && next >= 0x80 && next <= 0x9f) {
      escaped += fmt::format("\\u{:04x}", next);
      ++i;
    } else {
      escaped += text[i];
    }
  }
  return escaped;
}

// `number` has a fraction or an exponent.  Throws std::runtime_error if `fractions` does not accept
// such a number.
template <typename Json>
void CheckFraction(const Json& number, Fractions fractions) {
  if (fractions == Fractions::kNone)
    throw std::runtime_error(fmt::format("the number {} is no whole number", number.dump()));
  if (std::abs(number.template get<double>()) >= 0x1p31)
    throw std::runtime_error(fmt::format("the number {} is too large", number.dump()));
}

}  // namespace

JsonTooDeep::JsonTooDeep()
    : std::runtime_error(
          fmt::format("the JSON is nested more than {} levels deep", kJsonDepthMax)) {}

template <typename Json>
std::string JsonText(const Json& json, int indent) {
  return WithEscapes(json.dump(indent, ' ', false, Json::error_handler_t::replace));
}

template <typename Json>
Json ParseJson(std::string_view text) {
  if (IsJsonTooDeep(text)) throw JsonTooDeep();
  return Json::parse(text);
}

template <typename Json>
void CheckFractions(const Json& json, Fractions fractions) {
  // Keeps the values that are not checked yet in a list, and uses no recursion, because JSON of
  // another program may be nested so deeply that recursion would overflow the stack.
  std::vector<const Json*> unchecked{&json};
  while (!unchecked.empty()) {
    const Json* const next = unchecked.back();
    unchecked.pop_back();
    if (next->is_number_float()) CheckFraction(*next, fractions);
    if (!next->is_structured()) continue;
    for (const Json& part : *next) unchecked.push_back(&part);
  }
}

template <typename Json>
Json TryParseJson(std::string_view text) {
  if (IsJsonTooDeep(text)) return Json(Json::value_t::discarded);
  return Json::parse(text, nullptr, false);
}

nlohmann::json ParseWithoutLists(std::string_view text) {
  using Event = nlohmann::json::parse_event_t;
  const auto keeps = [](int, Event event, const nlohmann::json&) {
    return event != Event::array_start;
  };
  return nlohmann::json::parse(text, keeps, false);
}

nlohmann::json PlainMember(std::string_view text, const char* name) {
  using Event = nlohmann::json::parse_event_t;
  // Lets the parser drop every list and object except the outermost, so that the result is not
  // nested.
  const auto keeps = [](int depth, Event event, const nlohmann::json&) {
    return depth == 0 || (event != Event::object_start && event != Event::array_start);
  };
  const auto json = nlohmann::json::parse(text, keeps, false);
  if (!json.is_object()) return nullptr;
  const auto member = json.find(name);
  // Returns the member only if its value is_primitive().  `json` may still have a member whose list
  // or object the parser has dropped; the value of such a member is_discarded(), and must not be
  // returned.
  return member != json.end() && member->is_primitive() ? *member : nlohmann::json();
}

template std::string JsonText(const nlohmann::json&, int);
template std::string JsonText(const nlohmann::ordered_json&, int);
template nlohmann::json ParseJson(std::string_view);
template nlohmann::ordered_json ParseJson(std::string_view);
template void CheckFractions(const nlohmann::json&, Fractions);
template void CheckFractions(const nlohmann::ordered_json&, Fractions);
template nlohmann::json TryParseJson(std::string_view);
template nlohmann::ordered_json TryParseJson(std::string_view);

}  // namespace openr_host

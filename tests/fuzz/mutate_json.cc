#include "tests/fuzz/mutate_json.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDepthMax = 50;  // deeper JSON is left to the other mutators, because its functions
                               // call themselves

bool IsFlat(std::string_view text) {
  int depth = 0;
  for (const char c : text) {
    if (c == '{' || c == '[') depth += 1;
    if (c == '}' || c == ']') depth -= 1;
    if (depth > kDepthMax) return false;
  }
  return true;
}

size_t AnyBelow(size_t limit, FuzzRandom* random) { return (*random)() % limit; }

void Collect(Json* json, std::vector<Json*>* values) {
  values->push_back(json);
  if (!json->is_structured()) return;
  for (Json& value : *json) Collect(&value, values);
}

// Returns a word of the dictionary, or a text of the JSON.
std::string AnyWord(const std::vector<Json*>& values, const FuzzWords& words, FuzzRandom* random) {
  if (!words.empty() && AnyBelow(4, random) != 0) return words[AnyBelow(words.size(), random)];
  const Json& value = *values[AnyBelow(values.size(), random)];
  return value.is_string() ? value.get<std::string>() : "";
}

Json OtherNumber(const Json& number, FuzzRandom* random) {
  constexpr int64_t kLimits[] = {0,   1,     -1,    127,        128,        255,
                                 256, 32767, 65535, 2147483647, 2147483648, INT64_MAX};
  const size_t kind = AnyBelow(5, random);
  if (kind == 0) return static_cast<int64_t>(AnyBelow(200, random));
  if (kind == 1) return kLimits[AnyBelow(std::size(kLimits), random)];
  if (kind == 2) return number.get<double>() / 2;
  const auto factor = static_cast<int>(2 + AnyBelow(9, random));
  const int more = static_cast<int>(AnyBelow(5, random)) - 2;
  constexpr int64_t kSmall = int64_t{1} << 40;  // no multiple overflows
  if (!number.is_number_integer() || number > kSmall || number < -kSmall) {
    return kind == 3 ? number.get<double>() * factor : number.get<double>() + more;
  }
  return kind == 3 ? number.get<int64_t>() * factor : number.get<int64_t>() + more;
}

// Changes the elements of an object or an array.
void ChangeElements(Json* json, const std::vector<Json*>& values, const FuzzWords& words,
                    FuzzRandom* random) {
  Json other = *values[AnyBelow(values.size(), random)];  // a copy, because it may contain `json`
  const size_t kind = AnyBelow(4, random);
  const size_t chosen = json->empty() ? 0 : AnyBelow(json->size(), random);
  if (json->is_array()) {
    const auto at = json->begin() + static_cast<std::ptrdiff_t>(chosen);
    if (kind == 0 || json->empty()) {
      json->insert(at, std::move(other));
    } else if (kind == 1) {
      json->erase(at);
    } else if (kind == 2) {
      json->insert(at, Json(*at));
    } else {
      std::swap(*at, json->back());
    }
    return;
  }
  if (kind == 0 || json->empty()) {
    (*json)[AnyWord(values, words, random)] = std::move(other);
    return;
  }
  auto at = json->begin();
  std::advance(at, chosen);
  const std::string key = at.key();
  if (kind == 3) other = at.value();
  const std::string word = AnyWord(values, words, random);  // before `values` are erased
  json->erase(key);
  if (kind != 1) (*json)[word] = std::move(other);
}

}  // namespace

bool IsJson(std::string_view text) { return IsFlat(text) && Json::accept(text); }

std::string MutateJson(std::string_view text, const FuzzWords& words, FuzzRandom* random) {
  if (!IsFlat(text)) return "";
  Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return "";
  std::vector<Json*> values;
  Collect(&json, &values);
  Json& chosen = *values[AnyBelow(values.size(), random)];
  const size_t kind = AnyBelow(8, random);
  if (kind == 0) {
    Json other = *values[AnyBelow(values.size(), random)];
    chosen = std::move(other);
  } else if (chosen.is_structured()) {
    ChangeElements(&chosen, values, words, random);
  } else if (chosen.is_string()) {
    chosen = AnyWord(values, words, random);
  } else if (chosen.is_number()) {
    chosen = OtherNumber(chosen, random);
  } else {
    chosen = kind % 2 == 0;  // null, or a flag
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace openr_host

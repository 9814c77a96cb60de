#include "virtualrobot/base/json_reader.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "runtime/base/json_depth.h"

namespace openr_host {

nlohmann::json JsonReader::ParseText(const std::string& text, const std::string& file) {
  if (IsJsonTooDeep(text)) {
    throw std::runtime_error(
        fmt::format("{}: is nested more than {} levels deep", file, kJsonDepthMax));
  }
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& e) {
    size_t line = 1, column = 1;
    for (size_t i = 0; i + 1 < e.byte && i < text.size(); ++i) {
      column += 1;
      if (text[i] == '\n') line += 1, column = 1;
    }
    throw std::runtime_error(fmt::format("{}:{}:{}: not valid JSON here", file, line, column));
  } catch (const nlohmann::json::out_of_range& e) {
    // The text of the JSON file has a number that is too large.  The error message has no line,
    // because e.what() names this number but not its line.
    throw std::runtime_error(fmt::format("{}: {}", file, e.what()));
  }
}

bool JsonReader::Has(const char* key) const { return value_.is_object() && value_.contains(key); }

JsonReader JsonReader::At(const char* key) const {
  if (!value_.is_object()) Fail("must be an object with '{}'", key);
  const auto it = value_.find(key);
  if (it == value_.end()) Fail("'{}' is missing", key);
  return JsonReader(*it, place_ + separator_ + key, ".");
}

std::vector<JsonReader> JsonReader::Elements() const {
  if (!value_.is_array()) Fail("must be a list, is {}", value_.dump());
  std::vector<JsonReader> elements;
  for (size_t i = 0; i < value_.size(); ++i) {
    elements.push_back(JsonReader(value_[i], fmt::format("{}[{}]", place_, i), "."));
  }
  return elements;
}

void JsonReader::AllowOnly(std::initializer_list<const char*> keys) const {
  if (!value_.is_object()) Fail("must be an object, is {}", value_.dump());
  for (const auto& [name, unused] : value_.items()) {
    if (std::find(keys.begin(), keys.end(), name) == keys.end())
      Fail("'{}' is unknown; known here: {}", name, fmt::join(keys.begin(), keys.end(), ", "));
  }
}

std::string JsonReader::Text() const {
  if (!value_.is_string()) Fail("must be a text, is {}", value_.dump());
  return value_.get<std::string>();
}

bool JsonReader::Bool() const {
  if (!value_.is_boolean()) Fail("must be true or false, is {}", value_.dump());
  return value_.get<bool>();
}

double JsonReader::Number() const {
  if (!value_.is_number()) Fail("must be a number, is {}", value_.dump());
  const double number = value_.get<double>();
  if (!std::isfinite(number)) Fail("must be a finite number");
  return number;
}

double JsonReader::NumberAbove(double floor) const {
  const double number = Number();
  if (!(number > floor)) Fail("is {}, must be > {}", number, floor);
  return number;
}

double JsonReader::NumberWithin(double min, double max) const {
  const double number = Number();
  if (!(number >= min && number <= max)) Fail("is {}, must be {} to {}", number, min, max);
  return number;
}

int64_t JsonReader::Whole(int64_t min, int64_t max) const {
  if (!value_.is_number_integer()) Fail("must be a whole number, is {}", value_.dump());
  // Refuses a number above INT64_MAX before the conversion to int64_t, which would make it
  // negative.
  if (value_.is_number_unsigned() && value_.get<uint64_t>() > INT64_MAX)
    Fail("is {}, must be {} to {}", value_.get<uint64_t>(), min, max);
  const int64_t number = value_.get<int64_t>();
  if (number < min || number > max) Fail("is {}, must be {} to {}", number, min, max);
  return number;
}

std::string JsonReader::TextOr(const char* key, const std::string& otherwise) const {
  return Has(key) ? At(key).Text() : otherwise;
}

bool JsonReader::BoolOr(const char* key, bool otherwise) const {
  return Has(key) ? At(key).Bool() : otherwise;
}

int64_t JsonReader::WholeOr(const char* key, int64_t min, int64_t max, int64_t otherwise) const {
  return Has(key) ? At(key).Whole(min, max) : otherwise;
}

Eigen::Vector3d JsonReader::Vector() const {
  const std::vector<double> v = Numbers(3);
  return {v[0], v[1], v[2]};
}

std::vector<double> JsonReader::Numbers(size_t count) const {
  std::vector<double> numbers;
  for (const JsonReader& element : Elements()) numbers.push_back(element.Number());
  if (numbers.size() != count) Fail("must have {} numbers, has {}", count, numbers.size());
  return numbers;
}

}  // namespace openr_host

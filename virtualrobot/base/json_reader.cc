#include "virtualrobot/base/json_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "runtime/base/characters.h"
#include "runtime/base/json_depth.h"

namespace openr_host {
namespace {

// Returns the place of the byte `index` of `text`, the content of `file`, as "FILE:LINE:COLUMN".
std::string PlaceIn(const std::string& text, size_t index, const std::string& file) {
  size_t line = 1, column = 1;
  for (size_t i = 0; i < index && i < text.size(); ++i) {
    column += 1;
    if (text[i] == '\n') line += 1, column = 1;
  }
  return fmt::format("{}:{}:{}", file, line, column);
}

// Returns the first number in the JSON `text` that is too large for a double, because the JSON
// library names this number without its place.  Returns an empty view if there is none.
std::string_view FirstTooLarge(const std::string& text) {
  bool is_string = false;
  for (size_t i = 0; i < text.size(); ++i) {
    if (is_string && text[i] == '\\') {
      ++i;  // skips the character after \, which may be a quotation mark
    } else if (text[i] == '"') {
      is_string = !is_string;
    } else if (!is_string && (IsDigit(text[i]) || text[i] == '-')) {
      const size_t end = std::min(text.find_first_not_of("+-.0123456789eE", i), text.size());
      const std::string number = text.substr(i, end - i);
      if (!std::isfinite(std::strtod(number.c_str(), nullptr)))
        return std::string_view(text).substr(i, number.size());
      i = end - 1;
    }
  }
  return "";
}

}  // namespace

nlohmann::json JsonReader::ParseText(const std::string& text, const std::string& file) {
  if (IsJsonTooDeep(text)) {
    throw std::runtime_error(
        fmt::format("{}: is nested more than {} levels deep", file, kJsonDepthMax));
  }
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& e) {
    const size_t index = e.byte == 0 ? 0 : e.byte - 1;
    throw std::runtime_error(PlaceIn(text, index, file) + ": not valid JSON here");
  } catch (const nlohmann::json::out_of_range&) {
    const std::string_view number = FirstTooLarge(text);
    if (number.empty()) throw std::runtime_error(file + ": a number is too large");
    throw std::runtime_error(
        fmt::format("{}: the number {} is too large",
                    PlaceIn(text, static_cast<size_t>(number.data() - text.data()), file), number));
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

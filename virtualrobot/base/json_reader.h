// A JSON value together with its place in the file.  Every error names the place, for example
// "model.json: joints.rows[3].hard: ...".  The readers of models, worlds and requests use this
// class.
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace openr_host {

class JsonReader {
 public:
  // Parses `text`.  Throws std::runtime_error when `text` is not JSON or has a number that is too
  // large for a double; the message names `file`, line and column.
  static nlohmann::json ParseText(const std::string& text, const std::string& file);

  // Makes a reader of `value`, the root value of `file`.  `value` must outlive the reader.
  JsonReader(const nlohmann::json& value, std::string file)
      : JsonReader(value, std::move(file), ": ") {}

  // Throws std::runtime_error with the text "PLACE: message".  PLACE is the place of the value in
  // the file, such as "model.json: joints.rows[3].hard".
  template <typename... Args>
  [[noreturn]] void Fail(fmt::format_string<Args...> format, Args&&... args) const {
    throw std::runtime_error(place_ + ": " + fmt::format(format, std::forward<Args>(args)...));
  }

  // Returns whether the value is a JSON object with the member `key`.
  bool Has(const char* key) const;

  // Returns the member `key` of a JSON object.  Throws (Fail()) when the value is no object or the
  // member is missing.
  JsonReader At(const char* key) const;

  // Returns the elements of a JSON array.  This function and the functions below throw (Fail())
  // when the value is not of the kind that the function reads, for example not an array.
  std::vector<JsonReader> Elements() const;

  // Throws (Fail()) when the JSON object has a member that is not in `keys`, because a misspelt
  // name must not be ignored.
  void AllowOnly(std::initializer_list<const char*> keys) const;

  std::string Text() const;
  bool Bool() const;      // reads a value that is true or false
  double Number() const;  // reads a number; fails if it is not finite
  double NumberAbove(double floor) const;
  double NumberWithin(double min, double max) const;
  int64_t Whole(int64_t min, int64_t max) const;

  // Return the member `key` of a JSON object, or `otherwise` if it is missing.
  std::string TextOr(const char* key, const std::string& otherwise) const;
  bool BoolOr(const char* key, bool otherwise) const;
  int64_t WholeOr(const char* key, int64_t min, int64_t max, int64_t otherwise) const;

  Eigen::Vector3d Vector() const;  // reads a vector from the array [x, y, z]
  std::vector<double> Numbers(size_t count) const;

 private:
  JsonReader(const nlohmann::json& value, std::string place, const char* separator)
      : value_(value), place_(std::move(place)), separator_(separator) {}

  const nlohmann::json& value_;
  std::string place_;
  const char* separator_;  // text between place_ and the name of a member in an error message
};

}  // namespace openr_host

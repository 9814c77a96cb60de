// A JSON value together with its place in the file.  Every error names the place:
// "model.json: joints.rows[3].hard: ...".  Used by the readers of models and worlds.
#pragma once

#include <fmt/format.h>

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace openr_host {

class JsonReader {
 public:
  // Parses `text`; `file` stands for it in messages.  Throws std::runtime_error with line
  // and column when it is not JSON.
  static nlohmann::json ParseText(const std::string& text, const std::string& file);

  // For the root value of `file`.  `value` must outlive the reader.
  JsonReader(const nlohmann::json& value, std::string file)
      : JsonReader(value, std::move(file), ": ") {}

  // Throws std::runtime_error "place: message".
  template <typename... Args>
  [[noreturn]] void Fail(fmt::format_string<Args...> format, Args&&... args) const {
    throw std::runtime_error(place_ + ": " + fmt::format(format, std::forward<Args>(args)...));
  }

  bool Has(const char* key) const { return value_.is_object() && value_.contains(key); }

  // The member `key`.  Fails when the member is missing.
  JsonReader At(const char* key) const;

  // The elements of an array.  All functions from here on fail when the value is of another kind.
  std::vector<JsonReader> Elements() const;

  // Fails when there is a member that is not in `keys`, because a misspelt name must not be
  // ignored.
  void AllowOnly(std::initializer_list<const char*> keys) const;

  std::string Text() const;
  double Number() const;  // finite
  double NumberAbove(double floor) const;
  int64_t Whole(int64_t min, int64_t max) const;
  Eigen::Vector3d Vector() const;  // [x, y, z]
  std::vector<double> Numbers(size_t count) const;

 private:
  JsonReader(const nlohmann::json& value, std::string place, const char* separator)
      : value_(value), place_(std::move(place)), separator_(separator) {}

  const nlohmann::json& value_;
  std::string place_;
  const char* separator_;  // text between place_ and the name of a member
};

}  // namespace openr_host

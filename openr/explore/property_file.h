// Reads properties from a text file with one property per line:
//
//   # NAME: WHEN QUANTITY OP VALUE
//   stands: eventually within 20s robots[0].standing == true
//   calm:   always from 15s robots[0].pitch_deg < 10
//   done:   finally objects.Planner.state == finished with all
//
// `always` means at every frame; `eventually` at one frame at least, with `within D` up to that
// time; `finally` at the end of the run.  `from D` ignores frames before that time.  OP is == != <
// <= > >=; texts have only == and !=.  Quantities are those of quantity.h.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "openr/explore/property.h"
#include "runtime/config/diagnostic.h"

namespace openr_host {

struct PropertyRule {
  enum class When { kAlways, kEventually, kFinally };
  std::string name;
  When when = When::kAlways;
  int64_t from_us = 0;
  int64_t within_us = -1;  // -1: no limit
  std::string quantity;
  std::string op;
  std::string value;   // the rest of the line, after OP
  FilePosition place;  // place of the quantity
};

// Reads the rules in `text`.  A wrong line is reported in `diagnostics` and skipped.
std::vector<PropertyRule> ParseProperties(const std::string& file, std::string_view text,
                                          std::vector<Diagnostic>* diagnostics);

// `actual` is a number when the quantity is one; then `expected` must be a number too.  Throws
// std::runtime_error when the two cannot be compared like this.
bool Compares(const std::variant<double, std::string>& actual, const std::string& op,
              const std::string& expected);

// The next two functions throw std::runtime_error with the texts of all errors.
std::vector<std::unique_ptr<Property>> MakeProperties(const std::string& file,
                                                      std::string_view text);
std::vector<std::unique_ptr<Property>> LoadPropertyFile(const std::string& path);

}  // namespace openr_host

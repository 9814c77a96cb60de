// Reads properties from a text file with one property per line:
//
//   # NAME: WHEN QUANTITY OP VALUE
//   stands: eventually within 20s robots[0].standing == true
//   calm:   always from 15s robots[0].pitch_deg < 10
//   done:   finally objects.Planner.state == finished with all
//
// WHEN says at which frames (steps of 8 ms) the comparison must be true: `always` at every frame,
// `eventually` at one frame at least (up to time D, if `within D` is given), `finally` at the end
// of the run.  `from D` leaves out the frames before time D.  QUANTITY names a value of the run
// (quantity.h).  OP is == != < <= > >=; for texts only == and !=.  VALUE is the
// rest of the line, so a text may have blanks.
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
  int64_t within_us = -1;  // the time D of `within D`, in us; -1: no limit
  std::string quantity;
  std::string op;
  std::string value;  // the text with which the quantity is compared: the rest of the line after OP
  FilePosition place;  // place of the quantity's name in the file, for error messages
};

// Reads `text`, the content of the property file `file`.  Returns one PropertyRule for each
// property.  Skips a line with an error, and reports the error in `diagnostics`.
std::vector<PropertyRule> ParseProperties(const std::string& file, std::string_view text,
                                          std::vector<Diagnostic>* diagnostics);

// Returns whether the comparison "`actual` `op` `expected`" is true.  `actual` is the value of a
// quantity, and `op` an operator such as "<=".  If `actual` is a number, `expected` is read as a
// number.  Throws std::runtime_error when `expected` is then not a number, or when `op` cannot
// compare texts.
bool Compares(const std::variant<double, std::string>& actual, const std::string& op,
              const std::string& expected);

// MakeProperties() returns the properties that `text` describes, and LoadPropertyFile() returns the
// properties that the file `path` describes.  Both throw std::runtime_error with the texts of all
// errors.  `file` is the name of `text` in these errors.
std::vector<std::unique_ptr<Property>> MakeProperties(const std::string& file,
                                                      std::string_view text);
std::vector<std::unique_ptr<Property>> LoadPropertyFile(const std::string& path);

}  // namespace openr_host

// Findings: errors, warnings and notes about programs and files, for the report of a run.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

const char* SeverityName(Severity severity);  // "note", "warning", "error"

struct Finding {
  Severity severity = Severity::kWarning;
  int robot = 0;
  std::string object;    // empty: not about one object
  uint64_t message = 0;  // number of the message that was handled when it was first added
  int64_t time_us = 0;   // virtual time when it was first added
  std::string text;
  uint64_t count = 1;  // how often it was added
  // Findings with the same cause are kept as one, for example all lines of CONNECT.CFG that name
  // one missing object.  Empty: findings with the same text are kept as one.
  std::string cause = {};
  std::string place = {};                 // "CONNECT.CFG:4"; set only if there is a cause
  std::vector<std::string> also_at = {};  // places of later findings of this cause; <= kPlacesMax
};

// Returns " (40 times, also at CONNECT.CFG:5, CONNECT.CFG:6 and 37 more)", or "" for a finding that
// was added once.
std::string HowOften(const Finding& finding);

// Findings in order of first appearance.  The same text, or the same cause, about the same object
// is kept once and counted.
class Findings {
 public:
  // The number of different findings that are kept; further ones are only counted.
  static constexpr size_t kMax = 1000;
  static constexpr size_t kPlacesMax = 5;

  void Add(Finding finding);
  const std::vector<Finding>& all() const { return all_; }
  bool HasError() const;
  uint64_t not_kept() const { return not_kept_; }

 private:
  std::vector<Finding> all_;
  uint64_t not_kept_ = 0;
};

}  // namespace openr_host

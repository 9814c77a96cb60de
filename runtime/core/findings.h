// Findings: errors, warnings and notes about programs and files, for the report of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

const char* SeverityName(Severity severity);  // returns "note", "warning" or "error"

struct Finding {
  Severity severity = Severity::kWarning;
  int robot = 0;
  std::string object;  // the object's name; "" if the finding is not about one object
  // The number of the message that was being handled when the finding was first added.
  uint64_t message = 0;
  int64_t time_us = 0;  // virtual time when the finding was first added
  std::string text;
  uint64_t count = 1;  // number of times that the finding was added
  // Names the cause of the finding, such as a missing object.  Findings with the same cause are
  // kept as one finding: for example, the findings about all lines of CONNECT.CFG that name the
  // missing object.  If `cause` is empty, only findings with the same text are kept as one finding.
  std::string cause = {};
  std::string place = {};  // where the cause is ("CONNECT.CFG:4"); empty if `cause` is empty
  // The places (such as "CONNECT.CFG:5") of later findings with this cause, at most kPlacesMax.
  std::vector<std::string> also_at = {};
  // The content of the message that was being handled when the finding was first added, in words;
  // "" if the content is not known.
  std::string said = {};
};

// Returns " (40 times, also at CONNECT.CFG:5, CONNECT.CFG:6 and 37 more)" for the end of a
// finding's text, or "" if `finding` was added only once.
std::string RepetitionText(const Finding& finding);

// A list of findings in the order in which they were first added.  Findings about one object are
// kept as one finding, with a count, if they have the same text or the same cause.
class Findings {
 public:
  // The largest number of different findings that are kept; further findings are only counted.  The
  // limit is our choice: without a limit Add(), which compares a new finding with every kept one,
  // could take very long.
  static constexpr size_t kMax = 1000;
  // The largest number of places that one finding lists in `also_at`.
  static constexpr size_t kPlacesMax = 5;

  // Adds a finding.  If the finding is kept as a new element of all(), returns a pointer to this
  // element.  If the finding was only counted, returns null.
  Finding* Add(Finding finding);
  const std::vector<Finding>& all() const { return all_; }
  // Returns whether there is an error among the findings from index `first` of all() on.  If
  // `robot` has a value, looks only at findings about the robot with this number.
  bool HasError(size_t first = 0, std::optional<int> robot = {}) const;
  uint64_t not_kept() const { return not_kept_; }

 private:
  std::vector<Finding> all_;
  uint64_t not_kept_ = 0;
};

}  // namespace openr_host

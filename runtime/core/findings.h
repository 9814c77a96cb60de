// What the runtime noticed: things that went wrong, or would on the robot.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

const char* SeverityName(Severity severity);  // "warning", "error"

struct Finding {
  Severity severity = Severity::kWarning;
  int robot = 0;
  std::string object;    // empty: not about one object
  uint64_t message = 0;  // number of the message being handled when it was first seen
  int64_t time_us = 0;   // virtual
  std::string text;
  uint64_t count = 1;  // how often the same was seen
};

// Findings in order of first appearance.  The same text about the same object
// is kept once and counted.
class Findings {
 public:
  // Different findings kept; later ones are only counted.
  static constexpr size_t kMax = 1000;

  void Add(Finding finding);
  const std::vector<Finding>& all() const { return all_; }
  bool HasError() const;
  uint64_t not_kept() const { return not_kept_; }

 private:
  std::vector<Finding> all_;
  uint64_t not_kept_ = 0;
};

}  // namespace openr_host

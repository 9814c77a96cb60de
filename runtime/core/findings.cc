#include "runtime/core/findings.h"

#include <algorithm>
#include <utility>

namespace openr_host {

const char* SeverityName(Severity severity) {
  return severity == Severity::kError ? "error" : "warning";
}

void Findings::Add(Finding finding) {
  for (Finding& known : all_) {
    if (known.robot == finding.robot && known.object == finding.object &&
        known.text == finding.text && known.severity == finding.severity) {
      ++known.count;
      return;
    }
  }
  if (all_.size() >= kMax) {
    ++not_kept_;
    return;
  }
  all_.push_back(std::move(finding));
}

bool Findings::HasError() const {
  return std::any_of(all_.begin(), all_.end(),
                     [](const Finding& f) { return f.severity == Severity::kError; });
}

}  // namespace openr_host

#include "runtime/core/findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

namespace openr_host {

const char* SeverityName(Severity severity) {
  if (severity == Severity::kNote) return "note";
  return severity == Severity::kError ? "error" : "warning";
}

std::string RepetitionText(const Finding& finding) {
  if (finding.count < 2) return "";
  std::string text = fmt::format(" ({} times", finding.count);
  if (!finding.also_at.empty())
    text += fmt::format(", also at {}", fmt::join(finding.also_at, ", "));
  const uint64_t rest = finding.count - 1 - finding.also_at.size();
  if (!finding.also_at.empty() && rest > 0) text += fmt::format(" and {} more", rest);
  return text + ")";
}

Finding* Findings::Add(Finding finding) {
  for (Finding& known : all_) {
    const bool is_same_kind = known.robot == finding.robot && known.object == finding.object &&
                              known.severity == finding.severity;
    const bool has_same_cause = !finding.cause.empty() && known.cause == finding.cause;
    if (!is_same_kind || (!has_same_cause && known.text != finding.text)) continue;
    ++known.count;
    if (has_same_cause && known.also_at.size() < kPlacesMax)
      known.also_at.push_back(std::move(finding.place));
    return nullptr;
  }
  if (all_.size() >= kMax) {
    ++not_kept_;
    return nullptr;
  }
  return &all_.emplace_back(std::move(finding));
}

bool Findings::HasError(size_t first, std::optional<int> robot) const {
  return std::any_of(all_.begin() + static_cast<ptrdiff_t>(first), all_.end(),
                     [robot](const Finding& f) {
                       return f.severity == Severity::kError && (!robot || f.robot == *robot);
                     });
}

}  // namespace openr_host

#include "openr/live/console_log.h"

#include <utility>

namespace openr_host {

void ConsoleLog::Add(int64_t time_us, std::string_view text) {
  while (!text.empty()) {
    const size_t end = text.find('\n');
    begun_ += text.substr(0, end);
    if (begun_.size() > kLineMax) begun_.resize(kLineMax);
    if (end == std::string_view::npos) return;
    text.remove_prefix(end + 1);
    lines_.push_back({time_us, std::exchange(begun_, "")});
    ++count_;
    if (lines_.size() > kLinesMax) lines_.pop_front();
  }
}

}  // namespace openr_host

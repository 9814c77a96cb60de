#include "cli/progress_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "cli/output_file.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

constexpr int64_t kPauseNs = 200'000'000;  // least time between two drawings
constexpr char kToStart[] = "\r\x1b[K";    // moves the cursor to the line's start, clears the line

constexpr int64_t kSecondUs = 1'000'000;

// Descriptor of the terminal that shows a progress line; -1: no terminal shows one.  Atomic,
// because each write to standard error calls ClearProgressLine(), and threads of Cyclone DDS write
// there, too.
std::atomic<int> g_drawn_on = -1;

std::string TimeLeft(double left_s) {
  constexpr double kInMinutes_s = 180;
  const double rounded_s = std::ceil(left_s);
  return rounded_s < kInMinutes_s ? fmt::format("{:.0f} s", rounded_s)
                                  : fmt::format("{:.0f} min", std::ceil(left_s / 60));
}

}  // namespace

int64_t ProgressQuietNs() {
  constexpr int64_t kQuietMs = 2000, kMillisecondNs = 1'000'000;
  const char* const value = std::getenv("OPENR_HOST_PROGRESS_MS");
  const std::string_view text = value == nullptr ? "" : value;
  uint32_t quiet_ms = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), quiet_ms);
  const bool is_number = error == std::errc() && end == text.data() + text.size();
  return (is_number ? int64_t{quiet_ms} : kQuietMs) * kMillisecondNs;
}

std::string ProgressText(uint64_t done, std::optional<uint64_t> total, const std::string& what,
                         double elapsed_s) {
  if (!total) return fmt::format("openr: {} {}", done, what);
  std::string text = fmt::format("openr: {} of {} {}", done, *total, what);
  if (done == 0 || done > *total) return text;
  const double left_s = elapsed_s / static_cast<double>(done) * static_cast<double>(*total - done);
  return text + fmt::format(", about {} left", TimeLeft(left_s));
}

ProgressLine::ProgressLine(int descriptor, std::optional<uint64_t> total, std::string what,
                           int64_t quiet_ns)
    : descriptor_(descriptor >= 0 && isatty(descriptor) != 0 ? descriptor : -1),
      total_(total),
      what_(std::move(what)),
      begin_ns_(WallClockNs()),
      quiet_ns_(quiet_ns) {}

ProgressLine::~ProgressLine() { ClearProgressLine(); }

void ProgressLine::Show(uint64_t done) {
  if (descriptor_ < 0) return;
  const int64_t now_ns = WallClockNs();
  if (now_ns - begin_ns_ < quiet_ns_ || now_ns - drawn_ns_ < kPauseNs) return;
  drawn_ns_ = now_ns;
  const double elapsed_s = static_cast<double>(now_ns - begin_ns_) / 1e9;
  WriteAll(descriptor_, kToStart + ProgressText(done, total_, what_, elapsed_s));
  g_drawn_on = descriptor_;
}

RunProgressLine::RunProgressLine(int descriptor, int64_t begin_us, int64_t end_us)
    : begin_us_(begin_us),
      line_(descriptor, static_cast<uint64_t>(std::max<int64_t>(end_us - begin_us, 0) / kSecondUs),
            "s of virtual time") {}

void RunProgressLine::Show(int64_t now_us) {
  line_.Show(static_cast<uint64_t>(std::max<int64_t>(now_us - begin_us_, 0) / kSecondUs));
}

void ClearProgressLine() {
  const int descriptor = g_drawn_on.exchange(-1);
  if (descriptor >= 0) WriteAll(descriptor, kToStart);
}

}  // namespace openr_host

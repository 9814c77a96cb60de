#include "openr/data/csv_log.h"

#include <fmt/format.h>

#include <iterator>
#include <variant>

#include "cli/csv_field.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Longest virtual time for which a line of the CSV file is kept in memory before it is written.
constexpr int64_t kFlushUs = 1'000'000;

}  // namespace

CsvLog::CsvLog(const std::string& file, Simulation* simulation)
    : simulation_(simulation),
      view_(simulation),
      columns_(ColumnsOf(view_.run())),
      file_(file),
      lines_("time_s") {
  for (const Column& column : columns_) lines_ += "," + CsvField(column.name);
  lines_ += "\n";
  Flush();
}

void CsvLog::Sample() {
  const int64_t now_us = simulation_->system().now_us();
  if (now_us == last_us_) return;
  last_us_ = now_us;
  view_.Sample();
  fmt::format_to(std::back_inserter(lines_), "{:.6f}", static_cast<double>(now_us) / 1e6);
  for (const Column& column : columns_) {
    lines_ += ",";
    AppendNumber(std::get<double>(column.read(view_.run())), &lines_);
  }
  lines_ += "\n";
  if (now_us - written_us_ < kFlushUs) return;
  written_us_ = now_us;
  Flush();
}

void CsvLog::Flush() {
  file_.Append(lines_);
  lines_.clear();
}

std::string CsvLog::Finish() {
  Flush();
  return file_.Problem();
}

}  // namespace openr_host

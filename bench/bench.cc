#include "bench/bench.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>

#include "bench/report.h"

namespace openr_host {
namespace {

// Returns the wall time in seconds, counted from an arbitrary moment.
double WallSeconds() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

// Runs the variants of `row` in turn, row.rounds times.
RowTimes Measure(const Row& row) {
  RowTimes times{row, std::vector<std::vector<double>>(row.variants.size())};
  for (int round = 0; round < row.rounds; ++round) {
    for (size_t i = 0; i < row.variants.size(); ++i) {
      if (row.warm_up > 0) row.variants[i].run(row.warm_up);
      const double begin = WallSeconds();
      row.variants[i].run(row.count);
      times.seconds[i].push_back((WallSeconds() - begin) / static_cast<double>(row.count));
    }
  }
  return times;
}

}  // namespace

std::vector<RowTimes> RunRows(const std::vector<Row>& rows, const std::string& filter) {
  std::vector<RowTimes> all;
  fmt::print("{}\n", TableHead());
  for (const Row& row : rows) {
    if (row.name.find(filter) == std::string::npos) continue;
    all.push_back(Measure(row));
    fmt::print("{}", TableOf(all.back()));
    std::fflush(stdout);
  }
  return all;
}

}  // namespace openr_host

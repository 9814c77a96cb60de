#include "bench/bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "bench/machine.h"

namespace openr_host {

double WallSeconds() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

namespace {

double MedianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Runs the variants of `row` in turn, row.rounds times.  Returns for each variant the seconds that
// an operation took in each round.
std::vector<std::vector<double>> Measure(const Row& row) {
  std::vector<std::vector<double>> seconds(row.variants.size());
  for (int round = 0; round < row.rounds; ++round) {
    for (size_t i = 0; i < row.variants.size(); ++i) {
      const double begin = WallSeconds();
      row.variants[i].run(row.count);
      seconds[i].push_back((WallSeconds() - begin) / static_cast<double>(row.count));
    }
  }
  return seconds;
}

// Prints the figures of `row` and adds them to `json`.  The ratio is the median of the ratios of
// the rounds, because another program that disturbs a round disturbs all variants of that round.
void Report(const Row& row, const std::vector<std::vector<double>>& seconds, nlohmann::json* json) {
  for (size_t i = 0; i < row.variants.size(); ++i) {
    std::vector<double> ratios;
    for (size_t round = 0; round < seconds[i].size(); ++round)
      ratios.push_back(seconds[i][round] / seconds[0][round]);
    const double median_ns = MedianOf(seconds[i]) * 1e9;
    const double best_ns = *std::min_element(seconds[i].begin(), seconds[i].end()) * 1e9;
    const double ratio = MedianOf(ratios);
    const bool has_target = row.target > 0 && i == 1;
    std::printf("%-46s %-28s %9.1f ns %9.1f ns %7.2fx %8s\n", i == 0 ? row.name.c_str() : "",
                row.variants[i].name.c_str(), median_ns, best_ns, ratio,
                has_target ? fmt::format("{:.2f}x", row.target).c_str() : "");
    nlohmann::json entry = {{"row", row.name},        {"variant", row.variants[i].name},
                            {"unit", row.unit},       {"rounds", row.rounds},
                            {"median_ns", median_ns}, {"best_ns", best_ns},
                            {"ratio_to_floor", ratio}};
    if (has_target) entry["target"] = row.target;
    json->push_back(entry);
  }
  std::fflush(stdout);
}

}  // namespace

void RunRows(const std::vector<Row>& rows, const std::string& filter,
             const std::string& json_path) {
  const char* const commit = std::getenv("OPENR_COMMIT");
  nlohmann::json json = {{"processor", ProcessorName()},
                         {"processors", std::thread::hardware_concurrency()},
                         {"compiler", CompilerName()},
                         {"c_library", CLibraryName()},
                         {"commit", commit == nullptr ? "unknown" : commit},
                         {"rows", nlohmann::json::array()}};
  std::printf("%-46s %-28s %12s %12s %8s %8s\n", "row", "variant", "median", "best", "ratio",
              "target");
  for (const Row& row : rows) {
    if (row.name.find(filter) == std::string::npos) continue;
    Report(row, Measure(row), &json["rows"]);
  }
  if (!json_path.empty()) std::ofstream(json_path) << json.dump(2) << "\n";
}

}  // namespace openr_host

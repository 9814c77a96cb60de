#include "bench/bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

namespace openr_host {

double WallSeconds() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

void RunRows(const std::vector<Row>& rows, const std::string& filter,
             const std::string& json_path) {
  nlohmann::json json = nlohmann::json::array();
  std::printf("%-46s %-28s %12s %8s %8s\n", "row", "variant", "figure", "ratio", "target");
  for (const Row& row : rows) {
    if (row.name.find(filter) == std::string::npos) continue;
    std::vector<double> best(row.variants.size(), 1e300);
    for (int round = 0; round < row.rounds; ++round) {
      for (size_t i = 0; i < row.variants.size(); ++i) {
        const double begin = WallSeconds();
        row.variants[i].run(row.count);
        best[i] = std::min(best[i], (WallSeconds() - begin) / static_cast<double>(row.count));
      }
    }
    for (size_t i = 0; i < row.variants.size(); ++i) {
      const double ns = best[i] * 1e9;
      const double ratio = best[i] / best[0];
      const bool has_target = row.target > 0 && i == 1;
      std::printf("%-46s %-28s %9.1f ns %7.2fx %8s\n", i == 0 ? row.name.c_str() : "",
                  row.variants[i].name.c_str(), ns, ratio,
                  has_target ? fmt::format("{:.2f}x", row.target).c_str() : "");
      nlohmann::json entry = {{"row", row.name},
                              {"variant", row.variants[i].name},
                              {"ns", ns},
                              {"unit", row.unit},
                              {"ratio_to_floor", ratio}};
      if (has_target) entry["target"] = row.target;
      json.push_back(entry);
    }
    std::fflush(stdout);
  }
  if (!json_path.empty()) std::ofstream(json_path) << json.dump(2) << "\n";
}

}  // namespace openr_host

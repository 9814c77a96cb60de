#include "tests/fuzz/table_checks.h"

#include <stdexcept>
#include <string>

#include "openr/chart/chart.h"
#include "openr/data/table_chart.h"
#include "tests/fuzz/fuzz_targets.h"

#ifdef OPENR_FUZZ_CHARTS
namespace openr_host::chart {
extern "C" DrawChartFunction openr_draw_chart;
}  // namespace openr_host::chart
#endif

namespace openr_host {

void DrawFuzzedTable(const Table& table) {
  for (const Series& series : table.series)
    FuzzCheck(series.time_s.size() == series.values.size(), "each value has a time");
  PlotRequest request;
  request.wanted = {"*"};
  try {
    const chart::Chart chart = ChartOf(table, request);
#ifdef OPENR_FUZZ_CHARTS
    std::string bytes, problem;
    chart::openr_draw_chart(chart, chart::FileType::kSvg, &bytes, &problem);
    FuzzCheck(problem.empty(), "a chart is drawn");
    FuzzCheck(bytes.find("\"nan") == std::string::npos, "each point has a place");
#endif
  } catch (const std::runtime_error&) {
  }
}

}  // namespace openr_host

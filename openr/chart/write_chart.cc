#include <dlfcn.h>
#include <fmt/format.h>

#include "cli/install_paths.h"
#include "cli/output_file.h"
#include "openr/chart/chart.h"

namespace openr_host::chart {
namespace {

bool EndsIn(const std::string& file, const std::string& end) {
  return file.size() > end.size() && file.compare(file.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

std::string ChartNameProblem(const std::string& file) {
  if (EndsIn(file, ".svg") || EndsIn(file, ".png")) return "";
  return fmt::format("{}: the name of a chart ends in .svg or .png", file);
}

std::string WriteChart(const Chart& chart, const std::string& file) {
  const std::string library = ChartLibrary();
  static void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    return fmt::format(
        "{}: no charts: {}; they need Cairo (Debian package libcairo2-dev): install it, then "
        "configure and build openr again",
        file, dlerror());
  }
  auto* const draw = reinterpret_cast<DrawChartFunction*>(dlsym(handle, kDrawChartName));
  if (draw == nullptr) return fmt::format("{}: is of another version; build it again", library);
  std::string bytes, problem;
  draw(chart, EndsIn(file, ".svg") ? FileType::kSvg : FileType::kPng, &bytes, &problem);
  return problem.empty() ? WriteFile(file, bytes) : fmt::format("{}: {}", file, problem);
}

}  // namespace openr_host::chart

#include "openr/data/data_log.h"

#include <fmt/format.h>

#include "openr/data/csv_log.h"
#include "openr/data/mcap_log.h"

namespace openr_host {

std::string DataLogNameProblem(const std::string& file) {
  if (file.ends_with(".csv") || file.ends_with(".mcap")) return "";
  return fmt::format("{}: the name of a log of data ends in .csv or .mcap", file);
}

std::unique_ptr<DataLog> MakeDataLog(const DataLogOptions& options, Simulation* simulation) {
  if (options.file.ends_with(".csv")) return std::make_unique<CsvLog>(options.file, simulation);
  return std::make_unique<McapLog>(options, simulation);
}

}  // namespace openr_host

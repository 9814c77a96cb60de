// CsvLog: writes quantities as comma-separated values, a line for each frame of 8 ms.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/growing_file.h"
#include "openr/data/columns.h"
#include "openr/data/data_log.h"

namespace openr_host {

class CsvLog : public DataLog {
 public:
  CsvLog(const std::string& file, Simulation* simulation);
  void Sample() override;
  std::string Finish() override;

 private:
  void Flush();

  Simulation* const simulation_;
  SimulationView view_;
  const std::vector<Column> columns_;
  GrowingFile file_;
  int64_t last_us_ = -1;    // virtual time of the last line that was added to the log
  int64_t written_us_ = 0;  // virtual time of the last line that is in the file
  std::string lines_;       // lines of the log that are not in the file yet
};

}  // namespace openr_host

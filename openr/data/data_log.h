// DataLog: writes the quantities of a run to a file while the run goes on (--log-data).
//
// A line of a CSV file, or a message of an MCAP file, is written after each frame of 8 ms.  It has
// the values of all quantities that NumbersOf() (openr/explore/quantity.h) names, under these
// names.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace openr_host {

class Simulation;

struct DataLogOptions {
  std::string file;  // path of the log; it ends in .csv or .mcap
  // The least virtual time between two pictures of a camera in an MCAP file; 0: no pictures.
  int64_t image_distance_us = 200'000;
};

// Returns the reason why `file` cannot be the name of a log of data; "" if it can.
std::string DataLogNameProblem(const std::string& file);

class DataLog {
 public:
  virtual ~DataLog() = default;

  // Adds the values of the frame that has just ended to the file of --log-data.  A second call in
  // the same frame adds nothing.
  virtual void Sample() = 0;

  // Completes the file of --log-data.  Returns "", or the error that happened while the file was
  // written.  Further calls do nothing.
  virtual std::string Finish() = 0;
};

// Creates the file of --log-data.  Returns a DataLog that writes the quantities of `simulation` to
// this file.  Throws std::runtime_error when the file cannot be created or another run is writing
// to it.
std::unique_ptr<DataLog> MakeDataLog(const DataLogOptions& options, Simulation* simulation);

}  // namespace openr_host

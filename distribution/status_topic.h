// The DDS topic with the status of runs: openr run writes it, openr top reads it.
//
// Delivery is best effort with the newest sample only, so a slow listener never delays a run.
#pragma once

#include <string>
#include <vector>

#include "distribution/bus.h"
#include "distribution/run_status.h"

namespace openr_host {

class StatusWriter {
 public:
  // Creates a writer of the status of the bus's run.  Throws std::runtime_error.
  explicit StatusWriter(Bus* bus);

  // Sends `status` if this is possible without waiting; otherwise drops it.
  void Write(const RunStatus& status);

 private:
  dds_entity_t writer_ = 0;
};

class StatusReader {
 public:
  // Creates a reader of the status of the bus's run.  If the name of this run is "*", a wildcard in
  // DDS, creates a reader of the status of all runs.
  explicit StatusReader(Bus* bus);

  // Returns the newest status of each run that has arrived since the last call.  A run whose
  // process has ended without a final status is reported as ended.  Texts are made printable,
  // because they come from the network and are shown on terminals.  No text is longer than its type
  // in openr_status.idl allows.
  std::vector<RunStatus> Take();

 private:
  dds_entity_t reader_ = 0;
};

}  // namespace openr_host

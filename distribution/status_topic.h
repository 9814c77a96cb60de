// The topic on which runs say how they are: written by openr run, read by openr top.
//
// Best effort and the newest only: nobody who listens slowly, or not at all, holds a run up.
#pragma once

#include <string>
#include <vector>

#include "distribution/bus.h"
#include "distribution/run_status.h"

namespace openr_host {

class StatusWriter {
 public:
  // In the partition of the bus's run.  Throws std::runtime_error.
  explicit StatusWriter(Bus* bus);

  // Never waits; a sample that cannot be sent is left out.
  void Write(const RunStatus& status);

 private:
  dds_entity_t writer_ = 0;
};

class StatusReader {
 public:
  // Of the run of the bus, or of "*": all there are.
  explicit StatusReader(Bus* bus);

  // What has come since the last time, the newest of each run; a run that went without a word is
  // one that has ended.  Texts are printable and at most as long as in openr_status.idl.
  std::vector<RunStatus> Take();

 private:
  dds_entity_t reader_ = 0;
};

}  // namespace openr_host

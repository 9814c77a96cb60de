// NameClaim: the claim of a run to its name.  A worker finds its run by the name (openr join), so
// two runs on the same network must not share a name.
#pragma once

#include <string>

#include "distribution/bus.h"

namespace openr_host {

class NameClaim {
 public:
  // Claims the run name of `bus` (Bus::run()) for this process, and announces the claim to other
  // runs.
  explicit NameClaim(Bus* bus);

  // Returns the run that has claimed the name earlier, as "pid 12 on host"; "" if there is no such
  // run.
  std::string EarlierRun() const;

  // Makes this claim earlier than every claim with a real time.  Called when a worker has joined
  // this run.  Every run of the same name that still waits for workers must then give way, whatever
  // the clocks of the hosts say.
  void MakePermanent();

 private:
  void Announce(const std::string& claim);

  Bus* const bus_;
  // The claim of this run, a text that begins with the time of the claim.  So comparing two claims
  // as texts compares their times.  The run with the earlier claim keeps the name.
  const std::string own_;
  bool is_permanent_ = false;
  dds_entity_t topic_ = 0;
  dds_entity_t reader_ = 0;
};

}  // namespace openr_host

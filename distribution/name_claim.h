// That a run is the only one of its name, as far as it hears others: openr join goes by the name.
#pragma once

#include <string>

#include "distribution/bus.h"

namespace openr_host {

class NameClaim {
 public:
  // Of the bus's run.
  explicit NameClaim(Bus* bus);

  // "pid 12 on host": a run that has had the name for longer; "".
  std::string EarlierRun() const;

  // Somebody has joined: from now on every run that still waits is the younger one, whatever the
  // clocks of the hosts say.
  void MakePermanent();

 private:
  void Announce(const std::string& claim);

  Bus* const bus_;
  const std::string own_;  // claims are compared as text
  bool is_permanent_ = false;
  dds_entity_t topic_ = 0;
  dds_entity_t reader_ = 0;
};

}  // namespace openr_host

// Says about once a second of the wall clock how a run is, for openr top and others who listen.
//
// It only looks: what it says, or whether anybody hears it, changes nothing of the run.
#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>

#include "distribution/bus.h"
#include "distribution/latency.h"
#include "distribution/status_topic.h"
#include "runtime/core/message.h"

namespace openr_host {

class WorkerGroup;
class RemoteObject;
class System;

class Monitor {
 public:
  // Of a run whose processes are those of `workers`; null: it is all in this one.
  Monitor(const System* system, Bus* bus, const WorkerGroup* workers);

  // Speaks if it is time.  Not from a handler.
  void PublishIfDue();

  // The run is over.
  void End();

 private:
  using Clock = std::chrono::steady_clock;

  void Publish(Clock::time_point now, bool has_ended);
  RunStatus::Times TimesOf(const RemoteObject& object);

  const System* const system_;
  const WorkerGroup* const workers_;  // may be null
  const std::string run_;
  StatusWriter writer_;
  const Clock::time_point begin_ = Clock::now();
  // When it spoke last, and how things were.
  Clock::time_point published_ = begin_;
  int64_t virtual_us_ = 0;
  uint64_t messages_ = 0;
  RunStatus last_status_;  // the last time
  std::map<ObjectId, uint64_t> messages_of_;
  std::map<ObjectId, Latency> latency_of_;
};

}  // namespace openr_host

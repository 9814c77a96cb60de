// Monitor: publishes the status of a run for openr top and other listeners, about once a second of
// the wall clock.
//
// The monitor only reads the state of the run, so neither publishing nor a listener changes the
// run.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "distribution/bus.h"
#include "distribution/latency.h"
#include "distribution/status_topic.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/message.h"

namespace openr_host {

class WorkerGroup;
class RemoteObject;
class System;

class Monitor {
 public:
  // `workers` are the workers of the run; null if all objects are in this process.
  Monitor(const System* system, Bus* bus, const WorkerGroup* workers);

  // Publishes the status of the run if the last status was published at least a second ago.  Must
  // not be called from a handler.
  void PublishIfDue();

  // Publishes the final status of the run, which says that the run has ended.
  void End();

 private:
  // Publishes the status at the time `now_ns` of the wall clock.
  void Publish(int64_t now_ns, bool has_ended);
  RunStatus::Times TimesOf(const RemoteObject& object);

  const System* const system_;
  const WorkerGroup* const workers_;  // workers of the run; null if the run has no workers
  const std::string run_;
  StatusWriter writer_;
  const int64_t begin_ns_ = WallClockNs();
  // The time of the newest status of the run and the counters at that time, from which the rates of
  // the next status are computed.
  int64_t published_ns_ = begin_ns_;
  int64_t virtual_us_ = 0;
  uint64_t messages_ = 0;
  RunStatus last_status_;  // the status that was published last
  std::map<ObjectId, uint64_t> messages_of_;
  std::map<ObjectId, Latency> latency_of_;
};

}  // namespace openr_host

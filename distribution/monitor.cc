#include "distribution/monitor.h"

#include <unistd.h>

#include <algorithm>
#include <utility>

#include "distribution/process_slot.h"
#include "distribution/remote_object.h"
#include "distribution/remote_process.h"
#include "distribution/worker_group.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr int64_t kIntervalNs = 1'000'000'000;
constexpr double kIntervalMin_s = 1e-3;  // shortest time over which rates are computed

// Copies the rates (speed of the virtual time, messages per second) of `before`, the previous
// status of the run, to its final status.  No rates are computed for the final status, because too
// little time may have passed since the previous status.
void KeepRates(const RunStatus& before, RunStatus* status) {
  status->x_real_time = before.x_real_time;
  status->messages_per_s = before.messages_per_s;
  for (size_t i = 0; i < std::min(before.objects.size(), status->objects.size()); ++i) {
    status->objects[i].messages_per_s = before.objects[i].messages_per_s;
    status->objects[i].handlers = before.objects[i].handlers;
  }
}

}  // namespace

Monitor::Monitor(const System* system, Bus* bus, const WorkerGroup* workers)
    : system_(system), workers_(workers), run_(bus->run()), writer_(bus) {}

void Monitor::PublishIfDue() {
  const int64_t now_ns = WallClockNs();
  if (now_ns - published_ns_ >= kIntervalNs) Publish(now_ns, false);
}

void Monitor::End() { Publish(WallClockNs(), true); }

void Monitor::Publish(int64_t now_ns, bool has_ended) {
  const auto seconds = [](int64_t ns) { return static_cast<double>(ns) / 1e9; };
  const double passed_s =
      std::max(seconds(now_ns - std::exchange(published_ns_, now_ns)), kIntervalMin_s);
  // Returns the increase of `count` since the previous status, per second.  An object in a
  // restarted worker counts from 0 again, so a count that is below the old count is itself the
  // increase.
  const auto rate = [passed_s](uint64_t count, uint64_t* before) {
    const uint64_t old = std::exchange(*before, count);
    return static_cast<double>(count < old ? count : count - old) / passed_s;
  };
  RunStatus status;
  status.run = run_;
  status.host = HostName();
  status.pid = getpid();
  status.has_ended = has_ended;
  if (has_ended && system_->end()) status.end = DescribeEnd(*system_->end());
  status.virtual_us = system_->now_us();
  status.wall_s = seconds(now_ns - begin_ns_);
  const int64_t virtual_us = status.virtual_us - std::exchange(virtual_us_, status.virtual_us);
  status.x_real_time = static_cast<double>(virtual_us) / 1e6 / passed_s;
  status.messages = system_->message_count();
  status.messages_per_s = rate(status.messages, &messages_);
  if (workers_ != nullptr) {
    for (const WorkerGroup::ProcessFacts& facts : workers_->Describe())
      status.processes.push_back({facts.name, facts.host, facts.pid, facts.lost});
  }
  for (const auto& object : system_->objects()) {
    RunStatus::Object& to = status.objects.emplace_back();
    to.robot = object->robot;
    to.name = object->name;
    to.state = object->statistics().state();
    to.priority = object->limits().priority;
    to.messages = object->message_count();
    to.messages_per_s = rate(to.messages, &messages_of_[object->id]);
    to.dropped = object->statistics().dropped_count();
    to.waiting = object->waiting();
    to.waiting_max = object->waiting_max();
    status.waiting += object->waiting();
    if (const auto* const remote = dynamic_cast<const RemoteObject*>(object.get())) {
      to.process = remote->process()->name();
      to.dropped += remote->undelivered_count;
      to.handlers = TimesOf(*remote);
    }
  }
  if (has_ended && !last_status_.objects.empty()) KeepRates(last_status_, &status);
  writer_.Write(status);
  last_status_ = std::move(status);
}

// Returns how long the handlers of `object` have taken since the previous status was published.
RunStatus::Times Monitor::TimesOf(const RemoteObject& object) {
  Latency& before = latency_of_[object.id];
  const Latency now = object.process()->handlers().LatencyOf(object.id);
  const Latency since = now.Since(std::exchange(before, now));
  return {since.count(), since.MeanUs(), since.PercentileUs(0.99), since.MaxUs()};
}

}  // namespace openr_host

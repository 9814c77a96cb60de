#include "distribution/status_topic.h"

#include <algorithm>
#include <cmath>

#include "distribution/dds_check.h"
#include "openr_status.h"

namespace openr_host {
namespace {

constexpr char kStatusTopic[] = "openr_status";
constexpr int kStatusRunsMax = 256;  // largest number of runs whose status is kept

dds_qos_t* StatusQos(const std::string& partition) {
  dds_qos_t* const qos = Dds().dds_create_qos();
  Dds().dds_qset_reliability(qos, DDS_RELIABILITY_BEST_EFFORT, 0);
  Dds().dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 1);
  Dds().dds_qset_resource_limits(qos, DDS_LENGTH_UNLIMITED, kStatusRunsMax, 1);
  const char* names[] = {partition.c_str()};
  Dds().dds_qset_partition(qos, 1, names);
  return qos;
}

using NewGroup = dds_entity_t (*)(dds_entity_t, const dds_qos_t*, const dds_listener_t*);
using NewEnd = dds_entity_t (*)(dds_entity_t, dds_entity_t, const dds_qos_t*,
                                const dds_listener_t*);

// Creates a reader or a writer of the status topic by calling `new_end`, a function of Cyclone DDS.
// In DDS, a reader has the partition of its subscriber, and a writer has the partition of its
// publisher.  So the function first creates the subscriber or publisher by calling `new_group`.
dds_entity_t Open(Bus* bus, NewGroup new_group, NewEnd new_end) {
  const dds_entity_t topic = Dds().dds_create_topic(bus->participant(), &openr_status_Status_desc,
                                                    kStatusTopic, nullptr, nullptr);
  Check(topic, "topic");
  dds_qos_t* const qos = StatusQos(bus->run());
  const dds_entity_t group = new_group(bus->participant(), qos, nullptr);
  const dds_entity_t end = new_end(group, topic, qos, nullptr);
  Dds().dds_delete_qos(qos);
  return Check(end, kStatusTopic);
}

// Copies as much of `text` as fits into the bounded string `out`.
template <size_t N>
void Put(const std::string& text, char (*out)[N]) {
  const size_t size = std::min({text.size(), text.find('\0'), N - 1});
  std::copy_n(text.data(), size, *out);
  (*out)[size] = '\0';
}

// Returns `text` with '?' for every character that is not printable ASCII, because the text comes
// from the network and is shown on terminals.
std::string Printable(const char* text) {
  std::string printable = text;
  for (char& c : printable) {
    if (c < ' ' || c > '~') c = '?';
  }
  return printable;
}

// Returns `value`, a number from the network, limited to what the table of openr top can show; 0 if
// it is not finite.
double FiniteFigure(double value) {
  return std::isfinite(value) ? std::clamp(value, 0.0, 1e12) : 0;
}

openr_status_Status Encode(const RunStatus& in, std::vector<openr_status_ProcessStatus>* processes,
                           std::vector<openr_status_ObjectStatus>* objects) {
  openr_status_Status out{};
  Put(in.run, &out.run);
  Put(in.host, &out.host);
  out.pid = in.pid;
  out.has_ended = in.has_ended;
  Put(in.end, &out.end);
  out.virtual_us = in.virtual_us;
  out.wall_s = in.wall_s;
  out.x_real_time = in.x_real_time;
  out.messages_per_s = in.messages_per_s;
  out.messages = in.messages;
  out.waiting = in.waiting;
  for (const RunStatus::Process& process : in.processes) {
    openr_status_ProcessStatus& to = processes->emplace_back();
    Put(process.name, &to.name);
    Put(process.host, &to.host);
    to.pid = process.pid;
    Put(process.lost, &to.lost);
  }
  for (const RunStatus::Object& object : in.objects) {
    openr_status_ObjectStatus& to = objects->emplace_back();
    to.robot = object.robot;
    Put(object.name, &to.name);
    Put(object.process, &to.process);
    Put(object.state, &to.state);
    to.priority = object.priority;
    to.messages = object.messages;
    to.messages_per_s = object.messages_per_s;
    to.dropped = object.dropped;
    to.waiting = object.waiting;
    to.waiting_max = object.waiting_max;
    const RunStatus::Times& times = object.handlers;
    to.handlers = {times.count, times.mean_us, times.p99_us, times.max_us};
  }
  return out;
}

RunStatus Decode(const openr_status_Status& in) {
  RunStatus out;
  out.run = Printable(in.run);
  out.host = Printable(in.host);
  out.pid = in.pid;
  out.has_ended = in.has_ended;
  out.end = Printable(in.end);
  out.virtual_us = in.virtual_us;
  out.wall_s = FiniteFigure(in.wall_s);
  out.x_real_time = FiniteFigure(in.x_real_time);
  out.messages_per_s = FiniteFigure(in.messages_per_s);
  out.messages = in.messages;
  out.waiting = in.waiting;
  out.objects_left_out = in.objects_left_out;
  for (uint32_t i = 0; i < in.processes._length; ++i) {
    const openr_status_ProcessStatus& from = in.processes._buffer[i];
    out.processes.push_back(
        {Printable(from.name), Printable(from.host), from.pid, Printable(from.lost)});
  }
  for (uint32_t i = 0; i < in.objects._length; ++i) {
    const openr_status_ObjectStatus& from = in.objects._buffer[i];
    const openr_status_Times& times = from.handlers;
    out.objects.push_back({from.robot,
                           Printable(from.name),
                           Printable(from.process),
                           Printable(from.state),
                           from.priority,
                           from.messages,
                           FiniteFigure(from.messages_per_s),
                           from.dropped,
                           from.waiting,
                           from.waiting_max,
                           {times.count, FiniteFigure(times.mean), FiniteFigure(times.p99),
                            FiniteFigure(times.max)}});
  }
  return out;
}

// Makes `sequence` point to `items`, without a copy.  So `items` must outlive the sample.
template <typename Seq, typename T>
void SetSequence(std::vector<T>* items, Seq* sequence) {
  const auto count = static_cast<uint32_t>(items->size());
  *sequence = {count, count, items->data(), false};
}

}  // namespace

StatusWriter::StatusWriter(Bus* bus)
    : writer_(Open(bus, Dds().dds_create_publisher, Dds().dds_create_writer)) {}

void StatusWriter::Write(const RunStatus& status) {
  std::vector<openr_status_ProcessStatus> processes;
  std::vector<openr_status_ObjectStatus> objects;
  openr_status_Status sample = Encode(status, &processes, &objects);
  processes.resize(std::min<size_t>(processes.size(), openr_status_PROCESSES_MAX));
  const size_t sent_count = std::min<size_t>(objects.size(), openr_status_OBJECTS_MAX);
  sample.objects_left_out = static_cast<uint32_t>(objects.size() - sent_count);
  objects.resize(sent_count);
  SetSequence(&processes, &sample.processes);
  SetSequence(&objects, &sample.objects);
  Dds().dds_write(writer_, &sample);
}

StatusReader::StatusReader(Bus* bus)
    : reader_(Open(bus, Dds().dds_create_subscriber, Dds().dds_create_reader)) {
  const dds_entity_t condition = Dds().dds_create_readcondition(reader_, DDS_ANY_STATE);
  Check(condition, "read condition");
  // Attaches the reader's condition "a sample has arrived" to the bus's wait set, so that
  // Bus::Wait() also returns when a status arrives.
  Check(Dds().dds_waitset_attach(bus->waitset(), condition, 0), "wait set");
}

std::vector<RunStatus> StatusReader::Take() {
  std::vector<RunStatus> all;
  for (int i = 0; i < kStatusRunsMax; ++i) {
    void* sample = nullptr;
    dds_sample_info_t info;
    if (Dds().dds_take(reader_, &sample, &info, 1, 1) != 1) break;
    const auto& status = *static_cast<const openr_status_Status*>(sample);
    if (info.valid_data) {
      all.push_back(Decode(status));
    } else {
      RunStatus gone;  // the run's writer is gone, so DDS gives only the key fields of its status
      gone.run = Printable(status.run);
      gone.host = Printable(status.host);
      gone.pid = status.pid;
      gone.has_ended = true;
      all.push_back(std::move(gone));
    }
    Dds().dds_return_loan(reader_, &sample, 1);
  }
  return all;
}

}  // namespace openr_host

// A writer and a reader of topics that ROS 2 understands: named and typed as its mapping to DDS
// has it, in the partition of everybody.
#pragma once

#include <dds/dds.h>

#include <string>

#include "distribution/bus.h"

namespace openr_host {

// Reliable, so that it suits readers of both kinds, with the newest `depth` samples.  A write never
// waits: what a reader does not take in time is lost to it.
class Ros2Writer {
 public:
  // `name` as ROS 2 has it, without the slash in front: "aibo/joint_states".  Throws
  // std::runtime_error.
  Ros2Writer(Bus* bus, const dds_topic_descriptor_t& type, const std::string& name, int depth);
  ~Ros2Writer();
  Ros2Writer(const Ros2Writer&) = delete;
  Ros2Writer& operator=(const Ros2Writer&) = delete;

  bool HasReaders() const;
  // Nothing without readers.
  void Write(const void* sample);

 private:
  dds_entity_t topic_ = 0;
  dds_entity_t writer_ = 0;
};

// Reliable, with the newest `depth` samples of each writer together.
class Ros2Reader {
 public:
  Ros2Reader(Bus* bus, const dds_topic_descriptor_t& type, const std::string& name, int depth);
  ~Ros2Reader();
  Ros2Reader(const Ros2Reader&) = delete;
  Ros2Reader& operator=(const Ros2Reader&) = delete;

  // Somebody writes who does not go with this reader: best-effort.
  bool HasMisfit() const;

  // The next sample, to be given to Return(); null when there is none.
  void* Take();
  void Return(void* sample);

 private:
  dds_entity_t topic_ = 0;
  dds_entity_t reader_ = 0;
};

}  // namespace openr_host

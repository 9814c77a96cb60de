// Writers and readers of ROS 2 topics over DDS.  Names and types follow the mapping of ROS 2 to
// DDS; the DDS partition is the default one.
#pragma once

#include <dds/dds.h>

#include <string>

#include "distribution/bus.h"

namespace openr_host {

// Says whether a reader that is made later receives a sample that was written before.  With
// kGetNewest it receives the newest sample, as with the quality of service "transient local" of ROS
// 2.
enum class LateReaders { kMissSamples, kGetNewest };

// A writer that keeps the newest `depth` samples.  The writer is reliable, so that both reliable
// and best-effort readers can receive its samples.  Writing never waits: a slow reader loses
// samples.
class Ros2Writer {
 public:
  // Makes a writer of the topic `name`, the ROS 2 name without the leading slash, such as
  // "aibo/joint_states".  Throws std::runtime_error.
  Ros2Writer(Bus* bus, const dds_topic_descriptor_t& type, const std::string& name, int depth,
             LateReaders late = LateReaders::kMissSamples);
  ~Ros2Writer();
  Ros2Writer(const Ros2Writer&) = delete;
  Ros2Writer& operator=(const Ros2Writer&) = delete;

  bool HasReaders() const;
  // Writes `sample`.  Does nothing if the topic has no reader now and the writer keeps no sample
  // for later readers (LateReaders::kMissSamples).
  void Write(const void* sample);

 private:
  const LateReaders late_;
  dds_entity_t topic_ = 0;
  dds_entity_t writer_ = 0;
};

// A reliable reader that keeps the newest `depth` samples, counted over all writers together.
class Ros2Reader {
 public:
  Ros2Reader(Bus* bus, const dds_topic_descriptor_t& type, const std::string& name, int depth);
  ~Ros2Reader();
  Ros2Reader(const Ros2Reader&) = delete;
  Ros2Reader& operator=(const Ros2Reader&) = delete;

  // Returns whether there is a best-effort writer of this topic, whose samples this reader cannot
  // receive because it is reliable.
  bool HasIncompatibleWriter() const;

  // Returns the next sample, or null if there is none.  The caller gives the sample back with
  // Return().
  void* Take();
  void Return(void* sample);

 private:
  dds_entity_t topic_ = 0;
  dds_entity_t reader_ = 0;
};

}  // namespace openr_host

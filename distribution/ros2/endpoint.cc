#include "distribution/ros2/endpoint.h"

#include "distribution/dds_check.h"

namespace openr_host {
namespace {

// The quality of service of our ROS 2 writers and readers.  The data representation is set to XCDR
// version 1, because ROS 2 messages are "plain CDR".
class Qos {
 public:
  explicit Qos(int depth, LateReaders late = LateReaders::kMissSamples)
      : qos_(Dds().dds_create_qos()) {
    constexpr dds_data_representation_id_t kPlain[] = {DDS_DATA_REPRESENTATION_XCDR1};
    Dds().dds_qset_reliability(qos_, DDS_RELIABILITY_RELIABLE, 0);
    Dds().dds_qset_history(qos_, DDS_HISTORY_KEEP_LAST, depth);
    Dds().dds_qset_durability(qos_, late == LateReaders::kGetNewest ? DDS_DURABILITY_TRANSIENT_LOCAL
                                                                    : DDS_DURABILITY_VOLATILE);
    Dds().dds_qset_data_representation(qos_, 1, kPlain);
  }
  ~Qos() { Dds().dds_delete_qos(qos_); }
  Qos(const Qos&) = delete;
  Qos& operator=(const Qos&) = delete;
  const dds_qos_t* get() const { return qos_; }

 private:
  dds_qos_t* const qos_;
};

// Returns the name that the ROS 2 topic `name` has on DDS.
std::string OnDds(const std::string& name) { return "rt/" + name; }

dds_entity_t TopicOf(Bus* bus, const dds_topic_descriptor_t& type, const std::string& name) {
  const std::string topic = OnDds(name);
  return Check(Dds().dds_create_topic(bus->participant(), &type, topic.c_str(), nullptr, nullptr),
               "topic " + topic);
}

}  // namespace

Ros2Writer::Ros2Writer(Bus* bus, const dds_topic_descriptor_t& type, const std::string& name,
                       int depth, LateReaders late)
    : late_(late),
      topic_(TopicOf(bus, type, name)),
      writer_(Check(
          Dds().dds_create_writer(bus->participant(), topic_, Qos(depth, late).get(), nullptr),
          "writer of " + name)) {}

Ros2Writer::~Ros2Writer() {
  Dds().dds_delete(writer_);
  Dds().dds_delete(topic_);
}

bool Ros2Writer::HasReaders() const {
  dds_publication_matched_status_t readers;
  return Dds().dds_get_publication_matched_status(writer_, &readers) == DDS_RETCODE_OK &&
         readers.current_count > 0;
}

void Ros2Writer::Write(const void* sample) {
  if (late_ == LateReaders::kMissSamples && !HasReaders()) return;
  // Ignores a failed write, because the run must not depend on readers.  Readers miss this sample,
  // for instance when they are so slow that Cyclone DDS has no room for it.
  static_cast<void>(Dds().dds_write(writer_, sample));
}

Ros2Reader::Ros2Reader(Bus* bus, const dds_topic_descriptor_t& type, const std::string& name,
                       int depth)
    : topic_(TopicOf(bus, type, name)),
      reader_(Check(Dds().dds_create_reader(bus->participant(), topic_, Qos(depth).get(), nullptr),
                    "reader of " + name)) {}

Ros2Reader::~Ros2Reader() {
  Dds().dds_delete(reader_);
  Dds().dds_delete(topic_);
}

bool Ros2Reader::HasIncompatibleWriter() const {
  dds_requested_incompatible_qos_status_t status;
  return Dds().dds_get_requested_incompatible_qos_status(reader_, &status) == DDS_RETCODE_OK &&
         status.total_count > 0;
}

void* Ros2Reader::Take() {
  for (;;) {
    void* sample = nullptr;
    dds_sample_info_t info;
    if (Dds().dds_take(reader_, &sample, &info, 1, 1) <= 0) return nullptr;
    // Skips a sample without valid data, because it only says that a writer no longer exists.
    if (info.valid_data) return sample;
    Return(sample);
  }
}

void Ros2Reader::Return(void* sample) { Dds().dds_return_loan(reader_, &sample, 1); }

}  // namespace openr_host

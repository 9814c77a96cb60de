#include "distribution/bus.h"

#include <dds/dds.h>
#include <fmt/format.h>
#include <signal.h>

#include <stdexcept>

namespace openr_host {
namespace {

// Signals of the program are for its own thread, not for those of the library.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

dds_entity_t Check(dds_entity_t result, const char* what) {
  if (result >= 0) return result;
  throw std::runtime_error(fmt::format("Cyclone DDS: {}: {}", what, dds_strretcode(-result)));
}

std::string Settings(const BusOptions& options) {
  std::string peers = fmt::format("<Peer address=\"{}\"/>", options.address);
  for (const std::string& peer : options.peers)
    peers += fmt::format("<Peer address=\"{}\"/>", peer);
  std::string text = fmt::format(
      "<CycloneDDS><Domain id=\"any\">"
      "<General><Interfaces><NetworkInterface address=\"{}\"/></Interfaces>"
      "<AllowMulticast>false</AllowMulticast><MaxMessageSize>65500B</MaxMessageSize></General>"
      "<Discovery><LeaseDuration>{}s</LeaseDuration><ParticipantIndex>auto</ParticipantIndex>"
      "<MaxAutoParticipantIndex>{}</MaxAutoParticipantIndex><Peers>{}</Peers></Discovery>"
      "<Internal><SocketReceiveBufferSize min=\"default\" max=\"10MB\"/></Internal>"
      "</Domain></CycloneDDS>",
      options.address, options.lease_s, options.participants_max, peers);
  if (!options.config_file.empty()) text += ",file://" + options.config_file;
  return text;
}

// Reliable, in order, nothing thrown away; in the partition of run and process.
dds_qos_t* QosOf(const std::string& partition) {
  dds_qos_t* const qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(10));
  dds_qset_history(qos, DDS_HISTORY_KEEP_ALL, 0);
  const char* names[] = {partition.c_str()};
  dds_qset_partition(qos, 1, names);
  return qos;
}

}  // namespace

Bus::Bus(const BusOptions& options) : run_(options.run) {
  const SignalsBlocked blocked;
  const auto domain = static_cast<dds_domainid_t>(options.domain);
  domain_ = Check(dds_create_domain(domain, Settings(options).c_str()), "domain");
  participant_ = dds_create_participant(domain, nullptr, nullptr);
  if (participant_ < 0) dds_delete(domain_);
  Check(participant_, "participant");
  waitset_ = Check(dds_create_waitset(participant_), "wait set");
}

void Bus::Wait(int64_t timeout_us) {
  dds_waitset_wait(waitset_, nullptr, 0, DDS_USECS(timeout_us));
}

Bus::~Bus() { dds_delete(domain_); }

LineBase::LineBase(Bus* bus, const std::string& process, LineEnd end, const LineTopics& topics) {
  const SignalsBlocked blocked;
  const bool is_master = end == LineEnd::kMaster;
  const dds_entity_t participant = bus->participant();
  const dds_entity_t down = Check(
      dds_create_topic(participant, topics.down, topics.down_name, nullptr, nullptr), "topic");
  const dds_entity_t up =
      Check(dds_create_topic(participant, topics.up, topics.up_name, nullptr, nullptr), "topic");
  dds_qos_t* const qos = QosOf(bus->run() + "/" + process);
  const dds_entity_t publisher = dds_create_publisher(participant, qos, nullptr);
  const dds_entity_t subscriber = dds_create_subscriber(participant, qos, nullptr);
  writer_ = dds_create_writer(publisher, is_master ? down : up, qos, nullptr);
  reader_ = dds_create_reader(subscriber, is_master ? up : down, qos, nullptr);
  dds_delete_qos(qos);
  Check(writer_, "writer");
  Check(reader_, "reader");
  waitset_ = Check(dds_create_waitset(participant), "wait set");
  const dds_entity_t condition = dds_create_readcondition(reader_, DDS_ANY_STATE);
  Check(condition, "read condition");
  Check(dds_waitset_attach(waitset_, condition, 0), "wait set");
  Check(dds_waitset_attach(bus->waitset(), condition, 0), "wait set");
}

LineBase::~LineBase() {
  dds_delete(waitset_);
  dds_delete(reader_);
  dds_delete(writer_);
}

bool LineBase::IsConnected() const {
  dds_publication_matched_status_t readers;
  dds_subscription_matched_status_t writers;
  return dds_get_publication_matched_status(writer_, &readers) == DDS_RETCODE_OK &&
         dds_get_subscription_matched_status(reader_, &writers) == DDS_RETCODE_OK &&
         readers.current_count > 0 && writers.current_count > 0;
}

void LineBase::Write(const void* sample) { Check(dds_write(writer_, sample), "write"); }

void* LineBase::Take(int timeout_ms) {
  for (;;) {
    void* sample = nullptr;
    dds_sample_info_t info;
    const int count = Check(dds_take(reader_, &sample, &info, 1, 1), "take");
    if (count == 1 && info.valid_data) return sample;
    if (count == 1) {
      Return(sample);
      continue;
    }
    if (dds_waitset_wait(waitset_, nullptr, 0, DDS_MSECS(timeout_ms)) <= 0) return nullptr;
  }
}

void LineBase::Return(void* sample) { dds_return_loan(reader_, &sample, 1); }

}  // namespace openr_host

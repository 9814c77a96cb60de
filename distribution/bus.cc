#include "distribution/bus.h"

#include <dds/ddsrt/log.h>
#include <fmt/format.h>
#include <malloc.h>
#include <signal.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "distribution/dds_check.h"
#include "runtime/base/assert.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

// Limit of samples that are sent in one packet and received in one call.  With a larger limit, a
// packet would be sent later, and the receiver would be idle while the sender still produces the
// samples of the packet.
constexpr int kSamplesPerPacketMax = 4;
// Thresholds of malloc() that KeepFreedMemory() sets, so that new samples reuse freed memory.
// malloc() keeps up to 64 MB of freed memory in its heap, and takes blocks below 4 MB from this
// heap.
constexpr int kTrimThresholdBytes = 64 << 20;
constexpr int kMmapThresholdBytes = 4 << 20;

// Settings that make Cyclone DDS keep many sent samples (its history).  A run has at most one
// message for each object in transit, and the history has room for more samples, so no write
// blocks.  A sample stays in the history until all readers have acknowledged it.  With these
// settings Cyclone DDS asks for acknowledgements only in its periodic heartbeat, so we make the
// heartbeat frequent.
constexpr char kLargeHistory[] =
    "<Watermarks><WhcHigh>500MB</WhcHigh><WhcHighInit>500MB</WhcHighInit>"
    "<WhcAdaptive>false</WhcAdaptive></Watermarks>"
    "<HeartbeatInterval min=\"2ms\" minsched=\"5ms\">6ms</HeartbeatInterval>";

// Blocks all signals of this thread while an object of this class exists.  The threads of Cyclone
// DDS are created during this time and inherit the blocked signals.  So signals to the program are
// handled by the program's own thread.
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

// Keeps freed memory in the process.  Camera images are large samples, and each image can reuse the
// memory of the image before.  If that memory went back to the kernel, the kernel would have to
// fill new pages with zeros for each sample.
void KeepFreedMemory() {
  mallopt(M_TRIM_THRESHOLD, kTrimThresholdBytes);
  mallopt(M_MMAP_THRESHOLD, kMmapThresholdBytes);
}

// Prints a message of Cyclone DDS.  Messages about a failed send (conn_write) are printed only
// once.  Otherwise an address that cannot be reached would cause a message with every packet.
void Log(void*, const dds_log_data_t* data) {
  static std::atomic<bool> told = false;
  std::string_view text(data->message, data->size);
  while (text.ends_with('\n')) text.remove_suffix(1);
  if (text.find("conn_write") != std::string_view::npos && told.exchange(true)) return;
  fmt::print(stderr, "openr: Cyclone DDS: {}\n", TerminalText(std::string(text)));
}

// Returns the lease: the seconds without a sign of life after which other processes take this
// process for dead.
int LeaseOf(const BusOptions& options) { return options.lease_s == 0 ? kLease_s : options.lease_s; }

// Returns the settings of Cyclone DDS for `options`, as XML text.
std::string SettingsXml(const BusOptions& options) {
  std::string peers = fmt::format("<Peer address=\"{}\"/>", options.address);
  for (const std::string& peer : options.peers)
    peers += fmt::format("<Peer address=\"{}\"/>", peer);
  std::string text = fmt::format(
      "<CycloneDDS><Domain id=\"any\">"
      "<General><Interfaces><NetworkInterface address=\"{}\"/></Interfaces>"
      "<AllowMulticast>false</AllowMulticast><MaxMessageSize>65500B</MaxMessageSize></General>"
      "<Discovery><LeaseDuration>{}s</LeaseDuration><ParticipantIndex>auto</ParticipantIndex>"
      "<MaxAutoParticipantIndex>{}</MaxAutoParticipantIndex><Peers>{}</Peers></Discovery>"
      "<Internal><SocketReceiveBufferSize min=\"default\" max=\"10MB\"/>"
      "<WriterLingerDuration>0s</WriterLingerDuration><MaxSampleSize>{}MB</MaxSampleSize>"
      "{}"
      "</Internal>"
      "</Domain></CycloneDDS>",
      options.address, LeaseOf(options), options.participants_max, peers, kSampleMax_MB,
      options.has_large_history ? kLargeHistory : "");
  if (!options.config_file.empty()) text += ",file://" + options.config_file;
  return text;
}

// Returns the quality of service of all channels: reliable, in order, and without replacing old
// samples by newer ones, because a run must not lose a message.  A write that is blocked for 10 s
// fails.
dds_qos_t* ChannelQos(const std::string& partition) {
  dds_qos_t* const qos = Dds().dds_create_qos();
  Dds().dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(10));
  Dds().dds_qset_history(qos, DDS_HISTORY_KEEP_ALL, 0);
  const char* names[] = {partition.c_str()};
  Dds().dds_qset_partition(qos, 1, names);
  return qos;
}

}  // namespace

Bus::Bus(const BusOptions& options) : run_(options.run), number_(options.domain) {
  const SignalsBlocked blocked;
  KeepFreedMemory();
  Dds().dds_set_log_sink(&Log, nullptr);
  const auto domain = static_cast<dds_domainid_t>(options.domain);
  domain_ = Check(Dds().dds_create_domain(domain, SettingsXml(options).c_str()), "domain");
  participant_ = Dds().dds_create_participant(domain, nullptr, nullptr);
  // Deletes the domain of DDS before Check() throws, because the destructor does not run when the
  // constructor throws.
  if (participant_ < 0) Dds().dds_delete(domain_);
  Check(participant_, "participant");
  waitset_ = Check(Dds().dds_create_waitset(participant_), "wait set");
  AnnounceLiveliness(LeaseOf(options));
}

// Makes this participant announce itself at least five times within its lease.  Then a short
// network failure does not make other processes take this process for dead.
//
// Cyclone DDS by itself announces a participant only when four fifths of its lease are over.  With
// a lease of 10 s, a network failure in the last 2 s could lose the only announcement.  A writer
// with a shorter liveliness lease makes its participant announce itself more often.  So we create
// such a writer, whose lease is a fifth of `lease_s`, on a topic that nobody reads.  A still
// shorter lease would cause more announcements, and every participant has to receive each of them.
void Bus::AnnounceLiveliness(int lease_s) {
  dds_qos_t* const qos = Dds().dds_create_qos();
  Dds().dds_qset_liveliness(qos, DDS_LIVELINESS_AUTOMATIC, DDS_MSECS(lease_s * 200));
  const dds_entity_t topic = Dds().dds_create_topic(participant_, &openr_wire_ToMaster_desc,
                                                    "openr_alive", nullptr, nullptr);
  const dds_entity_t writer =
      Dds().dds_create_writer(participant_, Check(topic, "topic"), qos, nullptr);
  Dds().dds_delete_qos(qos);
  Check(writer, "writer");
}

void Bus::Wait(int64_t timeout_us) {
  Dds().dds_waitset_wait(waitset_, nullptr, 0, DDS_USECS(timeout_us));
}

// Deletes the domain, and with it the participant and all other DDS entities of this process.
Bus::~Bus() { Dds().dds_delete(domain_); }

ChannelBase::ChannelBase(Bus* bus, const std::string& place, ChannelEnd end,
                         const ChannelTopics& topics)
    : type_(end == ChannelEnd::kMaster ? topics.to_master : topics.to_worker) {
  const SignalsBlocked blocked;
  const bool is_master = end == ChannelEnd::kMaster;
  const dds_entity_t participant = bus->participant();
  const auto topic = [&](const dds_topic_descriptor_t* type, const char* name) {
    owned_.push_back(
        Check(Dds().dds_create_topic(participant, type, name, nullptr, nullptr), "topic"));
    return owned_.back();
  };
  const dds_entity_t to_worker = topic(topics.to_worker, topics.to_worker_name);
  const dds_entity_t to_master = topic(topics.to_master, topics.to_master_name);
  dds_qos_t* const qos = ChannelQos(bus->run() + "/" + place);
  const dds_entity_t publisher = Dds().dds_create_publisher(participant, qos, nullptr);
  const dds_entity_t subscriber = Dds().dds_create_subscriber(participant, qos, nullptr);
  owned_.insert(owned_.end(), {publisher, subscriber});
  // Makes all writers that are created from now on collect samples into batches, because
  // WriteBatched() needs such writers.
  Dds().dds_write_set_batch(true);
  writer_ = Dds().dds_create_writer(publisher, is_master ? to_worker : to_master, qos, nullptr);
  Dds().dds_write_set_batch(false);
  reader_ = Dds().dds_create_reader(subscriber, is_master ? to_master : to_worker, qos, nullptr);
  Dds().dds_delete_qos(qos);
  Check(writer_, "writer");
  Check(reader_, "reader");
  waitset_ = Check(Dds().dds_create_waitset(participant), "wait set");
  owned_.push_back(waitset_);
  const dds_entity_t condition = Dds().dds_create_readcondition(reader_, DDS_ANY_STATE);
  Check(condition, "read condition");
  Check(Dds().dds_waitset_attach(waitset_, condition, 0), "wait set");
  Check(Dds().dds_waitset_attach(bus->waitset(), condition, 0), "wait set");
}

ChannelBase::~ChannelBase() {
  for (void* const sample : received_) Dds().dds_sample_free(sample, type_, DDS_FREE_ALL);
  for (void* const sample : free_samples_) Dds().dds_sample_free(sample, type_, DDS_FREE_ALL);
  // Deletes the entities (objects of DDS) in the reverse order of their creation, because an entity
  // uses entities that were created before it.
  for (auto entity = owned_.rbegin(); entity != owned_.rend(); ++entity) Dds().dds_delete(*entity);
}

bool ChannelBase::IsConnected() const {
  dds_publication_matched_status_t readers;
  dds_subscription_matched_status_t writers;
  // Tests both directions of the channel, because DDS finds the reader and the writer of the other
  // end separately, and a sample that is sent before the reader is found is lost.
  return Dds().dds_get_publication_matched_status(writer_, &readers) == DDS_RETCODE_OK &&
         Dds().dds_get_subscription_matched_status(reader_, &writers) == DDS_RETCODE_OK &&
         readers.current_count > 0 && writers.current_count > 0;
}

bool ChannelBase::WaitForAcks(int timeout_ms) {
  // Returns true also after an error other than a timeout, so that the caller does not wait again.
  // A second wait would fail at once with the same error.
  return Dds().dds_wait_for_acks(writer_, DDS_MSECS(timeout_ms)) != DDS_RETCODE_TIMEOUT;
}

void ChannelBase::WriteBatched(const void* sample) {
  Check(Dds().dds_write(writer_, sample), "write");
  if (++batched_count_ == kSamplesPerPacketMax) FlushBatch();
  ASSERT(batched_count_ >= 0 && batched_count_ < kSamplesPerPacketMax, "{}", batched_count_);
}

void ChannelBase::Write(const void* sample) {
  WriteBatched(sample);
  FlushBatch();
}

void ChannelBase::FlushBatch() {
  if (batched_count_ == 0) return;
  batched_count_ = 0;
  Dds().dds_write_flush(writer_);
}

void* ChannelBase::ReceiveUntyped(int timeout_ms) {
  for (;;) {
    if (!has_received()) ReceiveMore();
    if (has_received()) {
      void* const sample = received_.front();
      received_.pop_front();
      return sample;
    }
    // Sends the samples that SendBatched() has kept, because this end of the channel waits now, and
    // the other end may be waiting for these samples.
    FlushBatch();
    if (timeout_ms == 0) return nullptr;
    if (Dds().dds_waitset_wait(waitset_, nullptr, 0, DDS_MSECS(timeout_ms)) <= 0) return nullptr;
  }
}

void ChannelBase::ReceiveMore() {
  while (free_samples_.size() < kSamplesPerPacketMax) {
    free_samples_.push_back(Dds().dds_alloc(type_->m_size));
    std::memset(free_samples_.back(), 0, type_->m_size);
  }
  void* samples[kSamplesPerPacketMax];
  dds_sample_info_t infos[kSamplesPerPacketMax];
  std::copy_n(free_samples_.rbegin(), kSamplesPerPacketMax, samples);
  // Receives only one sample after a large sample (kBulkBytes), because the next sample is probably
  // large, too.  Large samples are received one at a time, so that each sample reuses memory that
  // is still in the processor's cache.
  const uint32_t wanted = last_bulk_bytes_ < kBulkBytes ? kSamplesPerPacketMax : 1;
  const int count =
      Check(Dds().dds_take(reader_, samples, infos, kSamplesPerPacketMax, wanted), "take");
  free_samples_.resize(free_samples_.size() - static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) {
    // A sample without valid data only says that a writer no longer exists.  We do not need this
    // information, so we give the sample back to DDS.
    if (infos[i].valid_data) {
      received_.push_back(samples[i]);
    } else {
      Return(samples[i]);
    }
  }
}

void ChannelBase::Return(void* sample) {
  ASSERT(sample != nullptr);
  Dds().dds_sample_free(sample, type_, DDS_FREE_CONTENTS);
  std::memset(sample, 0, type_->m_size);
  free_samples_.push_back(sample);
}

}  // namespace openr_host

// Sets up Cyclone DDS and sends samples over it.
//
// Each process of a distributed run has one DDS participant.  The master exchanges samples with
// each worker over a Channel.  A Channel consists of two topics in a DDS partition named
// RUN/PROCESS/SESSION; its samples arrive in order, and none is lost.  Each start of a worker gets
// a new SESSION name.  Participants find each other without multicast, at addresses given to them.
// The default address is 127.0.0.1, at which only processes of this host find each other.
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "distribution/wire.h"

namespace openr_host {

// Lease of a process: the time without a sign of life after which other processes take the process
// for dead.
//
// kWatchedLease_s is for workers that the master has started and will not restart.  The master sees
// at once when such a worker ends, so a short lease is not needed.  A worker that a debugger has
// stopped must not be taken for dead, so we use the longest lease that Cyclone DDS accepts.
//
// kReturningLease_s is for workers that the master has started and may restart.  Until the lease of
// a killed process is over, every participant of the domain takes the process for a slow reader and
// keeps data for it.  That makes each restart slower, so this lease is shorter.
//
// kLease_s is for all other processes.
constexpr int kWatchedLease_s = 3600;
constexpr int kReturningLease_s = 60;
constexpr int kLease_s = 10;

struct BusOptions {
  std::string run;                    // name of the run, the first part of every partition name
  int domain = 0;                     // number of the DDS domain
  std::string address = "127.0.0.1";  // address of this host's network interface
  std::vector<std::string> peers;     // addresses of other hosts with processes of the run
  // Path of a file with additional settings of Cyclone DDS, such as DDS Security; "" if none.
  std::string config_file;
  int participants_max = 120;  // largest number of processes on one host
  // Lease of this process in seconds, such as kWatchedLease_s; 0 means kLease_s.
  int lease_s = 0;
  // If true, Cyclone DDS keeps many sent samples, so that a write does not block while a receiving
  // process is stopped.
  bool has_large_history = false;
};

class Bus {
 public:
  // Creates the participant of this process.  Throws std::runtime_error with the message of Cyclone
  // DDS.
  explicit Bus(const BusOptions& options);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  // Waits until a Channel or a StatusReader of this bus has a sample, at most `timeout_us`.
  void Wait(int64_t timeout_us);

  dds_entity_t participant() const { return participant_; }
  dds_entity_t waitset() const { return waitset_; }
  const std::string& run() const { return run_; }
  int domain() const { return number_; }

 private:
  void AnnounceLiveliness(int lease_s);

  const std::string run_;
  const int number_;  // number of the DDS domain
  dds_entity_t domain_ = 0;
  dds_entity_t participant_ = 0;
  dds_entity_t waitset_ = 0;  // DDS wait set; Wait() returns when an attached reader has a sample
};

// The two ends of a Channel: the master uses kMaster, the worker kWorker.
enum class ChannelEnd { kMaster, kWorker };

// The types and names of the two topics of a Channel.
struct ChannelTopics {
  const dds_topic_descriptor_t* to_worker;
  const char* to_worker_name;
  const dds_topic_descriptor_t* to_master;
  const char* to_master_name;
};
constexpr ChannelTopics kRunTopics = {&openr_wire_ToWorker_desc, "openr_to_worker",
                                      &openr_wire_ToMaster_desc, "openr_to_master"};

// Limit of the size of a sample, in MB.  Send() throws for a larger sample, because Cyclone DDS
// refuses such a sample (MaxSampleSize).
constexpr size_t kSampleMax_MB = 64;

// A sample with this many bytes of data of shared memory regions, or more, is large.  Large samples
// are sent in packets of their own and received one at a time.  Each sample then reuses memory that
// is still in the processor's cache.
constexpr size_t kBulkBytes = 16 << 10;

// The part of Channel that does not depend on its sample types.
class ChannelBase {
 public:
  // Opens one end of a channel.  `place` is the last part of the partition name: PROCESS/SESSION,
  // or only PROCESS for join requests.
  ChannelBase(Bus* bus, const std::string& place, ChannelEnd end,
              const ChannelTopics& topics = kRunTopics);
  ~ChannelBase();
  ChannelBase(const ChannelBase&) = delete;
  ChannelBase& operator=(const ChannelBase&) = delete;

  // Returns whether DDS has found the reader and the writer of the channel's other end.
  bool IsConnected() const;

  // Waits until the other end has received all samples, at most `timeout_ms`.  Returns false if the
  // other end still lacks samples after this time.  The destructor of the channel loses all samples
  // that the other end has not received, so call this function before the destructor if no sample
  // may be lost.
  bool WaitForAcks(int timeout_ms);

  // Sends the samples that SendBatched() has kept.
  void FlushBatch();

  // Returns whether the next sample has already been read from DDS.  If so, Receive() returns this
  // sample without a call of DDS.
  bool has_received() const { return !received_.empty(); }

 protected:
  // Sends `sample` now, together with the samples that WriteBatched() has kept.
  void Write(const void* sample);
  void WriteBatched(const void* sample);
  // Returns the next sample of the other end, or null if no sample came within `timeout_ms`.  The
  // caller gives the sample back with Return().
  void* ReceiveUntyped(int timeout_ms);
  void Return(void* sample);
  // Records how many bytes of memory regions the last received sample had.  After a large sample
  // (kBulkBytes), the next sample is received alone.
  void set_last_bulk_bytes(size_t bytes) { last_bulk_bytes_ = bytes; }

 private:
  void ReceiveMore();

  const dds_topic_descriptor_t* const type_;  // type of the incoming samples
  dds_entity_t writer_ = 0;
  dds_entity_t reader_ = 0;
  dds_entity_t waitset_ = 0;
  // The topics, the publisher, the subscriber and the wait set.  They are deleted with the channel.
  std::vector<dds_entity_t> owned_;
  int batched_count_ = 0;
  size_t last_bulk_bytes_ = 0;
  std::deque<void*> received_;
  std::vector<void*> free_samples_;  // memory for the next samples to receive
};

template <typename Out, typename In>
class Channel : public ChannelBase {
 public:
  using ChannelBase::ChannelBase;

  void Send(const Out& sample) { Write(&sample); }
  // Keeps `sample`, to send it together with the next samples in one packet.  A sample of
  // kBulkBytes or more is sent at once.  The kept samples are sent at the latest when Receive()
  // finds no sample.
  void SendBatched(const Out& sample) {
    BulkBytesOf(sample) < kBulkBytes ? WriteBatched(&sample) : Write(&sample);
  }

  // A sample received from the other end.  The destructor gives its memory back to the channel.
  class ReceivedSample {
   public:
    ReceivedSample(Channel* channel, In* sample) : channel_(channel), sample_(sample) {}
    ReceivedSample(ReceivedSample&& other) noexcept
        : channel_(other.channel_), sample_(std::exchange(other.sample_, nullptr)) {}
    ReceivedSample& operator=(ReceivedSample&&) = delete;
    ~ReceivedSample() {
      if (sample_ != nullptr) channel_->Return(sample_);
    }
    explicit operator bool() const { return sample_ != nullptr; }
    const In& operator*() const { return *sample_; }
    const In* operator->() const { return sample_; }

   private:
    Channel* const channel_;
    In* sample_;
  };

  ReceivedSample Receive(int timeout_ms) {
    auto* const sample = static_cast<In*>(ReceiveUntyped(timeout_ms));
    if (sample != nullptr) set_last_bulk_bytes(BulkBytesOf(*sample));
    return ReceivedSample(this, sample);
  }
};

using MasterChannel = Channel<openr_wire_ToWorker, openr_wire_ToMaster>;
using WorkerChannel = Channel<openr_wire_ToMaster, openr_wire_ToWorker>;

}  // namespace openr_host

// The only place where Cyclone DDS is set up and spoken to.
//
// A process that takes part in a distributed run has one participant.  Master and process talk over
// a Channel of their own: two topics in a partition with the names of run, process and session,
// reliable, nothing thrown away.  Participants find each other at addresses that were given to
// them, without multicast; the default is this machine alone (127.0.0.1).
#pragma once

#include <dds/dds.h>

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

#include "distribution/wire.h"

namespace openr_host {

// The lease of processes whose end somebody sees: stopped or in a debugger they are not gone.  The
// most there is.  If they may come back often: until its lease is over every participant of the
// domain takes one that was killed for a reader that is slow, and keeps for it what it announces.
// And of others.
constexpr int kWatchedLease_s = 3600;
constexpr int kReturningLease_s = 60;
constexpr int kLease_s = 10;

struct BusOptions {
  std::string run;                    // name of the run, the first part of partitions
  int domain = 0;                     // DDS domain
  std::string address = "127.0.0.1";  // of this host's network interface
  std::vector<std::string> peers;     // addresses of other hosts; this one's is known
  std::string config_file;            // settings of Cyclone DDS that are added (security)
  int participants_max = 120;         // on one host
  // After this long without a sign of life from a process, others hold it for gone; 0: as suits
  // the run.
  int lease_s = 0;
  bool has_large_history = false;  // nobody waits who writes to a process that is stopped
};

class Bus {
 public:
  // Throws std::runtime_error that says what Cyclone DDS says.
  explicit Bus(const BusOptions& options);
  ~Bus();
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  // Waits until a Channel of this bus has something to take, at most `timeout_us`.
  void Wait(int64_t timeout_us);

  dds_entity_t participant() const { return participant_; }
  dds_entity_t waitset() const { return waitset_; }
  const std::string& run() const { return run_; }
  int domain() const { return number_; }

 private:
  void AnnounceLiveliness(int lease_s);

  const std::string run_;
  const int number_;  // of the domain
  dds_entity_t domain_ = 0;
  dds_entity_t participant_ = 0;
  dds_entity_t waitset_ = 0;  // of all lines
};

// One direction of a Channel.
enum class ChannelEnd { kMaster, kWorker };

// What the two directions carry.
struct ChannelTopics {
  const dds_topic_descriptor_t* to_worker;
  const char* to_worker_name;
  const dds_topic_descriptor_t* to_master;
  const char* to_master_name;
};
constexpr ChannelTopics kRunTopics = {&openr_wire_ToWorker_desc, "openr_to_worker",
                                      &openr_wire_ToMaster_desc, "openr_to_master"};

// A sample is refused that is larger.
constexpr size_t kSampleMax_MB = 64;

// Samples with so many bytes have packets of their own and are taken one at a time: the next one
// finds the same memory in the processor's cache.
constexpr size_t kBulkBytes = 16 << 10;

// Untyped half of Channel.
class ChannelBase {
 public:
  // `place`: of the process or its session.
  ChannelBase(Bus* bus, const std::string& place, ChannelEnd end,
              const ChannelTopics& topics = kRunTopics);
  ~ChannelBase();
  ChannelBase(const ChannelBase&) = delete;
  ChannelBase& operator=(const ChannelBase&) = delete;

  // Whether the other end is there.
  bool IsConnected() const;

  // Waits until the other end has all that was sent, which is lost with the line otherwise.
  void WaitForAcks(int timeout_ms);

  // Now what SendBatched() has kept.
  void FlushBatch();

  // Whether the next sample has been taken from DDS already.
  bool has_received() const { return !received_.empty(); }

 protected:
  void Write(const void* sample);
  void WriteBatched(const void* sample);
  // The next sample, to be given to Return(); null when none came within `timeout_ms`.
  void* ReceiveUntyped(int timeout_ms);
  void Return(void* sample);
  // Bytes of the data of regions in the sample that was taken last.
  void set_last_bulk_bytes(size_t bytes) { last_bulk_bytes_ = bytes; }

 private:
  void ReceiveMore();

  const dds_topic_descriptor_t* const type_;  // of what comes in
  dds_entity_t writer_ = 0;
  dds_entity_t reader_ = 0;
  dds_entity_t waitset_ = 0;
  std::vector<dds_entity_t> owned_;  // with all that belongs to them
  int batched_count_ = 0;
  size_t last_bulk_bytes_ = 0;
  std::deque<void*> received_;
  std::vector<void*> free_samples_;  // samples to take into
};

template <typename Out, typename In>
class Channel : public ChannelBase {
 public:
  using ChannelBase::ChannelBase;

  void Send(const Out& sample) { Write(&sample); }
  // In one packet with what is sent next, unless it fills one: when this end finds nothing to take,
  // at the latest.
  void SendBatched(const Out& sample) {
    BulkBytesOf(sample) < kBulkBytes ? WriteBatched(&sample) : Write(&sample);
  }

  // A sample on loan.
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

#include "distribution/name_claim.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <utility>
#include <vector>

#include "distribution/dds_check.h"
#include "distribution/process_slot.h"

namespace openr_host {
namespace {

// Name of the DDS topic of name claims.  No sample is ever sent on this topic, because a claim is
// in the user data of a writer.
constexpr char kClaimTopic[] = "openr_run";
// Number of digits of the time in a claim.  The time is in nanoseconds since 1970 and has leading
// zeros, so that comparing two claims as texts compares their times.
constexpr size_t kSinceDigits = 20;
constexpr size_t kClaimsMax = 64;  // largest number of claims that are compared

// Makes a claim "TIME pid PID on HOST".  Of two runs with the same name, the run with the earlier
// claim keeps the name.  Both runs compare the same two texts, so they agree on which run gives
// way, even if the clocks of their hosts differ.
std::string NewClaim() {
  const auto since =
      std::chrono::system_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
  return fmt::format("{:0{}} pid {} on {}", since, kSinceDigits, getpid(), HostName());
}

// Returns the quality of service for claims.  The partition has the run's name, so only runs of the
// same name see the claim.  This process does not see its own claims.
dds_qos_t* ClaimQos(const Bus& bus) {
  dds_qos_t* const qos = Dds().dds_create_qos();
  Dds().dds_qset_ignorelocal(qos, DDS_IGNORELOCAL_PARTICIPANT);
  const char* names[] = {bus.run().c_str()};
  Dds().dds_qset_partition(qos, 1, names);
  return qos;
}

// Returns the claim that another run has put into the user data of its `writer`; "" if the writer
// has no claim.
std::string ClaimOf(dds_entity_t reader, dds_instance_handle_t writer) {
  dds_builtintopic_endpoint_t* const endpoint =
      Dds().dds_get_matched_publication_data(reader, writer);
  if (endpoint == nullptr) return "";
  void* data = nullptr;
  size_t size = 0;
  std::string claim;
  if (Dds().dds_qget_userdata(endpoint->qos, &data, &size) && data != nullptr)
    claim.assign(static_cast<const char*>(data), size);
  Dds().dds_free(data);
  Dds().dds_builtintopic_free_endpoint(endpoint);
  return claim;
}

}  // namespace

NameClaim::NameClaim(Bus* bus) : bus_(bus), own_(NewClaim()) {
  topic_ = Dds().dds_create_topic(bus->participant(), &openr_wire_JoinRequest_desc, kClaimTopic,
                                  nullptr, nullptr);
  Check(topic_, kClaimTopic);
  dds_qos_t* const qos = ClaimQos(*bus);
  const dds_entity_t subscriber = Dds().dds_create_subscriber(bus->participant(), qos, nullptr);
  reader_ = Dds().dds_create_reader(subscriber, topic_, qos, nullptr);
  Dds().dds_delete_qos(qos);
  Check(reader_, kClaimTopic);
  Announce(own_);
}

// Announces a claim: creates a writer with the claim as its user data, which DDS sends to all
// participants, so no sample is needed.  A run announces its claim when it begins.  When a worker
// has joined, the run must keep its name, so it announces a second claim with an earlier time
// (MakePermanent()).  The first claim stays announced, which does no harm, because only the claim
// with the earliest time counts.
void NameClaim::Announce(const std::string& claim) {
  dds_qos_t* const qos = ClaimQos(*bus_);
  Dds().dds_qset_userdata(qos, claim.data(), claim.size());
  const dds_entity_t publisher = Dds().dds_create_publisher(bus_->participant(), qos, nullptr);
  const dds_entity_t writer = Dds().dds_create_writer(publisher, topic_, qos, nullptr);
  Dds().dds_delete_qos(qos);
  Check(writer, kClaimTopic);
}

void NameClaim::MakePermanent() {
  if (std::exchange(is_permanent_, true)) return;
  // Announces a second claim of this run, whose time consists of zeros and so is earlier than every
  // real time.  The earliest claim wins, so from now on this run wins against every run that has
  // only a claim with a real time.
  Announce(std::string(kSinceDigits, '0') + own_.substr(kSinceDigits));
}

std::string NameClaim::EarlierRun() const {
  if (is_permanent_) return "";
  std::vector<dds_instance_handle_t> writers(kClaimsMax);
  const dds_return_t count =
      Dds().dds_get_matched_publications(reader_, writers.data(), writers.size());
  for (size_t i = 0; i < writers.size() && static_cast<dds_return_t>(i) < count; ++i) {
    const std::string claim = ClaimOf(reader_, writers[i]);
    if (claim.size() > kSinceDigits && claim < own_) return claim.substr(kSinceDigits + 1);
  }
  return "";
}

}  // namespace openr_host

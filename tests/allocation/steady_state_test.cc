// Messages that objects send each other again and again allocate no memory.
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/code_object.h"
#include "runtime/core/system.h"
#include "tests/allocation/counted_allocations.h"

namespace openr_host {
namespace {

constexpr int kRegions = 3;
constexpr uint64_t kWarmUp = 1'000;
constexpr uint64_t kCounted = 10'000;

// How a Talker gives its data to the subject.
enum class Data { kOneRegion, kRegionsInTurn, kBytes };

// Answers every ready with a notification.
class Talker : public CodeObject {
 public:
  Talker(const std::string& name, Data data) : data_(data) {
    out_ = AddSubject(name + ".Out.Data.S", [this](const OReadyEvent& event) {
      if (event.IsAssert()) Send();
    });
    for (RCRegion*& region : regions_) region = new RCRegion(32);
  }

 private:
  void Send() {
    ++sent_;
    if (data_ == Data::kBytes) {
      out_->SetData(&sent_, sizeof sent_);
    } else {
      out_->SetData(regions_[data_ == Data::kOneRegion ? 0 : sent_ % kRegions]);
    }
    out_->NotifyObservers();
  }

  const Data data_;
  uint64_t sent_ = 0;
  OSubject* out_;
  RCRegion* regions_[kRegions];
};

// Answers every notification with a ready.  Keeps the region of the last notification if `keeps`,
// so that each ready gives back the region of the notification before.
class Hearer : public CodeObject {
 public:
  Hearer(const std::string& name, bool keeps) : keeps_(keeps) {
    in_ = AddObserver(name + ".In.Data.O", [this](const ONotifyEvent& event) { Hear(event); });
  }
  void Begin() {
    const CurrentScope scope(&system(), &host());
    in_->AssertReady();
  }

 private:
  void Hear(const ONotifyEvent& event) {
    if (keeps_) {
      if (kept_ != nullptr) kept_->RemoveReference();
      kept_ = event.RCData(0);
      kept_->AddReference();
    }
    in_->AssertReady();
  }

  const bool keeps_;
  OObserver* in_;
  RCRegion* kept_ = nullptr;
};

// Returns how many blocks of memory kCounted messages allocate, after kWarmUp messages in which
// vectors may grow.
int64_t AllocationsOfMessages(Data data, bool keeps, bool hashes, int pairs) {
  SystemOptions options;
  options.free_deliveries = INT64_MAX;
  System system(options);
  system.AddRobot("ERS-210", nullptr);
  system.trace().set_hashing(hashes);
  std::vector<Hearer*> hearers;
  for (int i = 0; i < pairs; ++i) {
    const std::string talker = "Talker" + std::to_string(i);
    const std::string hearer = "Hearer" + std::to_string(i);
    system.AddObject<Talker>(0, talker, talker, data);
    hearers.push_back(system.AddObject<Hearer>(0, hearer, hearer, keeps));
    system.Connect({0, talker + ".Out.Data.S", hearer + ".In.Data.O", "test"});
  }
  system.Boot();
  while (!system.booted()) system.Step();
  for (Hearer* const hearer : hearers) hearer->Begin();
  system.RunMessages(kWarmUp);
  const uint64_t before_messages = system.message_count();
  const int64_t before = AllocationCount();
  system.RunMessages(kCounted);
  const int64_t after = AllocationCount();
  EXPECT_EQ(system.message_count() - before_messages, kCounted);
  return after - before;
}

TEST(SteadyStateTest, TheCounterCountsNewAndMalloc) {
  const int64_t before = AllocationCount();
  const auto number = std::make_unique<volatile int>(1);
  void* volatile const block = std::malloc(100);
  EXPECT_EQ(AllocationCount() - before, 2);
  std::free(block);
}

TEST(SteadyStateTest, NotifyAndReadyAllocateNothing) {
  EXPECT_EQ(AllocationsOfMessages(Data::kOneRegion, false, false, 1), 0);
  EXPECT_EQ(AllocationsOfMessages(Data::kOneRegion, false, false, 20), 0);
}

TEST(SteadyStateTest, TheTraceHashAllocatesNothing) {
  EXPECT_EQ(AllocationsOfMessages(Data::kOneRegion, false, true, 1), 0);
  EXPECT_EQ(AllocationsOfMessages(Data::kRegionsInTurn, false, true, 20), 0);
}

TEST(SteadyStateTest, RegionsThatObserversKeepForAWhileAllocateNothing) {
  EXPECT_EQ(AllocationsOfMessages(Data::kRegionsInTurn, true, false, 1), 0);
  EXPECT_EQ(AllocationsOfMessages(Data::kRegionsInTurn, true, true, 1), 0);
}

// With AddressSanitizer each region is a block of the host's heap, so that the sanitizer sees
// writes beyond the region.  So each new region allocates there, and this test is left out.
#if !defined(__SANITIZE_ADDRESS__)
TEST(SteadyStateTest, ANewRegionForEachNotificationAllocatesNothing) {
  EXPECT_EQ(AllocationsOfMessages(Data::kBytes, false, false, 1), 0);
  EXPECT_EQ(AllocationsOfMessages(Data::kBytes, true, true, 1), 0);
}
#endif

}  // namespace
}  // namespace openr_host

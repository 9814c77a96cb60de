// Tests of OShmPtr, and of regions that a later ready gives back (core.md, 2.8 and 11.17).
#include <OPENR/OShmPtr.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

class ShmPtrTest : public testing::Test {
 protected:
  ShmPtrTest() {
    system.AddRobot("ERS-210", nullptr);
    sender = system.AddObject<SubjectProbe>(0, "sender");
    receiver = system.AddObject<ObserverProbe>(0, "receiver");
    system.Connect({0, "Sender.Out.Number.S", "Receiver.In.Number.O", "test"});
    system.Boot();
    system.RunFor(1000);
  }
  void AssertReady() {
    RunAs(receiver, [&] { receiver->in->AssertReady(); });
    system.RunFor(1000);
  }

  System system;
  SubjectProbe* sender;
  ObserverProbe* receiver;
};

// A program that reads a region which it has given back finds the old content, in every run.
TEST_F(ShmPtrTest, ARegionThatIsGivenBackKeepsItsContent) {
  RunAs(sender, [&] {
    RCRegion* const region = new RCRegion(8);
    RCRegion* volatile gone = region;
    const char* const base = region->Base();
    region->RemoveReference();
    EXPECT_EQ(gone->Base(), base);
  });
}

TEST_F(ShmPtrTest, ARegionWithoutASizeReachesToTheEndOfItsMemory) {
  RunAs(sender, [&] {
    RCRegion* const whole = new RCRegion(8);
    RCRegion* const rest = new RCRegion(whole->MemID(), 2, whole->Base() + 2, 0);
    EXPECT_EQ(rest->Size(), 6u);
    rest->RemoveReference();
    whole->RemoveReference();
  });
}

TEST_F(ShmPtrTest, ARegionWithASizeAndWithoutAnAddressKeepsItsSize) {
  RunAs(sender, [&] {
    RCRegion* const whole = new RCRegion(8);
    RCRegion* const part = new RCRegion(whole->MemID(), 2, nullptr, 3);
    EXPECT_EQ(part->Base(), whole->Base() + 2);
    EXPECT_EQ(part->Size(), 3u);
    part->RemoveReference();
    whole->RemoveReference();
  });
}

TEST_F(ShmPtrTest, ARegionThatBeginsBehindItsMemoryHasNoSize) {
  RunAs(sender, [&] {
    RCRegion* const whole = new RCRegion(8);
    RCRegion* const part = new RCRegion(whole->MemID(), 9, whole->Base(), 0);
    EXPECT_EQ(part->Size(), 0u);
    part->RemoveReference();
    whole->RemoveReference();
  });
}

TEST_F(ShmPtrTest, ARegionOfAnUnknownIdHasNoAddress) {
  RunAs(sender, [&] {
    RCRegion* const region = new RCRegion(MemoryRegionID{0x00ff0ff0}, 2, nullptr, 4);
    EXPECT_EQ(region->Base(), nullptr);
    region->RemoveReference();
  });
}

TEST_F(ShmPtrTest, WritingToASharedOneCopiesFirst) {
  RunAs(sender, [&] {
    OShmPtr<int> one(size_t{3});
    EXPECT_EQ(one.NumOfElement(), 3);
    one[2] = 5;
    OShmPtr<int> two(one);
    EXPECT_EQ(one.RCRPtr(), two.RCRPtr());
    EXPECT_EQ(one.RCRPtr()->NumberOfReference(), 2);
    two[2] = 6;
    EXPECT_NE(one.RCRPtr(), two.RCRPtr());
    const OShmPtr<int>& first = one;
    const OShmPtr<int>& second = two;
    EXPECT_EQ(first[2], 5);
    EXPECT_EQ(second[2], 6);
    int bytes[3] = {7, 8, 9};
    memcpy(two, bytes, sizeof bytes);
    EXPECT_EQ(*second, 7);
    two.Deallocate();
    EXPECT_EQ(two.Base(), nullptr);
  });
}

TEST_F(ShmPtrTest, SetDataTakesOne) {
  AssertReady();
  RunAs(sender, [&] {
    OShmPtr<int> number(size_t{1});
    number[0] = 11;
    EXPECT_EQ(sender->out->SetData(number), oSUCCESS);
    EXPECT_EQ(number.RCRPtr()->NumberOfReference(), 2);
    sender->out->NotifyObservers();
  });
  system.RunFor(1000);
  EXPECT_EQ(receiver->events, std::vector<std::string>{"11"});
}

TEST_F(ShmPtrTest, MoreThan13RegionsComeBackWithTwoReadies) {
  std::vector<RCRegion*> kept;
  receiver->on_notify = [&](const ONotifyEvent& event) {
    for (int i = 0; i < event.NumOfData(); ++i) {
      event.RCData(i)->AddReference();
      kept.push_back(event.RCData(i));
    }
  };
  std::vector<RCRegion*> regions;
  for (int round = 0; round < 2; ++round) {
    AssertReady();
    RunAs(sender, [&] {
      for (int i = 0; i < 8; ++i) {
        regions.push_back(new RCRegion(sizeof(int)));
        sender->out->SetData(regions.back());
      }
      sender->out->NotifyObservers();
    });
    system.RunFor(1000);
  }
  ASSERT_EQ(kept.size(), 16u);
  RunAs(receiver, [&] {
    for (RCRegion* region : kept) region->RemoveReference();
  });
  const auto free_count = [&] {
    return std::count_if(regions.begin(), regions.end(),
                         [](RCRegion* region) { return region->NumberOfReference() == 1; });
  };
  EXPECT_EQ(free_count(), 0);
  AssertReady();
  EXPECT_EQ(free_count(), 13);
  AssertReady();
  EXPECT_EQ(free_count(), 16);
}

}  // namespace
}  // namespace openr_host

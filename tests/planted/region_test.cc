// Faults with data that belong to somebody else.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/planted/planted.h"

namespace openr_host::region_test {
namespace {

using testing::HasSubstr;

constexpr char kOut[] = "Sender.Out.Number.S";
constexpr char kIn[] = "Receiver.In.Number.O";

class Sender : public Actor {
 public:
  Sender() {
    out_ = AddSubject(kOut, [this](const OReadyEvent&) { Post(host().id, next_, 8'000); });
    next_ = AddExtra("Next", [this](void*) { Send(out_, ++number_); });
  }

 private:
  OSubject* out_;
  Selector next_;
  int number_ = 0;
};

class Receiver : public Actor {
 public:
  Receiver() {
    in_ = AddObserver(kIn, [this](const ONotifyEvent& event) { HandleEvent(event); });
  }
  OStatus DoStart(const OSystemEvent&) override { return in_->AssertReady(); }

 protected:
  virtual void HandleEvent(const ONotifyEvent& event) = 0;
  OObserver* in_;
};

template <typename TheSender, typename TheReceiver>
ExplorePlan PlanWith(bool guard, bool is_strict = false) {
  const auto build = [](System* system) {
    system->AddObject<TheSender>(0, "sender");
    system->AddObject<TheReceiver>(0, "receiver");
    Wire(system, kOut, kIn);
  };
  SystemOptions options;
  options.guard_regions = guard;
  options.strict = is_strict;
  return PlanOf(SceneOf(build, options));
}

// Fault: gives a received region back twice.
class GenerousReceiver : public Receiver {
  void HandleEvent(const ONotifyEvent& event) override {
    event.RCData(0)->RemoveReference();
    in_->AssertReady();
  }
};

TEST(PlantedRegionTest, ARegionReleasedTooOftenIsAnError) {
  const Broken broken = InDefaultOrder(PlanWith<Sender, GenerousReceiver>(false));
  EXPECT_EQ(broken.property, "no-errors");
  EXPECT_THAT(broken.text, HasSubstr("receiver: RemoveReference() on a region to which this object "
                                     "holds no reference"));
}

// Fault: keeps the address of the data beyond AssertReady().
class RetentiveReceiver : public Receiver {
  void HandleEvent(const ONotifyEvent& event) override {
    if (kept_ != nullptr) Say("the last one was " + std::to_string(*kept_));
    kept_ = static_cast<const int*>(event.Data(0));
    in_->AssertReady();
  }
  const int* kept_ = nullptr;
};

TEST(PlantedRegionTest, AKeptAddressFaultsWhenDataAreWatched) {
  const Broken broken = InDefaultOrder(PlanWith<Sender, RetentiveReceiver>(true));
  EXPECT_EQ(broken.property, "no-crash");
#ifndef __SANITIZE_ADDRESS__  // AddressSanitizer reports crashes itself
  EXPECT_THAT(broken.text, HasSubstr("OBJECT receiver"));
  EXPECT_THAT(broken.text, HasSubstr("EXCEPTION SIGSEGV (an access to data that were given back by "
                                     "AssertReady(), or beyond the end of received data)"));
#endif
}

// Fault: uses received data as its own memory.
class ScribblingReceiver : public Receiver {
  void HandleEvent(const ONotifyEvent& event) override {
    ++*const_cast<int*>(static_cast<const int*>(event.Data(0)));
    in_->AssertReady();
  }
};

TEST(PlantedRegionTest, WritingIntoReceivedDataIsHiddenUnlessTheyAreWatched) {
  EXPECT_EQ(InDefaultOrder(PlanWith<Sender, ScribblingReceiver>(false)).property, "");
  for (const bool is_strict : {false, true}) {
    const Broken broken =
        InDefaultOrder(PlanWith<Sender, ScribblingReceiver>(!is_strict, is_strict));
    EXPECT_EQ(broken.property, "no-crash");
#ifndef __SANITIZE_ADDRESS__  // AddressSanitizer reports crashes itself
    EXPECT_THAT(broken.text, HasSubstr("EXCEPTION SIGSEGV (a write to received data, which are "
                                       "read-only)"));
#endif
  }
}

// Fault: one region for everything, written without a look at who still reads it.
class ThriftySender : public Actor {
 public:
  ThriftySender() {
    out_ = AddSubject(kOut, [this](const OReadyEvent&) {
      if (region_ != nullptr) return;
      region_ = new RCRegion(sizeof(int));
      out_->SetData(region_);
      out_->NotifyObservers();
      *reinterpret_cast<int*>(region_->Base()) = 99;
    });
  }

 private:
  OSubject* out_;
  RCRegion* region_ = nullptr;
};

class PlainReceiver : public Receiver {
  void HandleEvent(const ONotifyEvent&) override { in_->AssertReady(); }
};

TEST(PlantedRegionTest, DataChangedOnTheirWayAreAnErrorOfTheSender) {
  const Broken broken = InDefaultOrder(PlanWith<ThriftySender, PlainReceiver>(true));
  EXPECT_EQ(broken.property, "no-errors");
  EXPECT_THAT(broken.text, HasSubstr("error: sender: Sender.Out.Number.S"));
  EXPECT_THAT(broken.text, HasSubstr("data were changed on their way to receiver"));
}

TEST(PlantedRegionTest, ADecentPairIsLeftAlone) {
  EXPECT_EQ(InRandomOrders(PlanWith<Sender, PlainReceiver>(true)).text, "");
}

}  // namespace
}  // namespace openr_host::region_test

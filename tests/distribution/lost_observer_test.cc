// A subject whose observer is lost with its worker gets its regions back and hears that no observer
// is ready.
#include <OPENR/ObjcommMessages.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>

#include "distribution/remote_object.h"
#include "distribution/remote_process.h"
#include "runtime/core/api.h"
#include "runtime/core/schedule.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

constexpr uint32_t kNotifyEntry = 9;

// Delays the notifications for one object.
class Late : public Schedule {
 public:
  size_t Choose(Question, const std::vector<ObjectId>&) override { return 0; }
  int64_t ExtraDelayUs(const Message& message, int64_t, int64_t) override {
    return message.target == target && message.kind == PayloadKind::kNotify ? 5000 : 0;
  }

  ObjectId target = kNoObject;
};

class LostObserverTest : public ::testing::Test {
 protected:
  LostObserverTest() {
    system_.AddRobot("ERS-210", nullptr);
    sender_ = system_.AddObject<SubjectProbe>(0, "sender");
    process_.SetLost();
    auto remote = std::make_unique<RemoteObject>(
        &system_, system_.object_table().NextId(), 0, &process_,
        [](const RemoteObject*, RemoteObject::Loss, const std::string&) {});
    remote->set_selectors({0, 1, 2, 3, kNotifyEntry});
    remote_ = remote.get();
    system_.object_table().Adopt(std::move(remote));
    process_.resources().Add(remote_);
    system_.set_schedule(&late_);
    system_.Boot();
    system_.RunFor(1000);
    Control();
    Ready();
  }
  static BusOptions Options() {
    BusOptions options;
    options.run = "lost-observer-" + std::to_string(getpid());
    return options;
  }
  OServiceEntry Observer() const { return {OidOf(remote_->id), kNotifyEntry}; }

  // Sends the control message that an observer sends to connect.
  void Control() {
    const CurrentScope scope(&system_, remote_);
    const auto entry = system_.robot(0).directory.at("Sender.Out.Number.S");
    OwnedMessage message = system_.NewMessage(entry.first, entry.second);
    auto& control = *new (message->payload) OControlMessage;
    std::memset(static_cast<void*>(&control), 0, sizeof control);
    control.msgType = omsgCONTROL_V21;
    control.command = objcommCMD_ADDOBSERVER_V22;
    control.observerID = Observer();
    control.d_min = control.d_max = 1;
    message->size = sizeof control;
    system_.Post(std::move(message));
    system_.RunFor(1000);
  }
  void Ready() {
    const CurrentScope scope(&system_, remote_);
    OwnedMessage message =
        system_.NewMessage(sender_->host().id, sender_->out->GetID().GetSelector());
    auto& ready = *new (message->payload) OReadyMessage;
    ready.msgType = omsgREADY_V22;
    ready.command = objcommCMD_ASSERT_READY;
    ready.observerID = Observer();
    ready.numOfData = 0;
    message->size = sizeof ready;
    message->kind = PayloadKind::kReady;
    system_.Post(std::move(message));
    system_.RunFor(1000);
  }

  Bus bus_{Options()};
  RemoteProcess process_{&bus_, "gone", false, [] { return std::string(); },
                         [](const std::string&) {}};
  Late late_;
  System system_;
  SubjectProbe* sender_;
  RemoteObject* remote_;
};

TEST_F(LostObserverTest, RegionsComeBackAndNoObserverIsReady) {
  ASSERT_EQ(sender_->out->NumberOfObservers(), 1);
  ASSERT_EQ(sender_->out->IsReady(), 1);
  RCRegion* region = nullptr;
  RunAs(sender_, [&] {
    region = new RCRegion(16);
    sender_->out->SetData(region);
    sender_->out->NotifyObservers();
    EXPECT_EQ(region->NumberOfReference(), 2);
  });
  system_.RunFor(1000);
  EXPECT_EQ(region->NumberOfReference(), 1);
  EXPECT_EQ(sender_->readies.back(), "deassert");
  EXPECT_EQ(sender_->out->IsReady(), 0);
  EXPECT_EQ(remote_->undelivered_count, 3u);  // DoInit, DoStart and the notification
  RunAs(sender_, [&] { region->RemoveReference(); });
}

TEST_F(LostObserverTest, NoFindingSaysThatTheObserverDeasserted) {
  RunAs(sender_, [&] { sender_->Send(1); });
  system_.RunFor(1000);
  ASSERT_EQ(sender_->readies.back(), "deassert");
  RunAs(sender_, [&] { sender_->Send(2); });
  EXPECT_TRUE(system_.findings().all().empty()) << system_.findings().all()[0].text;
}

TEST_F(LostObserverTest, DelayedMessagesToAReplacedObserverAreCounted) {
  late_.target = remote_->id;
  RCRegion* region = nullptr;
  RunAs(sender_, [&] {
    region = new RCRegion(16);
    sender_->out->SetData(region);
    sender_->out->NotifyObservers();
  });
  const uint64_t undelivered = remote_->undelivered_count;
  uint64_t undelivered_at_end = 0;
  system_.object_table().OnReplace([&](ObjectId id) {
    undelivered_at_end = static_cast<RemoteObject*>(system_.object(id))->undelivered_count;
  });
  std::vector<std::unique_ptr<Object>> fresh;
  fresh.push_back(remote_->NewInstance());
  system_.object_table().PostReplacement(std::move(fresh));
  system_.RunFor(1000);
  EXPECT_EQ(undelivered_at_end, undelivered + 1);
  EXPECT_EQ(region->NumberOfReference(), 1);
  EXPECT_EQ(sender_->readies.back(), "deassert");
  RunAs(sender_, [&] { region->RemoveReference(); });
}

TEST_F(LostObserverTest, TheObjectManagerDoesNotWaitForALostObject) {
  EXPECT_TRUE(system_.booted());
  EXPECT_TRUE(system_.findings().all().empty());
}

}  // namespace
}  // namespace openr_host

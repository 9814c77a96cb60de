// Faults in the talk of ready and notify.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/planted/planted.h"

namespace openr_host::ready_test {
namespace {

using testing::HasSubstr;

constexpr char kOut[] = "Sender.Out.Number.S";
constexpr char kIn[] = "Receiver.In.Number.O";

// Sends the next number whenever the observer is ready.
class Sender : public Actor {
 public:
  Sender() {
    out_ = AddSubject(kOut, [this](const OReadyEvent&) { Send(out_, ++number_); });
  }

 private:
  OSubject* out_;
  int number_ = 0;
};

// Fault: forgets to assert ready after the third number.
class ForgetfulReceiver : public Actor {
 public:
  ForgetfulReceiver() {
    in_ = AddObserver(kIn, [this](const ONotifyEvent& event) {
      if (NumberIn(event) == 3) return;
      Post(host().id, next_, 10'000);
    });
    next_ = AddExtra("Next", [this](void*) { in_->AssertReady(); });
  }
  OStatus DoStart(const OSystemEvent&) override { return in_->AssertReady(); }

 private:
  OObserver* in_;
  Selector next_;
};

void BuildLostReady(System* system) {
  system->AddObject<Sender>(0, "sender");
  system->AddObject<ForgetfulReceiver>(0, "receiver");
  Wire(system, kOut, kIn);
}

TEST(PlantedReadyTest, ALostReadyIsNamedWithItsConnection) {
  const Broken broken = InDefaultOrder(PlanOf(SceneOf(&BuildLostReady)));
  EXPECT_EQ(broken.property, "not-stuck");
  EXPECT_THAT(broken.text, HasSubstr("receiver has not asserted ready to Sender.Out.Number.S since "
                                     "its notification of t=0.020 s"));
}

TEST(PlantedReadyTest, ALostReadyIsAlsoAFindingAtTheEndOfARun) {
  const PreparedRun prepared = SceneOf(&BuildLostReady)();
  prepared.system->Boot();
  prepared.system->RunFor(500'000);
  ReportStalls(prepared.system, true);
  EXPECT_TRUE(prepared.system->findings().all().empty()) << "half a second is no stall yet";
  prepared.system->RunFor(2'000'000);
  ReportStalls(prepared.system, false);
  EXPECT_TRUE(prepared.system->findings().all().empty()) << "it may want no more";
  ReportStalls(prepared.system, true);
  ASSERT_EQ(prepared.system->findings().all().size(), 1u);
  EXPECT_THAT(prepared.system->findings().all()[0].text,
              HasSubstr("again after every notification"));
}

// Fault: sends two numbers in a row, as if each were kept.
class HastySender : public Actor {
 public:
  HastySender() {
    out_ = AddSubject(kOut, [this](const OReadyEvent&) {
      if (done_) return;
      done_ = true;
      Send(out_, 1);
      Send(out_, 2);
      Send(out_, 3);
    });
  }

 private:
  OSubject* out_;
  bool done_ = false;
};

class PlainReceiver : public Actor {
 public:
  PlainReceiver() {
    in_ = AddObserver(kIn, [this](const ONotifyEvent& event) {
      Say(std::to_string(NumberIn(event)));
      in_->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override { return in_->AssertReady(); }

 private:
  OObserver* in_;
};

void BuildDoubleNotify(System* system) {
  system->AddObject<HastySender>(0, "sender");
  system->AddObject<PlainReceiver>(0, "receiver");
  Wire(system, kOut, kIn);
}

TEST(PlantedReadyTest, ADoubleNotifyLosesDataAndBothChecksSaySo) {
  const Broken drops = InDefaultOrder(PlanOf(SceneOf(&BuildDoubleNotify)));
  EXPECT_EQ(drops.property, "no-drops");
  EXPECT_THAT(drops.text, HasSubstr("sender"));
  const Broken warns = InDefaultOrder(PlanOf(SceneOf(&BuildDoubleNotify), {"no-warnings"}));
  EXPECT_THAT(warns.text, HasSubstr("Sender.Out.Number.S: data receiver was not ready for were "
                                    "replaced by newer ones and are lost"));
}

// Fault: asserts ready by the clock instead of once per notification.
class EagerReceiver : public Actor {
 public:
  EagerReceiver() {
    in_ = AddObserver(kIn);
    tick_ = AddExtra("Tick", [this](void*) { Tick(); });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Tick();
    return oSUCCESS;
  }

 private:
  void Tick() {
    in_->AssertReady();
    Post(host().id, tick_, 8'000);
  }
  OObserver* in_;
  Selector tick_;
};

class SilentSender : public Actor {
 public:
  SilentSender() { AddSubject(kOut); }
};

void BuildReadyFlood(System* system) {
  system->AddObject<SilentSender>(0, "sender");
  system->AddObject<EagerReceiver>(0, "receiver");
  Wire(system, kOut, kIn);
}

TEST(PlantedReadyTest, ReadyAssertedByTheClockIsAFinding) {
  const Broken broken = InDefaultOrder(PlanOf(SceneOf(&BuildReadyFlood), {"no-warnings"}));
  EXPECT_THAT(broken.text,
              HasSubstr("receiver: Receiver.In.Number.O: asserts ready to sender again "
                        "and again (9 times)"));
}

// Fault: takes what the observer will answer as said when NotifyObservers() returns.
class ImpatientClient : public Actor {
 public:
  ImpatientClient() {
    ask_ = AddSubject("Client.Ask.Number.S", [this](const OReadyEvent&) {
      if (asked_) return;
      asked_ = true;
      Send(ask_, 20);
      Say("answer " + std::to_string(answer_));
    });
    answered_ = AddObserver("Client.Answer.Number.O", [this](const ONotifyEvent& event) {
      answer_ = NumberIn(event);
      answered_->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override { return answered_->AssertReady(); }

 private:
  OSubject* ask_;
  OObserver* answered_;
  bool asked_ = false;
  int answer_ = 0;
};

class DoublingServer : public Actor {
 public:
  DoublingServer() {
    answer_ = AddSubject("Server.Answer.Number.S");
    ask_ = AddObserver("Server.Ask.Number.O", [this](const ONotifyEvent& event) {
      Send(answer_, 2 * NumberIn(event));
      ask_->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override { return ask_->AssertReady(); }

 private:
  OSubject* answer_;
  OObserver* ask_;
};

TEST(PlantedReadyTest, AHandlerIsNotReenteredWhileItNotifies) {
  const auto build = [](System* system) {
    system->AddObject<ImpatientClient>(0, "client");
    system->AddObject<DoublingServer>(0, "server");
    Wire(system, "Client.Ask.Number.S", "Server.Ask.Number.O");
    Wire(system, "Server.Answer.Number.S", "Client.Answer.Number.O");
  };
  const Broken broken =
      InDefaultOrder(PlanOf(SceneOf(build), {"finally objects.client.state == answer 40"}));
  EXPECT_EQ(broken.text, "not objects.client.state == answer 40 at the end: it is 'answer 0'");
}

}  // namespace
}  // namespace openr_host::ready_test

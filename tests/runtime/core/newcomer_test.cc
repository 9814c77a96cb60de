// The first that an object hears of is its DoInit, at boot and when it takes another's place.
#include <OPENR/ObjcommMessages.h>
#include <gmock/gmock.h>
#include <sError.h>

#include "runtime/core/api.h"
#include "tests/runtime/core/recorder.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;

constexpr Selector kControl = oentryBASE;  // entry of the first subject
constexpr int64_t kWaitUs = 5000;

// Waits in its DoInit, while others go on.
class Sleeper : public CodeObject {
 public:
  OStatus DoInit(const OSystemEvent&) override {
    if (on_init) on_init();
    bool timed_out = false;
    const uint64_t box = system().requests().OpenBox();
    system().requests().Await(box, kWaitUs, "nothing", &timed_out);
    return oSUCCESS;
  }
  std::function<void()> on_init;
};

// Its DoInit comes after that.
class Newcomer : public SubjectProbe {
 public:
  explicit Newcomer(Log* log) : log_(log) {
    on_ready = [this](const OReadyEvent&) { log_->push_back(readies.back()); };
    entry = AddExtra("Entry", [this](void*) { log_->push_back("message"); });
  }
  OStatus DoInit(const OSystemEvent&) override {
    log_->push_back("init");
    RegisterServiceEntry(OServiceEntry(myOID_, kControl), "Sender.Out.Number.S");
    return oSUCCESS;
  }
  Selector entry;

 private:
  Log* const log_;
};

class NewcomerTest : public testing::Test {
 protected:
  NewcomerTest() {
    system_.AddRobot("ERS-210", nullptr);
    receiver_ = system_.AddObject<ObserverProbe>(0, "receiver");
    sleeper_ = system_.AddObject<Sleeper>(0, "sleeper");
    newcomer_ = system_.AddObject<Newcomer>(0, "newcomer", &log_);
    system_.Connect({0, "Sender.Out.Number.S", "Receiver.In.Number.O", "CONNECT.CFG:1"});
  }
  template <typename T, typename... Args>
  T* MakeAnother(const CodeObject& old, Args... args) {
    auto host = std::make_unique<CodeHost>(&system_, old.host().id, 0);
    host->name = old.host().name;
    const CurrentScope scope(&system_, host.get());
    auto code = std::make_unique<T>(args...);
    T* const made = code.get();
    host->code = std::move(code);
    fresh_.push_back(std::move(host));
    return made;
  }
  void Return() {
    sleeper_ = MakeAnother<Sleeper>(*sleeper_);
    newcomer_ = MakeAnother<Newcomer>(*newcomer_, &log_);
    log_.clear();
    system_.object_table().PostReplacement(std::move(fresh_));
    system_.RunFor(kWaitUs / 2);
  }
  void PostToNewcomer() {
    system_.Post(system_.NewMessage(newcomer_->host().id, newcomer_->entry));
  }

  Log log_;
  System system_;
  ObserverProbe* receiver_;
  Sleeper* sleeper_;
  Newcomer* newcomer_;
  std::vector<std::unique_ptr<Object>> fresh_;
};

TEST_F(NewcomerTest, AtBootAMessageWaitsForDoInit) {
  sleeper_->on_init = [this] { PostToNewcomer(); };
  system_.Boot();
  system_.RunFor(2 * kWaitUs);
  EXPECT_THAT(log_, ElementsAre("init", "message"));
}

// As the constructors of an image do.
TEST_F(NewcomerTest, AMessageFromBeforeTheBootWaitsForDoInit) {
  PostToNewcomer();
  system_.Boot();
  system_.RunFor(2 * kWaitUs);
  EXPECT_THAT(log_, ElementsAre("init", "message"));
}

// A question in a DoInit is answered at once, because otherwise the boot would wait for itself.
TEST_F(NewcomerTest, AQuestionInADoInitIsHeardAtOnce) {
  sleeper_->on_init = [this] {
    OwnedMessage question = system_.NewMessage(newcomer_->host().id, newcomer_->entry);
    question->reply_box = system_.requests().OpenBox();
    system_.Post(std::move(question));
  };
  system_.Boot();
  system_.RunFor(2 * kWaitUs);
  EXPECT_THAT(log_, ElementsAre("message", "init"));
}

TEST_F(NewcomerTest, ASuccessorHearsOfDoInitFirst) {
  system_.Boot();
  system_.RunFor(2 * kWaitUs);
  Return();
  PostToNewcomer();
  system_.RunFor(kWaitUs);
  EXPECT_THAT(log_, ElementsAre("init", "message"));
}

// As one that reads a notification of the old one only now.
TEST_F(NewcomerTest, AnObserverThatIsReadyTooEarlyIsReadyWhenItIsConnected) {
  system_.Boot();
  system_.RunFor(2 * kWaitUs);
  Return();
  RunAs(receiver_, [this] { receiver_->in->AssertReady(newcomer_->out->GetID()); });
  system_.RunFor(kWaitUs);
  EXPECT_THAT(log_, ElementsAre("init", "ready:1"));
  RunAs(newcomer_, [this] { newcomer_->Send(7); });
  system_.RunFor(1000);
  EXPECT_THAT(receiver_->events, ElementsAre("7"));
}

// The receiver is not connected with the newcomer while the sleeper is in its DoInit.
TEST_F(NewcomerTest, AReadyToAllSubjectsBetweenTwoConnectionsIsKept) {
  system_.Boot();
  system_.RunFor(2 * kWaitUs);
  Return();
  RunAs(receiver_, [this] {
    EXPECT_EQ(receiver_->in->NumberOfSubjects(), 0);
    receiver_->in->AssertReady();
  });
  system_.RunFor(kWaitUs);
  EXPECT_THAT(log_, ElementsAre("init", "ready:1"));
  RunAs(newcomer_, [this] { newcomer_->Send(7); });
  system_.RunFor(1000);
  EXPECT_THAT(receiver_->events, ElementsAre("7"));
}

// A program that goes through its subjects does not reach the newcomer, with which it is not
// connected.
TEST_F(NewcomerTest, AReadyToEachConnectedSubjectIsNoneForAMissingOne) {
  system_.Boot();
  system_.RunFor(2 * kWaitUs);
  Return();
  RunAs(receiver_, [this] {
    for (auto it = receiver_->in->begin(); it != receiver_->in->end(); ++it)
      receiver_->in->AssertReady(it->GetSubjectID());
  });
  system_.RunFor(kWaitUs);
  EXPECT_THAT(log_, ElementsAre("init"));
}

// The newcomer gets the assert that the receiver has given to its predecessor, then the deassert.
TEST_F(NewcomerTest, ADeassertBetweenTwoConnectionsCountsAsTheLaterCommand) {
  system_.Boot();
  RunAs(receiver_, [this] { receiver_->in->AssertReady(newcomer_->out->GetID()); });
  system_.RunFor(2 * kWaitUs);
  Return();
  RunAs(receiver_, [this] { receiver_->in->DeassertReady(); });
  system_.RunFor(kWaitUs);
  EXPECT_THAT(log_, ElementsAre("init", "ready:1", "deassert"));
}

// Only commands that were given between two connections are repeated.
TEST_F(NewcomerTest, AnObserverThatWasNotReadyIsNotReadyForTheSuccessor) {
  system_.Boot();
  system_.RunFor(2 * kWaitUs);
  RunAs(receiver_, [this] { receiver_->in->AssertReady(); });
  system_.RunFor(1000);
  RunAs(newcomer_, [this] { newcomer_->Send(7); });
  system_.RunFor(1000);
  Return();
  system_.RunFor(kWaitUs);
  EXPECT_THAT(log_, ElementsAre("init"));
}

// ---- replies

class LateReplyTest : public testing::Test {
 protected:
  LateReplyTest() {
    system_.AddRobot("ERS-210", nullptr);
    asker_ = system_.AddObject<Recorder>(0, "asker", &log_);
    slow_ = system_.AddObject<Recorder>(0, "slow", &log_);
    silent_ = system_.AddObject<Recorder>(0, "silent", &log_);
    slow_->on_message = [this](int) { ticket_ = system_.requests().TakeTicket(); };
    system_.Boot();
    system_.RunFor(1000);
  }
  // Makes the asker send `target` a request, and wait for the reply.
  void Ask(Recorder* target) {
    asker_->on_message = [this, target](int value) {
      int answer = 0;
      system_.requests().Call(target->host().id, target->entry, &value, sizeof value, &answer,
                              sizeof answer);
      log_.push_back(fmt::format("answer {}", answer));
    };
    PostTo(asker_, 1);
    system_.RunFor(1000);
  }
  void ReplaceAsker() {
    auto host = std::make_unique<CodeHost>(&system_, asker_->host().id, 0);
    host->name = "asker";
    {
      const CurrentScope scope(&system_, host.get());
      auto code = std::make_unique<Recorder>(&log_);
      asker_ = code.get();
      host->SetCode(std::move(code));
    }
    std::vector<std::unique_ptr<Object>> fresh;
    fresh.push_back(std::move(host));
    system_.object_table().PostReplacement(std::move(fresh));
    system_.RunFor(1000);
  }

  Log log_;
  System system_;
  Recorder* asker_;
  Recorder* slow_;
  Recorder* silent_;
  ReplyTicket ticket_;
};

TEST_F(LateReplyTest, AReplyToTheOldObjectIsNoneToARequestOfItsSuccessor) {
  Ask(slow_);
  ReplaceAsker();
  Ask(silent_);
  log_.clear();
  const int answer = 7;
  RunAs(slow_, [&] {
    EXPECT_EQ(system_.requests().Reply(ticket_, &answer, sizeof answer), sRBOXWASCLEANED);
  });
  system_.RunFor(1000);
  EXPECT_EQ(log_, Log{});
}

// ---- handlers that take time

constexpr int64_t kWorkUs = 3000;

// An object whose handler takes processor time, and whose message leaves at the end of this time.
class BusySender : public CodeObject {
 public:
  BusySender() {
    work = AddExtra("Work", [this](void*) {
      if (on_work) on_work();
    });
  }
  Selector work;
  std::function<void()> on_work;
};

class WorkCosts : public CostModel {
 public:
  int64_t CostUs(const Object& object, uint32_t selector) override {
    return object.name == "worker" && selector >= oentryBASE ? kWorkUs : 0;
  }
};

class LeftMessagesTest : public testing::Test {
 protected:
  LeftMessagesTest() {
    system_.AddRobot("ERS-210", nullptr);
    worker_ = system_.AddObject<BusySender>(0, "worker");
    old_ = system_.AddObject<Newcomer>(0, "newcomer", &log_);
    system_.Boot();
    system_.RunFor(1000);
    log_.clear();
  }
  static SystemOptions Options() {
    SystemOptions options;
    options.cost = std::make_shared<WorkCosts>();
    return options;
  }
  void Work() {
    system_.Post(system_.NewMessage(worker_->host().id, worker_->work));
    system_.RunFor(kWorkUs / 3);
  }
  void PostToOld() { system_.Post(system_.NewMessage(old_->host().id, old_->entry)); }
  // While the worker has the processor; then its time is over.
  void ReplaceAndFinish() {
    auto host = std::make_unique<CodeHost>(&system_, old_->host().id, 0);
    host->name = "newcomer";
    {
      const CurrentScope scope(&system_, host.get());
      host->code = std::make_unique<Newcomer>(&log_);
    }
    fresh_.push_back(std::move(host));
    system_.object_table().PostReplacement(std::move(fresh_));
    system_.RunFor(2 * kWorkUs);
  }

  Log log_;
  System system_{Options()};
  BusySender* worker_;
  Newcomer* old_;
  std::vector<std::unique_ptr<Object>> fresh_;
};

TEST_F(LeftMessagesTest, WhatLeavesAtTheEndOfAHandlersTimeIsNotForTheSuccessor) {
  worker_->on_work = [this] { PostToOld(); };
  Work();
  ReplaceAndFinish();
  EXPECT_THAT(log_, ElementsAre("init"));
  EXPECT_EQ(system_.FindObject(0, "newcomer")->statistics().dropped_count(), 1u);
}

TEST_F(LeftMessagesTest, NorIsWhatWaitsForTheProcessor) {
  Work();
  PostToOld();
  system_.RunFor(kWorkUs / 3);
  ReplaceAndFinish();
  EXPECT_THAT(log_, ElementsAre("init"));
  EXPECT_EQ(system_.FindObject(0, "newcomer")->statistics().dropped_count(), 1u);
}

}  // namespace
}  // namespace openr_host

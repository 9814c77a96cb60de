// Tests of the messages by which observers and subjects are connected and disconnected.  The
// runtime itself disconnects nothing, but a program may send such messages.
#include <OPENR/OPENRMessages.h>
#include <OPENR/ObjcommMessages.h>
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "runtime/core/api.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

using Events = std::vector<std::string>;

class ConnectMessagesTest : public TwoObserversTest {
 protected:
  static uint32_t EntryOf(CodeObject* object, const std::string& name) {
    for (const auto& [selector, entry_name] : object->host().entry_names().names()) {
      if (entry_name == name) return selector;
    }
    ADD_FAILURE() << "no entry " << name;
    return 0;
  }
  // Sends `observer`, whose service is `service`, the message that ends its connection with
  // `sender`.
  void Disconnect(ObserverProbe* observer, const std::string& service) {
    OConnectMessage end(oconnectcmdDISCONNECT);
    end.entry =
        OServiceEntry(OidOf(sender->host().id), EntryOf(sender, "Sender.Out.Number.S (Control)"));
    OwnedMessage message =
        system.NewMessage(observer->host().id, EntryOf(observer, service + " (Connect)"));
    std::memcpy(message->payload, &end, sizeof end);
    message->size = sizeof end;
    ASSERT_EQ(system.Post(std::move(message)), sSUCCESS);
    Settle();
  }
  void DisconnectFirst() { Disconnect(first, "First.In.Number.O"); }
};

TEST_F(ConnectMessagesTest, AfterADisconnectNeitherSideKnowsTheOther) {
  DisconnectFirst();
  RunAs(sender, [&] {
    EXPECT_EQ(sender->out->NumberOfObservers(), 1);
    EXPECT_EQ(sender->out->FindObserver(first->in->GetID()), sender->out->end());
    EXPECT_EQ(sender->out->begin()->GetObserverID(), second->in->GetID());
  });
  RunAs(first, [&] {
    EXPECT_EQ(first->in->NumberOfSubjects(), 0);
    EXPECT_EQ(first->in->begin(), first->in->end());
  });
  RunAs(second, [&] { EXPECT_EQ(second->in->NumberOfSubjects(), 1); });
}

TEST_F(ConnectMessagesTest, AfterADisconnectOnlyTheOtherObserverGetsData) {
  DisconnectFirst();
  for (ObserverProbe* each : {first, second}) RunAs(each, [&] { each->in->AssertReady(); });
  Settle();
  RunAs(sender, [&] { EXPECT_EQ(sender->Send(7), oSUCCESS); });
  Settle();
  EXPECT_EQ(first->events, Events{});
  EXPECT_EQ(second->events, Events{"7"});
}

TEST_F(ConnectMessagesTest, ADisconnectReleasesDataThatWaitedForTheObserver) {
  RCRegion* region = nullptr;
  RunAs(sender, [&] {
    region = new RCRegion(sizeof(int));
    sender->out->SetData(first->in->GetID(), region);
    sender->out->NotifyObservers();
    EXPECT_EQ(region->NumberOfReference(), 2);
  });
  DisconnectFirst();
  EXPECT_EQ(region->NumberOfReference(), 1);
  RunAs(sender, [&] { region->RemoveReference(); });
}

TEST_F(ConnectMessagesTest, ASecondDisconnectChangesNothing) {
  DisconnectFirst();
  DisconnectFirst();
  RunAs(sender, [&] { EXPECT_EQ(sender->out->NumberOfObservers(), 1); });
}

// An object that sends a subject a message and waits for the reply, as observers do.
class Asker : public CodeObject {
 public:
  Asker() {
    entry = AddExtra("Ask", [this](void*) {
      EXPECT_EQ(system().requests().Call(subject, selector, &question, sizeof question, &reply,
                                         sizeof reply),
                sSUCCESS);
      ++answers;
    });
  }
  Selector entry;
  ObjectId subject = kNoObject;
  uint32_t selector = 0;
  OControlMessage question;
  OControlReplyMessage reply;
  int answers = 0;
};

TEST_F(ConnectMessagesTest, TheReplyNamesTheSubjectAndTheStatus) {
  auto* const asker = system.AddObject<Asker>(0, "asker");
  asker->subject = sender->host().id;
  asker->selector = EntryOf(sender, "Sender.Out.Number.S (Control)");
  asker->question.msgType = omsgCONTROL_V21;
  asker->question.observerID = first->in->GetID();
  const auto ask = [&](int command) {
    asker->question.command = static_cast<ObjcommCommand>(command);
    ASSERT_EQ(system.Post(system.NewMessage(asker->host().id, asker->entry)), sSUCCESS);
    Settle();
  };
  ask(objcommCMD_ADDOBSERVER_V22);
  EXPECT_EQ(asker->answers, 1);
  EXPECT_EQ(asker->reply.msgType, omsgCONTROL_REPLY_V21);
  EXPECT_EQ(asker->reply.status, oSUCCESS);
  EXPECT_EQ(asker->reply.subjectID, sender->out->GetID());
  // The subject knew the observer before, so it is not added once more.
  RunAs(sender, [&] { EXPECT_EQ(sender->out->NumberOfObservers(), 2); });
  ask(objcommCMD_ASSERT_READY);
  EXPECT_EQ(asker->answers, 2);
  EXPECT_EQ(asker->reply.status, oUNKNOWN_COMMAND);
}

TEST_F(ConnectMessagesTest, TheHandlerOfASubjectReturnsTheStatus) {
  OControlMessage control;
  control.observerID = first->in->GetID();
  RunAs(sender, [&] {
    control.command = objcommCMD_ASSERT_READY;
    EXPECT_EQ(sender->out->ControlHandler(control), oUNKNOWN_COMMAND);
    control.command = objcommCMD_REMOVEOBSERVER_V22;
    EXPECT_EQ(sender->out->ControlHandler(control), oSUCCESS);
    EXPECT_EQ(sender->out->NumberOfObservers(), 1);
  });
}

TEST_F(ConnectMessagesTest, AFailureOfTheProgramConnectsNobody) {
  RunAs(sender, [&] {
    OControlMessage control;
    control.command = objcommCMD_ADDOBSERVER_V22;
    control.observerID = ObserverID(OidOf(7), 9);
    EXPECT_EQ(sender->out->ControlHandler(control, oFAIL), oFAIL);
    EXPECT_EQ(sender->out->NumberOfObservers(), 2);
  });
}

// An object whose subject and observer are connected with each other, and whose Control entry ends
// the handler.
class WithEndedControl : public CodeObject {
 public:
  explicit WithEndedControl(std::function<void()> on_control) {
    const Selector control = AddExtra("Control", [on_control](void*) { on_control(); });
    AddObserver("Both.In.Number.O");
    RegisterServiceEntry(OServiceEntry(myOID_, control), "Both.Out.Number.S");
  }
};

// The connection has no reply, so the object manager waits for 10 s.  The DoStart after it has one.
void ExpectDoStartIsAnswered(std::function<void(System*)> on_control) {
  System system;
  system.AddRobot("ERS-210", nullptr);
  system.AddObject<WithEndedControl>(0, "both", [&] { on_control(&system); });
  system.Connect({0, "Both.Out.Number.S", "Both.In.Number.O", "test"});
  system.Boot();
  system.RunFor(11'000'000);
  EXPECT_TRUE(system.booted());
}

TEST(EndedControlTest, AfterAnAbandonedControlTheObjectRepliesAgain) {
  ExpectDoStartIsAnswered([](System* system) { system->AbandonHandler(); });
}

TEST(EndedControlTest, AfterAnExceptionInControlTheObjectRepliesAgain) {
  ExpectDoStartIsAnswered([](System*) { throw std::runtime_error("no"); });
}

}  // namespace
}  // namespace openr_host

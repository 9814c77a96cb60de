// core.md 2.2 to 2.5: the forms that name one observer or one subject, buffers, and refusals.
#include <MCOOP.h>
#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

class FormsConformance : public TwoObserversTest {
 protected:
  void AssertReady(ObserverProbe* observer) {
    RunAs(observer, [&] { observer->in->AssertReady(); });
    Settle();
  }
  OStatus SetFor(const ObserverID& id, int value) {
    return sender->out->SetData(id, &value, sizeof value);
  }
};

using Events = std::vector<std::string>;

// core.md 2.2
TEST_F(FormsConformance, DataAndNotifiesCanBeForOneObserver) {
  AssertReady(first);
  AssertReady(second);
  RunAs(sender, [&] {
    EXPECT_EQ(SetFor(second->in->GetID(), 4), oSUCCESS);
    EXPECT_EQ(sender->out->NotifyObserver(second->in->GetID()), oSUCCESS);
    EXPECT_EQ(sender->out->IsReady(first->in->GetID()), 1);
    EXPECT_EQ(sender->out->IsReady(second->in->GetID()), 0);
    EXPECT_EQ(sender->out->ReadyStatus(second->in->GetID()), 0);
  });
  Settle();
  EXPECT_EQ(first->events, Events{});
  EXPECT_EQ(second->events, Events{"4"});
}

// Old forms of SetData(), for memory that the program made by itself.
TEST_F(FormsConformance, MemoryIsSharedByItsIdOrAPlaceInIt) {
  MemoryRegionID id = 0;
  int* memory = nullptr;
  RunAs(sender, [&] {
    void* base = nullptr;
    ASSERT_EQ(NewSharedMemoryRegion(3 * sizeof(int), MEMPROTINFO_RW, &id, &base), sSUCCESS);
    memory = static_cast<int*>(base);
  });
  const auto send = [&](int value, const std::function<OStatus()>& set) {
    AssertReady(first);
    AssertReady(second);
    RunAs(sender, [&] {
      memory[0] = value;
      memory[1] = value + 1;
      EXPECT_EQ(set(), oSUCCESS);
      sender->out->NotifyObservers();
    });
    Settle();
  };
  send(10, [&] { return sender->out->SetData(id, sizeof(int)); });
  send(20, [&] { return sender->out->SetData(OMemoryLocator(id, sizeof(int))); });
  send(30, [&] { return sender->out->SetData(second->in->GetID(), id, sizeof(int)); });
  send(40, [&] { return sender->out->SetData(second->in->GetID(), OMemoryLocator(id, 4)); });
  EXPECT_EQ(first->events, (Events{"10", "21"}));
  EXPECT_EQ(second->events, (Events{"10", "21", "30", "41"}));
  EXPECT_TRUE(system.findings().all().empty());
}

TEST_F(FormsConformance, MemoryThatIsNotThereCannotBeShared) {
  RunAs(sender, [&] {
    MemoryRegionID id = 0;
    void* base = nullptr;
    ASSERT_EQ(NewSharedMemoryRegion(16, MEMPROTINFO_RW, &id, &base), sSUCCESS);
    EXPECT_EQ(sender->out->SetData(id, 17), oINVALID_ARG);
    EXPECT_EQ(sender->out->SetData(OMemoryLocator(id, 16)), oINVALID_ARG);
    EXPECT_EQ(sender->out->SetData(OMemoryLocator()), oINVALID_ARG);
    EXPECT_EQ(sender->out->SetData(ObserverID(OID(), 7), OMemoryLocator(id, 0)), oINVALID_ARG);
    EXPECT_EQ(DeleteSharedMemoryRegion(id), sSUCCESS);
    EXPECT_EQ(sender->out->SetData(id, 16), oINVALID_ARG);
    EXPECT_EQ(sender->out->RemainBuffer(), 13u);
  });
}

// core.md 2.2: "0 for an invalid id"; the status of the others is chosen
TEST_F(FormsConformance, AnUnknownObserverIsRefused) {
  const ObserverID nobody(OID(), 7);
  RunAs(sender, [&] {
    EXPECT_EQ(SetFor(nobody, 1), oINVALID_ARG);
    EXPECT_EQ(sender->out->NotifyObserver(nobody), oINVALID_ARG);
    EXPECT_EQ(sender->out->ClearBuffer(nobody), oINVALID_ARG);
    EXPECT_EQ(sender->out->RemainBuffer(nobody), 0u);
    EXPECT_EQ(sender->out->IsReady(nobody), 0);
    EXPECT_EQ(sender->out->ReadyStatus(nobody), 0);
    EXPECT_EQ(sender->out->FindObserver(nobody), sender->out->end());
  });
}

// core.md 2.2
TEST_F(FormsConformance, ObserversAreListedInTheOrderOfTheirConnections) {
  RunAs(sender, [&] {
    ASSERT_EQ(sender->out->NumberOfObservers(), 2);
    ObserverConstIterator it = sender->out->begin();
    EXPECT_EQ(it->GetObserverID(), first->in->GetID());
    EXPECT_EQ((++it)->GetObserverID(), second->in->GetID());
    EXPECT_EQ(sender->out->FindObserver(second->in->GetID()), it);
  });
  RunAs(first, [&] {
    EXPECT_EQ(first->in->NumberOfSubjects(), 1);
    EXPECT_EQ(first->in->begin()->GetSubjectID(), sender->out->GetID());
    EXPECT_EQ(first->in->begin()->GetVersion(), objcommVERSION22);
  });
}

// core.md 2.2: 14 entries, of which a ring keeps one empty
TEST_F(FormsConformance, RemainBufferIsTheLeastOverAllObservers) {
  RunAs(sender, [&] {
    EXPECT_EQ(sender->out->GetBufferSize(), 14u);
    EXPECT_EQ(sender->out->RemainBuffer(), 13u);
    SetFor(first->in->GetID(), 1);
    SetFor(first->in->GetID(), 2);
    EXPECT_EQ(sender->out->RemainBuffer(first->in->GetID()), 11u);
    EXPECT_EQ(sender->out->RemainBuffer(second->in->GetID()), 13u);
    EXPECT_EQ(sender->out->RemainBuffer(), 11u);
  });
}

// core.md 2.2, 10.1 7
TEST_F(FormsConformance, ClearBufferDropsDataAndTheirReferences) {
  RunAs(sender, [&] {
    RCRegion* const region = new RCRegion(sizeof(int));
    sender->out->SetData(region);
    sender->out->NotifyObservers();
    sender->out->SetData(region);
    EXPECT_EQ(region->NumberOfReference(), 5);
    sender->out->ClearBuffer(first->in->GetID());
    EXPECT_EQ(region->NumberOfReference(), 3);
    sender->out->ClearBuffer();
    EXPECT_EQ(region->NumberOfReference(), 1);
    region->RemoveReference();
  });
  AssertReady(first);
  EXPECT_EQ(first->events, Events{});
}

// core.md 2.3
TEST_F(FormsConformance, ASenderIsFoundByItsRegion) {
  SubjectID found;
  first->on_notify = [&](const ONotifyEvent& event) {
    found = first->in->FindSender(event.RCData(0));
    EXPECT_EQ(event.SenderID(), found);
    EXPECT_EQ(event.Data()[0], event.Data(0));
    EXPECT_FALSE(first->in->FindSender(nullptr).IsValid());
  };
  AssertReady(first);
  RunAs(sender, [&] { sender->Send(1); });
  Settle();
  EXPECT_EQ(found, sender->out->GetID());
}

// core.md 2.8
TEST_F(FormsConformance, ARegionWrapsMemoryOfAnother) {
  RunAs(sender, [&] {
    RCRegion* const owner = new RCRegion(64);
    RCRegion* const part = new RCRegion(owner->MemID(), 16);
    EXPECT_EQ(part->Base(), owner->Base() + 16);
    EXPECT_EQ(part->Size(), 48u);
    EXPECT_EQ(part->GetType(), RCRegion::REFERENCE_V20);
    EXPECT_EQ(owner->GetType(), RCRegion::SELF_ALLOCATED);
    RCRegion* const empty = new RCRegion;
    EXPECT_EQ(empty->NumberOfReference(), 0);
    empty->AddReference();
    empty->RemoveReference();
    part->RemoveReference();
    EXPECT_EQ(owner->Base()[0], 0);
    owner->RemoveReference();
  });
  EXPECT_TRUE(system.findings().all().empty());
}

// core.md 2.1
TEST_F(FormsConformance, AnIdIsPrintedWithItsObjectAndSelector) {
  std::ostringstream out;
  out << ObserverID(OID(reinterpret_cast<void*>(uintptr_t{0x80000042})), 7);
  EXPECT_EQ(out.str(), "(OID:0x80000042 ,Sel:7)");
}

// A subject whose control function refuses.
class Refuser : public CodeObject {
 public:
  Refuser() {
    subject_ = std::make_unique<OSubject>();
    const Selector control = AddExtra("Control", [this](void* message) {
      subject_->ControlHandler(*static_cast<OControlMessage*>(message), oREFUSED);
    });
    subject_->SetReadyEntry(OServiceEntry(myOID_, AddExtra("Ready", {})));
    RegisterServiceEntry(OServiceEntry(myOID_, control), "Refuser.Out.Number.S");
  }

 private:
  std::unique_ptr<OSubject> subject_;
};

// core.md 2.9, 4
TEST(RefusalConformance, ARefusedConnectionIsSaidAndSkipped) {
  std::string printed;
  System system({.console = [&](std::string_view text) { printed += text; }});
  system.AddRobot("ERS-210", nullptr);
  system.AddObject<Refuser>(0, "refuser");
  ObserverProbe* const observer = system.AddObject<ObserverProbe>(0, "observer", "A.In.Number.O");
  system.Connect({0, "Refuser.Out.Number.S", "A.In.Number.O", "CONNECT.CFG:1"});
  system.Boot();
  system.RunFor(1000);
  EXPECT_EQ(printed, "ConnectHandler AddObserver refused by Subject. OStatus = 19\n");
  RunAs(observer, [&] { EXPECT_EQ(observer->in->NumberOfSubjects(), 0); });
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_NE(system.findings().all()[0].text.find("CONNECT.CFG:1: connection refused"),
            std::string::npos);
}

}  // namespace
}  // namespace openr_host

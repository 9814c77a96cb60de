// Two Systems between which messages are carried without a network, for tests of Marshaller.
#pragma once

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "distribution/marshaller.h"
#include "runtime/core/api.h"
#include "runtime/core/code_object.h"
#include "runtime/core/system.h"

namespace openr_host {

// A System with the subject and one with the observer.
class MarshallerTest : public testing::Test {
 protected:
  MarshallerTest() {
    for (System* system : {&here, &there}) {
      system->AddRobot("ERS-210", nullptr);
      system->AddObject<CodeObject>(0, "sender");
    }
    sender = here.FindObject(0, "sender");
  }

  RCRegion* NewRegion(const std::string& text, size_t size = 0) {
    const CurrentScope scope(&here, sender);
    auto* const region = new RCRegion(size == 0 ? text.size() : size);
    std::memcpy(region->Base(), text.data(), text.size());
    return region;
  }
  void LetGo(RCRegion* region) {
    const CurrentScope scope(&here, sender);
    region->RemoveReference();
  }

  static Message Blank() {
    Message message;
    std::memset(message.payload, 0, sizeof message.payload);
    return message;
  }

  // Makes a notification with these regions.
  static Message Notification(const std::vector<RCRegion*>& regions) {
    Message message = Blank();
    auto& notify = *new (message.payload) ONotifyMessage;
    notify.msgType = omsgNOTIFY_V22;
    notify.subjectID = OServiceEntry(OidOf(1), 5);
    notify.numOfNotify = 1;
    notify.numOfData = 0;
    for (RCRegion* region : regions) {
      auto& data = notify.data[notify.numOfData++];
      data.srcRCR = region;
      data.memID = region->MemID();
      data.offset = region->Offset();
      data.size = region->Size();
    }
    message.size = sizeof notify;
    message.kind = PayloadKind::kNotify;
    return message;
  }

  // Makes the ready that gives these regions back.
  static Message Answer(const std::vector<RCRegion*>& regions) {
    Message message = Blank();
    auto& ready = *new (message.payload) OReadyMessage;
    ready.msgType = omsgREADY_V22;
    ready.command = objcommCMD_ASSERT_READY;
    ready.observerID = OServiceEntry(OidOf(1), 6);
    ready.numOfData = 0;
    for (RCRegion* region : regions) ready.rcRegion[ready.numOfData++] = region;
    message.size = sizeof ready;
    message.kind = PayloadKind::kReady;
    return message;
  }

  static const ONotifyMessage& NotifyOf(const Message& message) {
    return *reinterpret_cast<const ONotifyMessage*>(message.payload);
  }
  static const OReadyMessage& ReadyOf(const Message& message) {
    return *reinterpret_cast<const OReadyMessage*>(message.payload);
  }

  // Encodes the message here and decodes it there.
  std::string Carry(const Message& message, Message* out,
                    const Marshaller::PeerHasMemory& has = nullptr) {
    wire = {};
    ours.Encode(message, has, &arena, &wire);
    *out = Blank();
    const std::string problem = theirs.Decode(wire, out);
    theirs.ReleaseSample();
    return problem;
  }

  // Makes a notification with `count` copies of a part, as a forged sample could have it.
  openr_wire_Message Forged(openr_wire_NotifiedRegion part, uint32_t count = 1) {
    openr_wire_Message message{};
    message.payload._d = openr_wire_PAYLOAD_NOTIFY;
    auto& parts = message.payload._u.notify.parts;
    parts = arena.Sequence<std::remove_reference_t<decltype(parts)>>(
        std::vector<openr_wire_NotifiedRegion>(count, part));
    return message;
  }
  std::string Refused(const openr_wire_Message& in) {
    Message out = Blank();
    return theirs.Decode(in, &out);
  }

  System here, there;
  Object* sender;
  WireArena arena;
  openr_wire_Message wire{};
  Marshaller ours{&here, false};
  Marshaller theirs{&there, true};
};

}  // namespace openr_host

// Messages between two Systems without a network: what arrives, and what is refused.
#include <gmock/gmock.h>

#include "runtime/core/connection_messages.h"
#include "tests/marshalling/marshaller_fixture.h"

namespace openr_host {
namespace {

TEST_F(MarshallerTest, BytesArriveWithNumberCauseAndHash) {
  Message message = Blank();
  message.number = 77;
  message.cause = 76;
  message.sender = 1;
  message.target = 1;
  message.selector = 9;
  message.reply_box = 4;
  message.is_reply = true;
  message.kind = PayloadKind::kHashed;
  message.payload_hash = 0x123456789abcdefull;
  message.size = 5;
  std::memcpy(message.payload, "h\0llo", 5);
  Message out;
  ASSERT_EQ(Carry(message, &out), "");
  EXPECT_EQ(out.number, 77u);
  EXPECT_EQ(out.cause, 76u);
  EXPECT_EQ(out.sender, 1);
  EXPECT_EQ(out.target, 1);
  EXPECT_EQ(out.selector, 9u);
  EXPECT_EQ(out.reply_box, 4u);
  EXPECT_TRUE(out.is_reply);
  EXPECT_EQ(out.kind, PayloadKind::kHashed);
  EXPECT_EQ(out.payload_hash, message.payload_hash);
  EXPECT_EQ(std::string(reinterpret_cast<char*>(out.payload), out.size), std::string("h\0llo", 5));
}

TEST_F(MarshallerTest, ANotificationBringsItsMemoryAndTheReadyReturnsIt) {
  RCRegion* const small = NewRegion("words");
  RCRegion* const large = NewRegion("picture", 1 << 20);
  Message out;
  ASSERT_EQ(Carry(Notification({small, large}), &out), "");
  EXPECT_TRUE(ours.HasExported(small->MemID()));
  EXPECT_TRUE(ours.HasExported(large->MemID()));
  const ONotifyMessage& notify = NotifyOf(out);
  ASSERT_EQ(notify.numOfData, 2);
  EXPECT_EQ(notify.data[1].size, size_t{1} << 20);
  RCRegion* const first = notify.data[0].srcRCR;
  RCRegion* const second = notify.data[1].srcRCR;
  EXPECT_NE(first, small);
  EXPECT_EQ(first->MemID(), small->MemID());
  EXPECT_EQ(std::string(first->Base(), first->Size()), "words");
  EXPECT_EQ(std::memcmp(second->Base(), large->Base(), large->Size()), 0);
  EXPECT_TRUE(theirs.HasImported(small->MemID()));

  const Message answer = Answer({second, first});
  openr_wire_Message back{};
  theirs.Encode(answer, nullptr, &arena, &back);
  Message ready = Blank();
  ASSERT_EQ(ours.Decode(back, &ready), "");
  theirs.CompleteSend(answer);
  ASSERT_EQ(ReadyOf(ready).numOfData, 2);
  EXPECT_EQ(ReadyOf(ready).msgType, omsgREADY_V22);
  EXPECT_EQ(ReadyOf(ready).rcRegion[0], large);
  EXPECT_EQ(ReadyOf(ready).rcRegion[1], small);
  EXPECT_FALSE(ours.HasExported(small->MemID()));
  EXPECT_FALSE(ours.HasExported(large->MemID()));
  EXPECT_FALSE(theirs.HasImported(small->MemID()));
  LetGo(small);
  LetGo(large);
}

// The peer may pass a region on, also after the subject that sent it was replaced.
TEST_F(MarshallerTest, ARegionOfAReplacedSubjectStaysExported) {
  RCRegion* const region = NewRegion("before");
  Message out;
  ASSERT_EQ(Carry(Notification({region}), &out), "");
  EXPECT_THAT(ours.TakeExportedBy(wire.payload._u.notify.subject), testing::ElementsAre(region));
  EXPECT_TRUE(ours.HasExported(region->MemID()));
  const Message answer = Answer({NotifyOf(out).data[0].srcRCR});
  openr_wire_Message back{};
  theirs.Encode(answer, nullptr, &arena, &back);
  Message ready = Blank();
  ASSERT_EQ(ours.Decode(back, &ready), "");
  theirs.CompleteSend(answer);
  EXPECT_FALSE(ours.HasExported(region->MemID()));
  LetGo(region);
}

// No object of the peer has the region, and no ready will return it.
TEST_F(MarshallerTest, ARegionThatThePeerDroppedIsNotExported) {
  RCRegion* const region = NewRegion("before");
  Message out;
  ASSERT_EQ(Carry(Notification({region}), &out), "");
  ours.TakeExportedBy(wire.payload._u.notify.subject);
  theirs.ReleaseImported(NotifyOf(out).data[0].srcRCR);
  ours.PeerDropped(theirs.TakeDroppedTokens());
  EXPECT_FALSE(ours.HasExported(region->MemID()));
  EXPECT_THAT(theirs.TakeDroppedTokens(), testing::IsEmpty());
  LetGo(region);
}

// An object of the peer holds the region and may pass it on.
TEST_F(MarshallerTest, APinnedRegionIsDroppedAfterItsUnpin) {
  RCRegion* const region = NewRegion("before");
  Message out;
  ASSERT_EQ(Carry(Notification({region}), &out), "");
  there.regions().Pin(region->MemID());
  theirs.ReleaseImported(NotifyOf(out).data[0].srcRCR);
  EXPECT_THAT(theirs.TakeDroppedTokens(), testing::IsEmpty());
  there.regions().Unpin(region->MemID());
  EXPECT_THAT(theirs.TakeDroppedTokens(), testing::ElementsAre(1u));
  LetGo(region);
}

TEST_F(MarshallerTest, ANewPeerHasNoRegionOfTheLostOne) {
  RCRegion* const region = NewRegion("before");
  Message out;
  ASSERT_EQ(Carry(Notification({region}), &out), "");
  ours.TakeExportedBy(wire.payload._u.notify.subject);
  ours.PeerIsLost();
  EXPECT_FALSE(ours.HasExported(region->MemID()));
  LetGo(region);
}

// The queue of the subject's object was full, so the observer keeps its regions.
TEST_F(MarshallerTest, ARefusedReadyCanBeSentAgain) {
  for (const bool is_replaced : {false, true}) {
    RCRegion* const region = NewRegion("before");
    Message out;
    ASSERT_EQ(Carry(Notification({region}), &out), "");
    if (is_replaced) ours.TakeExportedBy(wire.payload._u.notify.subject);
    const Message answer = Answer({NotifyOf(out).data[0].srcRCR});
    openr_wire_Message back{};
    theirs.Encode(answer, nullptr, &arena, &back);
    Message ready = Blank();
    ASSERT_EQ(ours.Decode(back, &ready), "");
    ours.UndoDecode();
    EXPECT_TRUE(ours.HasExported(region->MemID()));
    ready = Blank();
    EXPECT_EQ(ours.Decode(back, &ready), "");
    EXPECT_EQ(ReadyOf(ready).numOfData, is_replaced ? 0 : 1);
    EXPECT_FALSE(ours.HasExported(region->MemID()));
    theirs.CompleteSend(answer);
    LetGo(region);
  }
}

TEST_F(MarshallerTest, ARefusedNotificationIsNotImported) {
  RCRegion* const region = NewRegion("refused");
  Message out;
  ASSERT_EQ(Carry(Notification({region, region}), &out), "");
  theirs.UndoDecode();
  EXPECT_FALSE(theirs.HasImported(region->MemID()));
  EXPECT_EQ(there.regions().BaseOf(region->MemID()), nullptr);
  LetGo(region);
}

TEST_F(MarshallerTest, ADeassertForALostObserverIsMarked) {
  Message answer = Answer({});
  const_cast<OReadyMessage&>(ReadyOf(answer)).msgType = kDeassertOfLost;
  openr_wire_Message back{};
  theirs.Encode(answer, nullptr, &arena, &back);
  Message ready = Blank();
  ASSERT_EQ(ours.Decode(back, &ready), "");
  EXPECT_EQ(ReadyOf(ready).msgType, kDeassertOfLost);
}

// In the handler that received the region, the comparison is with the sample, which is still valid.
TEST_F(MarshallerTest, ARegionReturnedInTheSameHandlerIsCompared) {
  RCRegion* const written = NewRegion("before");
  RCRegion* const read = NewRegion("before");
  openr_wire_Message in{};
  ours.Encode(Notification({written, read}), nullptr, &arena, &in);
  std::vector<std::vector<uint8_t>> samples;  // the bytes of the samples, apart from the regions
  for (uint32_t i = 0; i < 2; ++i) {
    openr_wire_Bytes& bytes = in.payload._u.notify.parts._buffer[i].bytes;
    samples.emplace_back(bytes._buffer, bytes._buffer + bytes._length);
    bytes._buffer = samples.back().data();
  }
  Message out = Blank();
  ASSERT_EQ(theirs.Decode(in, &out), "");
  std::memcpy(NotifyOf(out).data[0].srcRCR->Base(), "after!", 6);
  openr_wire_Message back{};
  theirs.Encode(Answer({NotifyOf(out).data[0].srcRCR, NotifyOf(out).data[1].srcRCR}), nullptr,
                &arena, &back);
  theirs.ReleaseSample();
  const auto& returned = back.payload._u.ready.regions;
  ASSERT_EQ(returned._length, 2u);
  EXPECT_EQ(returned._buffer[0].bytes._length, 6u);
  EXPECT_EQ(returned._buffer[1].bytes._length, 0u);
  LetGo(written);
  LetGo(read);
}

TEST_F(MarshallerTest, OnlyRegionsThatTheObserverChangedComeBackWithBytes) {
  RCRegion* const written = NewRegion("before");
  RCRegion* const read = NewRegion("before");
  Message out;
  ASSERT_EQ(Carry(Notification({written, read}), &out), "");
  std::memcpy(NotifyOf(out).data[0].srcRCR->Base(), "after!", 6);
  openr_wire_Message back{};
  theirs.Encode(Answer({NotifyOf(out).data[0].srcRCR, NotifyOf(out).data[1].srcRCR}), nullptr,
                &arena, &back);
  const auto& returned = back.payload._u.ready.regions;
  ASSERT_EQ(returned._length, 2u);
  EXPECT_EQ(returned._buffer[0].bytes._length, 6u);
  EXPECT_EQ(returned._buffer[1].bytes._length, 0u);
  Message ready = Blank();
  ASSERT_EQ(ours.Decode(back, &ready), "");
  EXPECT_EQ(std::string(written->Base(), 6), "after!");
  EXPECT_EQ(std::string(read->Base(), 6), "before");
  LetGo(written);
  LetGo(read);
}

TEST_F(MarshallerTest, MemoryThatThePeerHasIsNotSent) {
  RCRegion* const region = NewRegion("known");
  ours.Encode(
      Notification({region}), [](uint32_t) { return true; }, &arena, &wire);
  EXPECT_EQ(wire.payload._u.notify.parts._buffer[0].bytes._length, 0u);
  LetGo(region);
}

TEST_F(MarshallerTest, ARegionSentTwiceIsExportedTwice) {
  RCRegion* const region = NewRegion("twice");
  Message first, second;
  ASSERT_EQ(Carry(Notification({region}), &first), "");
  ASSERT_EQ(Carry(Notification({region}), &second), "");
  EXPECT_NE(NotifyOf(first).data[0].srcRCR, NotifyOf(second).data[0].srcRCR);
  EXPECT_EQ(ours.TakeExported().size(), 2u);
  theirs.CompleteSend(Answer({NotifyOf(first).data[0].srcRCR}));
  EXPECT_TRUE(theirs.HasImported(region->MemID())) << "the second is still out";
  EXPECT_EQ(std::string(NotifyOf(second).data[0].srcRCR->Base(), 5), "twice");
  LetGo(region);
}

TEST_F(MarshallerTest, ANotificationNamesItsSubject) {
  RCRegion* const region = NewRegion("x");
  Message message = Notification({region});
  const_cast<ONotifyMessage&>(NotifyOf(message)).subjectID = OServiceEntry(OidOf(1), 5);
  const_cast<ONotifyMessage&>(NotifyOf(message)).numOfNotify = 3;
  Message out;
  ASSERT_EQ(Carry(message, &out), "");
  EXPECT_EQ(out.kind, PayloadKind::kNotify);
  EXPECT_EQ(out.size, sizeof(ONotifyMessage));
  EXPECT_EQ(NotifyOf(out).msgType, omsgNOTIFY_V22);
  EXPECT_EQ(NotifyOf(out).subjectID, SubjectID(OServiceEntry(OidOf(1), 5)));
  EXPECT_EQ(NotifyOf(out).numOfNotify, 3);
  LetGo(region);
}

TEST_F(MarshallerTest, AReadyNamesItsCommandAndObserver) {
  for (const ObjcommCommand command : {objcommCMD_ASSERT_READY, objcommCMD_DEASSERT_READY}) {
    Message answer = Answer({});
    const_cast<OReadyMessage&>(ReadyOf(answer)).command = command;
    Message out;
    ASSERT_EQ(Carry(answer, &out), "");
    EXPECT_EQ(out.kind, PayloadKind::kReady);
    EXPECT_EQ(out.size, sizeof(OReadyMessage));
    EXPECT_EQ(ReadyOf(out).command, command);
    EXPECT_EQ(ReadyOf(out).observerID, ObserverID(OServiceEntry(OidOf(1), 6)));
    EXPECT_EQ(ReadyOf(out).numOfData, 0);
  }
}

// A part that lies behind the begin of its region: only its bytes are sent.
TEST_F(MarshallerTest, APartOfARegionIsPutWhereItWas) {
  const uint32_t id = here.regions().New(16, sender->id);
  std::memcpy(here.regions().BaseOf(id), "0123456789abcdef", 16);
  RCRegion* part = nullptr;
  {
    const CurrentScope scope(&here, sender);
    part = new RCRegion(id, 4, nullptr, 6);
  }
  Message out;
  ASSERT_EQ(Carry(Notification({part}), &out), "");
  const auto& data = NotifyOf(out).data[0];
  EXPECT_EQ(data.memID, id);
  EXPECT_EQ(data.offset, 4u);
  EXPECT_EQ(data.size, 6u);
  EXPECT_EQ(std::string(data.srcRCR->Base(), 6), "456789");
  EXPECT_EQ(there.regions().SizeOf(id), 16u);
  EXPECT_EQ(data.srcRCR->Base(), there.regions().BaseOf(id) + 4);
  LetGo(part);
}

// ---- Forged samples

TEST_F(MarshallerTest, AReadyWithAnUnknownTokenIsRefused) {
  openr_wire_Message in{};
  in.payload._d = openr_wire_PAYLOAD_READY;
  auto& regions = in.payload._u.ready.regions;
  regions = arena.Sequence<std::remove_reference_t<decltype(regions)>>(
      std::vector<openr_wire_ReturnedRegion>{{0xdeadbeef, {}}});
  Message out = Blank();
  EXPECT_EQ(ours.Decode(in, &out), "a ready with an unknown region");
}

TEST_F(MarshallerTest, ATokenIsAcceptedOnce) {
  RCRegion* const region = NewRegion("once");
  Message out;
  ASSERT_EQ(Carry(Notification({region}), &out), "");
  openr_wire_Message back{};
  theirs.Encode(Answer({NotifyOf(out).data[0].srcRCR}), nullptr, &arena, &back);
  Message ready = Blank();
  EXPECT_EQ(ours.Decode(back, &ready), "");
  EXPECT_EQ(ours.Decode(back, &ready), "a ready with an unknown region");
  LetGo(region);
}

TEST_F(MarshallerTest, BytesOfAnotherSizeAreNotPutIntoARegion) {
  RCRegion* const region = NewRegion("size");
  Message out;
  ASSERT_EQ(Carry(Notification({region}), &out), "");
  openr_wire_Message back{};
  theirs.Encode(Answer({NotifyOf(out).data[0].srcRCR}), nullptr, &arena, &back);
  back.payload._u.ready.regions._buffer[0].bytes = arena.Bytes("much longer", 11);
  Message ready = Blank();
  EXPECT_EQ(ours.Decode(back, &ready), "a region of another size");
  EXPECT_EQ(std::string(region->Base(), 4), "size");
  LetGo(region);
}

TEST_F(MarshallerTest, APartBeyondItsRegionIsRefused) {
  EXPECT_EQ(Refused(Forged({1, 0x10005, 8, 4, 8, arena.Bytes("12345678", 8)})),
            "8 bytes in region 0x10005");
  EXPECT_NE(Refused(Forged({1, 0x10005, 8, 0xfffffffc, 8, {}})), "") << "the sum overflows";
  EXPECT_NE(Refused(Forged({1, 0x10005, 0xffffffff, 0, 1, {}})), "") << "more than the robot has";
  EXPECT_NE(Refused(Forged({1, 0, 8, 0, 8, {}})), "") << "no region at all";
  EXPECT_EQ(Refused(Forged({1, 0x10005, 8, 0, 8, arena.Bytes("123", 3)})),
            "a part of another size");
  EXPECT_EQ(there.regions().live_count(), 0);
}

TEST_F(MarshallerTest, TheSideThatAssignsIdsAcceptsNoUnknownId) {
  openr_wire_Message in = Forged({1, 0x10005, 8, 0, 8, {}});
  Message out = Blank();
  EXPECT_EQ(ours.Decode(in, &out), "8 bytes in region 0x10005");
}

// The id is that of a region in use here, with another generation.
TEST_F(MarshallerTest, AForgedIdDoesNotTakeAwayMemoryThatIsInUse) {
  const uint32_t mine = there.regions().New(16, 1);
  char* const base = there.regions().BaseOf(mine);
  std::memcpy(base, "still mine", 11);
  EXPECT_NE(Refused(Forged({1, mine + 0x10000, 16, 0, 16, {}})), "");
  EXPECT_EQ(there.regions().BaseOf(mine), base);
  EXPECT_STREQ(base, "still mine");
}

// The subject was replaced, and a new region got the slot of its region before the observer
// answered.
TEST_F(MarshallerTest, ImportedDataOutliveTheirRegion) {
  Message first = Blank(), second = Blank();
  ASSERT_EQ(theirs.Decode(Forged({1, 0x10005, 8, 0, 8, arena.Bytes("the old.", 8)}), &first), "");
  ASSERT_EQ(theirs.Decode(Forged({2, 0x20005, 8, 0, 8, arena.Bytes("the new.", 8)}), &second), "");
  EXPECT_EQ(std::string(NotifyOf(first).data[0].srcRCR->Base(), 8), "the old.");
  EXPECT_EQ(std::string(NotifyOf(second).data[0].srcRCR->Base(), 8), "the new.");
  theirs.CompleteSend(Answer({NotifyOf(first).data[0].srcRCR}));
  EXPECT_EQ(std::string(there.regions().BaseOf(0x20005), 8), "the new.");
}

TEST_F(MarshallerTest, TooManyPartsAreRefused) {
  EXPECT_EQ(Refused(Forged({1, 0x10005, 8, 0, 8, {}}, MAX_NUM_DATA + 1)),
            "a notification of " + std::to_string(MAX_NUM_DATA + 1) + " data");
  openr_wire_Message in{};
  in.payload._d = openr_wire_PAYLOAD_READY;
  auto& regions = in.payload._u.ready.regions;
  regions = arena.Sequence<std::remove_reference_t<decltype(regions)>>(
      std::vector<openr_wire_ReturnedRegion>(MAX_NUM_DATA + 1));
  EXPECT_EQ(Refused(in), "a ready with " + std::to_string(MAX_NUM_DATA + 1) + " regions");
}

TEST_F(MarshallerTest, MoreBytesThanAMessageHoldsAreRefused) {
  const std::string much(Message::kPayloadMax + 1, 'x');
  openr_wire_Message in{};
  in.payload._d = openr_wire_PAYLOAD_BYTES;
  in.payload._u.bytes = arena.Bytes(much.data(), much.size());
  EXPECT_EQ(Refused(in), std::to_string(much.size()) + " bytes");
  in.payload._d = openr_wire_PAYLOAD_ANT;
  in.payload._u.ant = {arena.Bytes(much.data(), much.size()), 0, 0, {}};
  EXPECT_EQ(Refused(in), "a network message of " + std::to_string(much.size()) + " bytes");
  in.payload._u.ant.message = arena.Bytes("x", 1);
  EXPECT_EQ(Refused(in), "a network message of 1 bytes");
}

}  // namespace
}  // namespace openr_host

// A forged worker sends what no real one would: the run reports the loss and goes on.
#include "tests/distribution/forged.h"

#include <OPENR/ObjcommMessages.h>

#include <cstring>
#include <new>

namespace openr_host {
namespace {

using ::testing::HasSubstr;

// Changes the posted message of `to_master` to an entry that its receiver does not have.
openr_wire_ToMaster ToMissingEntry(const openr_wire_ToMaster& to_master) {
  to_master.effects._buffer[0]._u.posted.message.selector = 77;
  return to_master;
}

TEST_F(ForgedTest, ValidSamplesCauseNoLoss) {
  EXPECT_EQ(LossBy(Stopped()), "");
  EXPECT_EQ(LossBy(Note<&SystemCalls::DeleteRegion>({region_there_})), "");
  EXPECT_EQ(system_.regions().BaseOf(region_there_), nullptr);
}

TEST_F(ForgedTest, TheLossNamesTheProcess) {
  EXPECT_EQ(
      LossBy(New(openr_wire_TO_MASTER_STATE)),
      "process 'liar' (pid 4711) sent something in the middle of a handler; is it the same openr?");
}

TEST_F(ForgedTest, TheEndOfAnotherObjectsHandler) {
  openr_wire_ToMaster to_master = Stopped();
  to_master.body._u.stopped.object = sender_->host().id;
  EXPECT_THAT(LossBy(to_master), HasSubstr("the end of another object's handler"));
}

TEST_F(ForgedTest, AQuestionInTheNameOfAnother) {
  EXPECT_THAT(LossBy(Ask<&SystemCalls::NewRegion>(sender_->host().id, {16, 1})),
              HasSubstr("a request of an object that is not its own"));
}

TEST_F(ForgedTest, AMessageInTheNameOfNobody) {
  openr_wire_ToMaster to_master = New(openr_wire_TO_MASTER_POST);
  to_master.body._u.post.object = kNobody;
  to_master.body._u.post.posted.message = Message(openr_wire_PAYLOAD_BYTES);
  EXPECT_THAT(LossBy(to_master), HasSubstr("a request of an object that is not its own"));
}

TEST_F(ForgedTest, AnUnknownNote) { EXPECT_THAT(LossBy(NoteOf(77, {})), HasSubstr("note 77")); }

TEST_F(ForgedTest, TheRegionOfAnother) {
  EXPECT_THAT(LossBy(Note<&SystemCalls::DeleteRegion>({region_here_})),
              HasSubstr("the end of a region that is not its own"));
  EXPECT_NE(system_.regions().BaseOf(region_here_), nullptr);
}

TEST_F(ForgedTest, TakingTheRegionOfAnother) {
  const auto self = static_cast<uint64_t>(remote_->id);
  Deliver({Ask<&SystemCalls::AllowAccess>(remote_->id, {region_here_, MEMPROTINFO_RW, self, 1}),
           Stopped()});
  EXPECT_EQ(system_.regions().OwnerOf(region_here_), sender_->host().id);
}

TEST_F(ForgedTest, ARegionGivenBackTwice) {
  EXPECT_THAT(LossBy(Note<&SystemCalls::UnpinRegion>({region_here_})),
              HasSubstr("a region given back twice"));
}

TEST_F(ForgedTest, ARobotThatIsNotThere) {
  EXPECT_THAT(LossBy(Note<&SystemCalls::PowerOff>({std::numeric_limits<uint64_t>::max()})),
              HasSubstr("an unknown robot"));
  EXPECT_FALSE(system_.powered_off());
}

TEST_F(ForgedTest, AReplyBoxThatNoObjectReaches) {
  EXPECT_EQ(LossBy(Note<&SystemCalls::OpenBox>({kFirstWakeBox - 1})), "");
  EXPECT_THAT(LossBy(Note<&SystemCalls::OpenBox>({std::numeric_limits<uint64_t>::max()})),
              HasSubstr("the reply box 18446744073709551615"));
  EXPECT_EQ(remote_->boxes().last(), kFirstWakeBox - 1);
}

TEST_F(ForgedTest, AWakeBox) {
  EXPECT_THAT(LossBy(Note<&SystemCalls::OpenBox>({kFirstWakeBox})), HasSubstr("the reply box"));
}

TEST_F(ForgedTest, ANotificationFromARegionThatIsNotThere) {
  EXPECT_THAT(LossBy(Notify({{1, kNoRegion, kBytes, 0, kBytes, {}}})),
              HasSubstr("16 bytes in region 0x70007"));
}

TEST_F(ForgedTest, ANotificationFromBeyondItsRegion) {
  EXPECT_THAT(LossBy(Notify({{1, region_there_, kBytes, kBytes - 1, 2, {}}})),
              HasSubstr("2 bytes in region"));
}

// Offset plus size is 0 in 32 bits.
TEST_F(ForgedTest, ANotificationFromFarBeyondItsRegion) {
  const uint32_t offset = 0xfffffff0;
  EXPECT_THAT(LossBy(Notify({{1, region_there_, 0xffffffff, offset, 0x10, {}}})),
              HasSubstr("16 bytes in region"));
}

TEST_F(ForgedTest, ANotificationWithBytesOfAnotherSize) {
  const std::string bytes(kBytes, 'x');
  EXPECT_THAT(LossBy(Notify({{1, region_there_, kBytes, 0, kBytes - 1,
                              WireArena::View(bytes.data(), bytes.size())}})),
              HasSubstr("a part of another size"));
}

TEST_F(ForgedTest, ANotificationOfTooManyRegions) {
  const openr_wire_NotifiedRegion part = {1, region_there_, kBytes, 0, kBytes, {}};
  EXPECT_THAT(LossBy(Notify(std::vector<openr_wire_NotifiedRegion>(1000, part))),
              HasSubstr("a notification of 1000 data"));
}

TEST_F(ForgedTest, ANotificationThatCountsWrong) {
  EXPECT_THAT(LossBy(Notify({}, 0xffffffff)), HasSubstr("a notification of"));
}

TEST_F(ForgedTest, AReadyWithATokenOfItsOwnMaking) {
  EXPECT_THAT(LossBy(Ready({{99, {}}})), HasSubstr("a ready with an unknown region"));
}

TEST_F(ForgedTest, AReadyWithTooManyRegions) {
  EXPECT_THAT(LossBy(Ready(std::vector<openr_wire_ReturnedRegion>(1000))),
              HasSubstr("a ready with 1000 regions"));
}

// A real worker sends such a ready again, when the subject has the entry or room for it.
TEST_F(ForgedTest, ARefusedReadyGivesNothingBack) {
  RCRegion* region = nullptr;
  {
    const CurrentScope scope(&system_, &sender_->host());
    region = new RCRegion(kBytes);
  }
  const uint32_t id = region->MemID();
  openr_host::Message notification;
  std::memset(notification.payload, 0, sizeof notification.payload);
  auto& notify = *new (notification.payload) ONotifyMessage;
  notify.subjectID = sender_->out->GetID();
  notify.numOfNotify = notify.numOfData = 1;
  notify.data[0].srcRCR = region;
  notify.data[0].memID = id;
  notify.data[0].offset = 0;
  notify.data[0].size = kBytes;
  notification.size = sizeof notify;
  notification.kind = PayloadKind::kNotify;
  Marshaller* const marshaller = process_.resources().marshaller();
  openr_wire_Message wire{};
  marshaller->Encode(notification, nullptr, &arena_, &wire);
  const uint64_t token = wire.payload._u.notify.parts._buffer[0].token;

  EXPECT_EQ(LossBy(ToMissingEntry(Ready({{token, {}}}))), "");
  EXPECT_TRUE(marshaller->HasExported(id));
  EXPECT_EQ(LossBy(Ready({{token, {}}})), "");
  EXPECT_FALSE(marshaller->HasExported(id));
}

TEST_F(ForgedTest, ARefusedNotificationBringsNothing) {
  EXPECT_EQ(LossBy(ToMissingEntry(Notify({{1, region_there_, kBytes, 0, kBytes, {}}}))), "");
  EXPECT_FALSE(process_.resources().marshaller()->HasImported(region_there_));
}

TEST_F(ForgedTest, AMessageThatIsTooLong) {
  const std::string bytes(1 << 20, 'x');
  openr_wire_Message message = Message(openr_wire_PAYLOAD_BYTES);
  message.payload._u.bytes = WireArena::View(bytes.data(), bytes.size());
  EXPECT_THAT(LossBy(Post(message)), HasSubstr("1048576 bytes"));
}

TEST_F(ForgedTest, ANetworkMessageThatIsTooShort) {
  const std::string bytes(3, 'x');
  openr_wire_Message message = Message(openr_wire_PAYLOAD_ANT);
  message.payload._u.ant.message = WireArena::View(bytes.data(), bytes.size());
  EXPECT_THAT(LossBy(Post(message)), HasSubstr("a network message of 3 bytes"));
}

TEST_F(ForgedTest, AMessageForThePast) {
  EXPECT_THAT(LossBy(Post(Message(openr_wire_PAYLOAD_BYTES), -1)),
              HasSubstr("a message for another time"));
}

TEST_F(ForgedTest, AMessageForTheEndOfTime) {
  const int64_t never_us = std::numeric_limits<int64_t>::max();
  EXPECT_THAT(LossBy(Post(Message(openr_wire_PAYLOAD_BYTES), never_us)),
              HasSubstr("a message for another time"));
}

TEST_F(ForgedTest, AWaitUntilTheEndOfTime) {
  openr_wire_ToMaster to_master = Stopped();
  to_master.body._u.stopped.kind = openr_wire_STOP_WAITS;
  to_master.body._u.stopped.timeout_us = std::numeric_limits<int64_t>::max();
  EXPECT_THAT(LossBy(to_master), HasSubstr("a wait until another time"));
}

// ---- Samples that change nothing

TEST_F(ForgedTest, MessagesAndRepliesToNobodyAreIgnored) {
  openr_wire_Message message = Message(openr_wire_PAYLOAD_BYTES);
  message.target = kNobody;
  EXPECT_EQ(LossBy(Post(message)), "");
  message.is_reply = true;
  message.reply_box = 7;
  EXPECT_EQ(LossBy(Post(message)), "");
  message.target = sender_->host().id;
  EXPECT_EQ(LossBy(Post(message)), "");
  message.target = -1;
  EXPECT_EQ(LossBy(Post(message)), "");
}

TEST_F(ForgedTest, NumbersOutOfAllRangesChangeNothing) {
  const uint64_t huge = std::numeric_limits<uint64_t>::max();
  for (const uint64_t number : {uint64_t{kNoRegion}, huge, uint64_t{1} << 40}) {
    for (const uint32_t function : {WorkerCallList::NumberOf<&SystemCalls::PinRegion>(),
                                    WorkerCallList::NumberOf<&CheckedCalls::AddFindingAbout>(),
                                    WorkerCallList::NumberOf<&SystemCalls::CloseBox>(),
                                    WorkerCallList::NumberOf<&SystemCalls::NoteMapping>()}) {
      EXPECT_EQ(LossBy(NoteOf(function, {number, number, number})), "");
    }
  }
}

TEST_F(ForgedTest, QuestionsOutOfAllRangesAreAnswered) {
  const uint64_t huge = std::numeric_limits<uint64_t>::max();
  const std::set<uint32_t> refused = {WorkerCallList::NumberOf<&SystemCalls::DeleteRegion>(),
                                      WorkerCallList::NumberOf<&SystemCalls::UnpinRegion>(),
                                      WorkerCallList::NumberOf<&SystemCalls::OpenBox>(),
                                      WorkerCallList::NumberOf<&SystemCalls::Shutdown>(),
                                      WorkerCallList::NumberOf<&SystemCalls::PowerOff>()};
  for (uint32_t function = 0; function <= WorkerCallList::kSize; ++function) {
    if (refused.contains(function)) continue;  // a loss, see the tests above
    SCOPED_TRACE(function);
    for (const std::vector<uint64_t>& numbers :
         {std::vector<uint64_t>{}, {huge, huge, huge, huge, huge}, {kNobody, kNobody, 1, 1, 1}}) {
      Deliver({AskOf(remote_->id, function, numbers, "../../name"), Stopped()});
      ASSERT_TRUE(losses_.empty()) << losses_[0];
    }
  }
}

TEST_F(ForgedTest, ItsOwnRegionMayShrink) {
  Deliver({Ask<&SystemCalls::ResizeRegion>(remote_->id, {region_there_, 4}), Stopped()});
  EXPECT_EQ(system_.regions().SizeOf(region_there_), 4u);
}

TEST_F(ForgedTest, AnotherObjectsRegionKeepsItsSize) {
  Deliver({Ask<&SystemCalls::ResizeRegion>(remote_->id, {region_here_, 4}), Stopped()});
  EXPECT_EQ(system_.regions().SizeOf(region_here_), kBytes);
}

}  // namespace
}  // namespace openr_host

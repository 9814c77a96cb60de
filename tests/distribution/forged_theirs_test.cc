// A forged worker speaks in the name of other objects or names regions of others; and its state and
// list of loaded objects.
#include <OPENR/ObjcommMessages.h>
#include <fmt/format.h>

#include "tests/distribution/forged.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

class ForgedTheirsTest : public ForgedTest {
 protected:
  // Sends the worker's object a notification with region_here_.
  void Lend() {
    const CurrentScope scope(&system_, &sender_->host());
    OwnedMessage message = system_.NewMessage(remote_->id, kEntry);
    auto& notify = *new (message->payload) ONotifyMessage();
    notify.msgType = omsgNOTIFY_V22;
    notify.subjectID = OServiceEntry(OidOf(sender_->host().id), 5);
    notify.numOfNotify = notify.numOfData = 1;
    notify.data[0].srcRCR =
        new RCRegion(region_here_, 0, system_.regions().BaseOf(region_here_), kBytes);
    notify.data[0].memID = region_here_;
    notify.data[0].size = kBytes;
    message->size = sizeof notify;
    message->kind = PayloadKind::kNotify;
    system_.Post(std::move(message));
    system_.RunFor(1000);
  }
};

TEST_F(ForgedTheirsTest, AMessageFromAnother) {
  for (const int32_t sender : {sender_->host().id, kObjectManager}) {
    openr_wire_Message message = Message(openr_wire_PAYLOAD_BYTES);
    message.sender = sender;
    EXPECT_THAT(LossBy(Post(message)), HasSubstr("a message in the name of another object"));
  }
}

TEST_F(ForgedTheirsTest, ANotificationOfAnothersSubject) {
  openr_wire_Message message = Message(openr_wire_PAYLOAD_NOTIFY);
  message.payload._u.notify.subject = sender_->host().id;
  EXPECT_THAT(LossBy(Post(message)), HasSubstr("a notification of another object's subject"));
}

TEST_F(ForgedTheirsTest, AReadyOfAnothersObserver) {
  openr_wire_Message message = Message(openr_wire_PAYLOAD_READY);
  message.payload._u.ready.observer = sender_->host().id;
  EXPECT_THAT(LossBy(Post(message)), HasSubstr("a ready of another object's observer"));
}

TEST_F(ForgedTheirsTest, ANotificationThatWritesIntoTheRegionOfAnother) {
  const std::string bytes(kBytes, 'x');
  EXPECT_THAT(LossBy(Notify({{1, region_here_, kBytes, 0, kBytes,
                              WireArena::View(bytes.data(), bytes.size())}})),
              HasSubstr("which it has not"));
  EXPECT_EQ(TextHere(), std::string(kBytes, '\0'));
}

TEST_F(ForgedTheirsTest, ANotificationWithTheRegionOfAnother) {
  EXPECT_THAT(LossBy(Notify({{1, region_here_, kBytes, 0, kBytes, {}}})),
              HasSubstr("which it has not"));
}

// The region was sent to the worker.  When its subject was replaced, the worker dropped it.
TEST_F(ForgedTheirsTest, ANotificationWithARegionThatItHasDropped) {
  const ObjectId sender = sender_->host().id;
  for (const bool is_dropped : {false, true}) {
    channel_->Send(Stopped());
    Lend();
    openr_wire_ToMaster to_master = New(openr_wire_TO_MASTER_FORGOTTEN);
    to_master.body._u.forgotten.object = sender;
    if (is_dropped) to_master.body._u.forgotten.dropped = arena_.Numbers({1, 2});
    EXPECT_EQ(LossBy(to_master, [&] { process_.Forget(sender); }), "");
    const std::string loss = LossBy(Notify({{1, region_here_, kBytes, 0, kBytes, {}}}));
    EXPECT_EQ(loss.find("which it has not") != std::string::npos, is_dropped) << loss;
  }
}

// The worker is to take back the data of a notification, and answers something else, or in the name
// of another object.
TEST_F(ForgedTheirsTest, AnotherAnswerThanThatItHasTakenDataBack) {
  const OwnedMessage refused = system_.NewMessage(sender_->host().id, kEntry);
  auto& notify = *new (refused->payload) ONotifyMessage;
  notify.numOfData = 0;
  notify.numOfNotify = 1;
  const auto take_back = [&] {
    bool is_ready = false;
    process_.TakeBack(remote_, *refused, &is_ready);
  };
  EXPECT_THAT(LossBy(Stopped(), take_back), HasSubstr("when it was to take data back"));
  openr_wire_ToMaster to_master = New(openr_wire_TO_MASTER_TOOK_BACK);
  to_master.body._u.took_back.object = sender_->host().id;
  EXPECT_THAT(LossBy(to_master, take_back), HasSubstr("when it was to take data back"));
}

TEST_F(ForgedTheirsTest, NetworkDataInTheRegionOfAnother) {
  const std::string bytes(sizeof(antEnvMsg), '\0');
  openr_wire_Message message = Message(openr_wire_PAYLOAD_ANT);
  message.payload._u.ant.message = WireArena::View(bytes.data(), bytes.size());
  message.payload._u.ant.region = region_here_;
  EXPECT_THAT(LossBy(Post(message)), HasSubstr("which it has not"));
}

TEST_F(ForgedTheirsTest, TheEndOfAnotherRobot) {
  system_.AddRobot("ERS-210", nullptr);
  EXPECT_THAT(LossBy(Note<&SystemCalls::PowerOff>({1})), HasSubstr("the end of another robot"));
  EXPECT_FALSE(system_.robot(1).powered_off);
}

TEST_F(ForgedTheirsTest, OnlyTheSystemTellsTheObjectManagerWhatToDo) {
  for (uint32_t selector = oentryBASE; selector < oentryBASE + 4; ++selector) {
    openr_wire_Message message = Message(openr_wire_PAYLOAD_BYTES);
    message.target = kObjectManager;
    message.selector = selector;
    EXPECT_EQ(LossBy(Post(message)), "");
    EXPECT_THAT(system_.findings().all().back().text,
                HasSubstr(system_.object(kObjectManager)->EntryName(selector)));
    EXPECT_EQ(system_.findings().all().back().object, "Remote");
  }
  EXPECT_EQ(system_.findings().all().size(), 4u);
  EXPECT_FALSE(system_.powered_off());
}

TEST_F(ForgedTheirsTest, AFindingOfAnUnknownSeverityIsAnError) {
  EXPECT_EQ(LossBy(Note<&CheckedCalls::AddFindingAbout>({0, 77})), "");
  EXPECT_EQ(system_.findings().all().back().severity, Severity::kError);
}

TEST_F(ForgedTheirsTest, ANewRegionForAnother) {
  const int count = system_.regions().CountOf(sender_->host().id);
  const auto here = static_cast<uint64_t>(sender_->host().id);
  Deliver({Ask<&SystemCalls::NewRegion>(remote_->id, {kBytes, here}), Stopped()});
  EXPECT_EQ(system_.regions().CountOf(sender_->host().id), count);
}

TEST_F(ForgedTheirsTest, AServiceOfAnUnknownObject) {
  for (const int32_t target : {kNobody, sender_->host().id}) {
    const auto number = static_cast<uint64_t>(target);
    Deliver(
        {Ask<&SystemCalls::RegisterService>(remote_->id, {number, kEntry}, "A.B.C.S"), Stopped()});
    EXPECT_FALSE(system_.robot(0).directory.contains("A.B.C.S"));
  }
}

TEST_F(ForgedTheirsTest, AColourTableInTheRegionOfAnother) {
  const std::string bytes(kBytes, 'x');
  for (const uint32_t region : {region_here_, region_there_}) {
    openr_wire_ToMaster to_master = Ask<&CheckedCalls::SetCdtVectorData>(remote_->id, {region});
    to_master.body._u.question.bytes = WireArena::View(bytes.data(), bytes.size());
    Deliver({to_master, Stopped()});
  }
  EXPECT_EQ(TextHere(), std::string(kBytes, '\0'));
  EXPECT_EQ(std::string(system_.regions().BaseOf(region_there_), kBytes), bytes);
}

// ---- The state and the loaded objects

TEST_F(ForgedTheirsTest, AValidStateIsAccepted) {
  const std::string bytes(kBytes, 'x');
  EXPECT_EQ(LossByState(State(region_there_, bytes)), "");
  EXPECT_EQ(std::string(system_.regions().BaseOf(region_there_), kBytes), bytes);
}

TEST_F(ForgedTheirsTest, AStateWithTheRegionOfAnother) {
  EXPECT_THAT(LossByState(State(region_here_, std::string(kBytes, 'x'))),
              HasSubstr("which is not its own"));
  EXPECT_EQ(TextHere(), std::string(kBytes, '\0'));
}

TEST_F(ForgedTheirsTest, AStateOfAnotherSize) {
  EXPECT_THAT(LossByState(State(region_there_, "x")),
              HasSubstr(fmt::format("which has {} bytes", kBytes)));
  EXPECT_THAT(LossByState(State(kNoRegion, "x")), HasSubstr("which does not exist"));
}

TEST_F(ForgedTheirsTest, NoState) { EXPECT_THAT(LossByState(Stopped()), HasSubstr("no state")); }

TEST_F(ForgedTheirsTest, AValidListOfLoadedObjectsIsAccepted) {
  EXPECT_EQ(LossByLoaded(Loaded({remote_->id})), "");
  EXPECT_FALSE(remote_->HasEntry(kEntry));
}

// Constructors act for their own object only, also while another object of the worker exists.
TEST_F(ForgedTheirsTest, ConstructorsSendInTheNameOfAnother) {
  openr_wire_Message message = Message(openr_wire_PAYLOAD_BYTES);
  message.sender = sender_->host().id;
  openr_wire_ToMaster to_master = Loaded({remote_->id});
  to_master.effects = Post(message).effects;
  EXPECT_THAT(LossByLoaded(to_master), HasSubstr("a message in the name of another object"));
  EXPECT_FALSE(remote_->delivery().is_busy());
}

// The second sample would be the answer if the master asked the worker to take the notification
// back: it would lose the worker then, in the middle of the first sample.
TEST_F(ForgedTheirsTest, ConstructorsNotifyAnEntryThatIsNotThere) {
  openr_wire_ToMaster to_master = Loaded({remote_->id});
  to_master.effects = Notify({}).effects;
  to_master.effects._buffer[0]._u.posted.message.selector = 60'000;
  EXPECT_THAT(LossBy(to_master,
                     [this] {
                       channel_->Send(Stopped());
                       LoadRemote();
                     }),
              HasSubstr("a notification or a ready of a constructor"));
  EXPECT_TRUE(losses_.empty());
}

TEST_F(ForgedTheirsTest, ConstructorsAssertReady) {
  openr_wire_ToMaster to_master = Loaded({remote_->id});
  to_master.effects = Ready({}).effects;
  EXPECT_THAT(LossByLoaded(to_master), HasSubstr("a notification or a ready of a constructor"));
}

// The reply box of a request that a constructor has sent is open when the object is loaded.
TEST_F(ForgedTheirsTest, ConstructorsOpenReplyBoxes) {
  openr_wire_ToMaster to_master = Loaded({remote_->id});
  to_master.effects = Note<&SystemCalls::OpenBox>({1}).effects;
  EXPECT_EQ(LossByLoaded(to_master), "");
  EXPECT_TRUE(remote_->boxes().IsOpen(1));
}

TEST_F(ForgedTheirsTest, AnObjectOfAnotherWasLoaded) {
  EXPECT_THAT(LossByLoaded(Loaded({remote_->id, sender_->host().id})),
              HasSubstr("an object that is not its own"));
}

TEST_F(ForgedTheirsTest, AnObjectWasLoadedTwice) {
  EXPECT_THAT(LossByLoaded(Loaded({remote_->id, remote_->id})), HasSubstr("or sent it twice"));
}

TEST_F(ForgedTheirsTest, AnObjectWasNotLoaded) {
  EXPECT_THAT(LossByLoaded(Loaded({})), HasSubstr("nothing of an object that it was to load"));
}

TEST_F(ForgedTheirsTest, NothingWasLoaded) {
  EXPECT_THAT(LossByLoaded(Stopped()), HasSubstr("no list of its objects"));
}

}  // namespace
}  // namespace openr_host

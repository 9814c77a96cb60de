// A forged master sends what no real one would: openr join ends with a reason.
#include <gmock/gmock.h>

#include <limits>

#include "distribution/bus.h"
#include "distribution/process_slot.h"
#include "tests/distribution/same_run.h"
#include "tests/distribution/wait_until.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

class ForgedMasterTest : public testing::Test {
 protected:
  ForgedMasterTest()
      : run_({"join", "--process", "victim", "--session", "now", "--run-name", Options().run}) {
    slot_.OpenSession("now");
    for (int i = 0; i < 1000 && !slot_.AwaitJoin(10); ++i) {
    }
    EXPECT_TRUE(slot_.has_joined()) << run_.heard();
  }
  static BusOptions Options() {
    BusOptions options;
    options.run = "forged-master-" + std::to_string(getpid());
    return options;
  }
  static openr_wire_ToWorker New(openr_wire_ToWorkerKind kind) {
    openr_wire_ToWorker to_worker{};
    to_worker.body._d = kind;
    return to_worker;
  }
  void Welcome(uint32_t version = openr_wire_VERSION) {
    openr_wire_ToWorker to_worker = New(openr_wire_TO_WORKER_WELCOME);
    to_worker.body._u.welcome.version = version;
    to_worker.body._u.welcome.stick = arena_.Text(OPENR_STICK);
    slot_.channel()->Send(to_worker);
  }
  // Makes a message to the object manager, which every System has.
  static openr_wire_ToWorker Deliver(openr_wire_PayloadKind kind) {
    openr_wire_ToWorker to_worker = New(openr_wire_TO_WORKER_DELIVER);
    openr_wire_Message& message = to_worker.body._u.deliver.message;
    message.sender = -1;
    message.payload._d = kind;
    return to_worker;
  }
  openr_wire_ToWorker Load(const std::vector<openr_wire_ObjectEntry>& entries) {
    openr_wire_ToWorker to_worker = New(openr_wire_TO_WORKER_LOAD);
    auto& objects = to_worker.body._u.load.objects;
    objects = arena_.Sequence<std::remove_reference_t<decltype(objects)>>(entries);
    return to_worker;
  }
  char* Nothing() { return arena_.Text(""); }
  // Returns what openr join prints when it has received `to_worker`.
  std::string EndBy(const openr_wire_ToWorker& to_worker) {
    Welcome();
    slot_.channel()->Send(to_worker);
    const ProgramResult& result = run_.Finish();
    EXPECT_EQ(result.status, 1) << result.err;
    return result.err;
  }

  Bus bus_{Options()};
  ProcessSlot slot_{&bus_, "victim", false};
  WireArena arena_;
  ProgramRun run_;
};

TEST_F(ForgedMasterTest, AnotherVersion) {
  Welcome(4711);
  const ProgramResult& result = run_.Finish();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("the master speaks version 4711"));
}

TEST_F(ForgedMasterTest, AnAnswerToNothing) {
  EXPECT_THAT(EndBy(New(openr_wire_TO_WORKER_ANSWER)),
              HasSubstr("the master says what was not asked"));
}

TEST_F(ForgedMasterTest, AMessageToNobody) {
  openr_wire_ToWorker to_worker = Deliver(openr_wire_PAYLOAD_BYTES);
  to_worker.body._u.deliver.message.target = 4242;
  EXPECT_THAT(EndBy(to_worker), HasSubstr("a message to an object that is not there"));
}

TEST_F(ForgedMasterTest, AMessageThatIsTooLong) {
  const std::string bytes(1 << 20, 'x');
  openr_wire_ToWorker to_worker = Deliver(openr_wire_PAYLOAD_BYTES);
  to_worker.body._u.deliver.message.payload._u.bytes = WireArena::View(bytes.data(), bytes.size());
  EXPECT_THAT(EndBy(to_worker), HasSubstr("a malformed message: 1048576 bytes"));
}

TEST_F(ForgedMasterTest, AReadyWithATokenOfItsOwnMaking) {
  openr_wire_ToWorker to_worker = Deliver(openr_wire_PAYLOAD_READY);
  auto& regions = to_worker.body._u.deliver.message.payload._u.ready.regions;
  regions = arena_.Sequence<std::remove_reference_t<decltype(regions)>>(
      std::vector<openr_wire_ReturnedRegion>{{99, {}}});
  EXPECT_THAT(EndBy(to_worker), HasSubstr("a malformed message: a ready with an unknown region"));
}

TEST_F(ForgedMasterTest, DataOfNobodyToTakeBack) {
  openr_wire_ToWorker to_worker = New(openr_wire_TO_WORKER_TAKE_BACK);
  to_worker.body._u.take_back.message.target = 4242;
  EXPECT_THAT(EndBy(to_worker), HasSubstr("data of an object that is not there"));
}

TEST_F(ForgedMasterTest, DataToTakeBackThatAreNotInAReady) {
  openr_wire_ToWorker to_worker = New(openr_wire_TO_WORKER_TAKE_BACK);
  to_worker.body._u.take_back.notifications = 1;
  EXPECT_THAT(EndBy(to_worker), HasSubstr("malformed data to take back"));
}

TEST_F(ForgedMasterTest, DataOfNoNotificationToTakeBack) {
  openr_wire_ToWorker to_worker = New(openr_wire_TO_WORKER_TAKE_BACK);
  to_worker.body._u.take_back.message.payload._d = openr_wire_PAYLOAD_READY;
  EXPECT_THAT(EndBy(to_worker), HasSubstr("malformed data to take back"));
}

// No memory is allocated for the region.
TEST_F(ForgedMasterTest, ARegionLargerThanTheRobot) {
  openr_wire_ToWorker to_worker = Deliver(openr_wire_PAYLOAD_NOTIFY);
  auto& parts = to_worker.body._u.deliver.message.payload._u.notify.parts;
  parts = arena_.Sequence<std::remove_reference_t<decltype(parts)>>(
      std::vector<openr_wire_NotifiedRegion>{{1, 0x10001, 0xffffffff, 0, 16, {}}});
  EXPECT_THAT(EndBy(to_worker), HasSubstr("a malformed message: 16 bytes in region 0x10001"));
}

TEST_F(ForgedMasterTest, AnObjectOfARobotThatIsNotThere) {
  EXPECT_THAT(EndBy(Load({{1, 77, Nothing(), Nothing(), false, false, false, 0}})),
              HasSubstr("something of a robot that is not there"));
}

TEST_F(ForgedMasterTest, AnObjectBeforeTheOthers) {
  EXPECT_THAT(EndBy(Load({{4242, 0, Nothing(), Nothing(), false, false, false, 0}})),
              HasSubstr("an object before those that come first"));
}

TEST_F(ForgedMasterTest, ADesignOfARobotThatIsNotThere) {
  openr_wire_ToWorker to_worker = New(openr_wire_TO_WORKER_LOAD);
  auto& designs = to_worker.body._u.load.designs;
  designs = arena_.Sequence<std::remove_reference_t<decltype(designs)>>(
      std::vector<openr_wire_DesignEntry>{{-1, Nothing(), Nothing()}});
  EXPECT_THAT(EndBy(to_worker), HasSubstr("something of a robot that is not there"));
}

// Other processes of the name ask, too, and all of them hear all answers.
TEST(JoinAnswerTest, AnswersToOthersTakeNoTimeFromTheWait) {
  BusOptions options;
  options.run = "answers-" + std::to_string(getpid());
  Bus bus(options);
  MasterJoinChannel channel(&bus, "victim", ChannelEnd::kMaster, kJoinTopics);
  ProgramRun join({"join", "--process", "victim", "--run-name", options.run, "--wait", "30s"});
  const auto request = channel.Receive(60'000);
  ASSERT_TRUE(static_cast<bool>(request)) << join.heard();
  WaitUntil("the requester", [&channel] { return channel.IsConnected(); });
  WireArena arena;
  openr_wire_JoinAnswer answer{};
  answer.id = arena.Text("another");
  answer.session = arena.Text("");
  answer.refusal = arena.Text("not for this one");
  for (int i = 0; i < 100; ++i) channel.Send(answer);
  answer.id = arena.Text(StringOf(request->id));
  answer.refusal = arena.Text("the run is full");
  channel.Send(answer);
  const ProgramResult& result = join.Finish();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("the run is full"));
}

}  // namespace
}  // namespace openr_host

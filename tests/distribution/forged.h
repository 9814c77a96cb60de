// A worker played by the test, which sends what no real worker would.
#pragma once

#include <OPENR/RCRegion.h>
#include <antEnvMsg.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "distribution/remote_object.h"
#include "distribution/remote_process.h"
#include "distribution/worker_call_list.h"
#include "runtime/core/api.h"
#include "tests/distribution/wait_until.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {

constexpr uint32_t kEntry = 9;  // an entry of the remote object
constexpr uint32_t kBytes = 16;
constexpr int32_t kNobody = 4242;
constexpr uint32_t kNoRegion = 0x70007;
constexpr ObjectId kObjectManager = 0;

// A booted System with one object in this process and one in a worker that the test plays.
class ForgedTest : public ::testing::Test {
 protected:
  ForgedTest() {
    system_.AddRobot("ERS-210", nullptr);
    sender_ = system_.AddObject<SubjectProbe>(0, "sender");
    system_.Boot();
    system_.RunFor(1000);
    auto remote = std::make_unique<RemoteObject>(
        &system_, system_.object_table().NextId(), 0, &process_,
        [this](const RemoteObject*, RemoteObject::Loss, const std::string& why) {
          losses_.push_back(why);
          process_.ReleaseAll();
        });
    remote->name = "Remote";
    remote->set_selectors({0, 1, 2, 3, kEntry});
    remote_ = remote.get();
    Come();
    process_.resources().Add(remote_);
    system_.object_table().Adopt(std::move(remote));
    region_here_ = system_.regions().New(kBytes, sender_->host().id);
    region_there_ = system_.regions().New(kBytes, remote_->id);
  }
  // Returns why the worker has ended; "" if it has not.  Called again and again while the master
  // waits for a sample of the worker.
  virtual std::string Health() { return ""; }
  static BusOptions Options() {
    BusOptions options;
    options.run = "forged-" + std::to_string(getpid());
    return options;
  }
  void Come() {
    process_.connection().slot().OpenSession("now");
    channel_ = std::make_unique<WorkerChannel>(&bus_, "liar/now", ChannelEnd::kWorker);
    WaitUntil("the other end", [this] { return channel_->IsConnected(); });
    openr_wire_ToMaster to_master = New(openr_wire_TO_MASTER_HELLO);
    to_master.body._u.hello = {openr_wire_VERSION, arena_.Text("liar"), arena_.Text("here"), 4711,
                               arena_.Text("")};
    channel_->Send(to_master);
    process_.connection().WaitForJoin(10'000, "", [] { return false; });
    openr_wire_Welcome welcome{};
    welcome.stick = arena_.Text("");
    process_.loader().Welcome(&system_, welcome);
  }

  openr_wire_ToMaster New(openr_wire_ToMasterKind kind) const {
    openr_wire_ToMaster to_master{};
    to_master.body._d = kind;
    return to_master;
  }
  // The regular end of a handler.
  openr_wire_ToMaster Stopped() {
    openr_wire_ToMaster to_master = New(openr_wire_TO_MASTER_STOPPED);
    openr_wire_Stopped& stopped = to_master.body._u.stopped;
    stopped.object = remote_->id;
    stopped.timeout_us = -1;
    return to_master;
  }
  openr_wire_ToMaster With(const openr_wire_Effect& effect) {
    openr_wire_ToMaster to_master = Stopped();
    to_master.effects =
        arena_.Sequence<decltype(to_master.effects)>(std::vector<openr_wire_Effect>{effect});
    return to_master;
  }
  template <auto kFunction>
  openr_wire_ToMaster Note(std::vector<uint64_t> numbers) {
    return NoteOf(WorkerCallList::NumberOf<kFunction>(), std::move(numbers));
  }
  openr_wire_ToMaster NoteOf(uint32_t function, std::vector<uint64_t> numbers) {
    openr_wire_Effect effect{};
    effect._d = openr_wire_EFFECT_NOTE;
    effect._u.note = {function, arena_.Numbers(std::move(numbers)), arena_.Text("")};
    return With(effect);
  }
  openr_wire_Message Message(openr_wire_PayloadKind kind) const {
    openr_wire_Message message{};
    message.sender = remote_->id;
    message.target = sender_->host().id;
    message.selector = sender_->out->GetID().GetSelector();
    message.payload._d = kind;
    return message;
  }
  openr_wire_ToMaster Post(const openr_wire_Message& message, int64_t delay_us = 0) {
    openr_wire_Effect effect{};
    effect._d = openr_wire_EFFECT_POST;
    effect._u.posted = {message, delay_us};
    return With(effect);
  }
  openr_wire_ToMaster Notify(std::vector<openr_wire_NotifiedRegion> parts,
                             uint32_t notifications = 1) {
    openr_wire_Message message = Message(openr_wire_PAYLOAD_NOTIFY);
    openr_wire_Notify& notify = message.payload._u.notify;
    notify.subject = remote_->id;
    notify.notifications = notifications;
    notify.parts = arena_.Sequence<decltype(notify.parts)>(std::move(parts));
    return Post(message);
  }
  openr_wire_ToMaster Ready(std::vector<openr_wire_ReturnedRegion> regions) {
    openr_wire_Message message = Message(openr_wire_PAYLOAD_READY);
    openr_wire_Ready& ready = message.payload._u.ready;
    ready.observer = remote_->id;
    ready.selector = kEntry;
    ready.regions = arena_.Sequence<decltype(ready.regions)>(std::move(regions));
    return Post(message);
  }
  template <auto kFunction>
  openr_wire_ToMaster Ask(int32_t object, std::vector<uint64_t> numbers,
                          const std::string& text = "") {
    return AskOf(object, WorkerCallList::NumberOf<kFunction>(), std::move(numbers), text);
  }
  openr_wire_ToMaster AskOf(int32_t object, uint32_t function, std::vector<uint64_t> numbers,
                            const std::string& text = "") {
    openr_wire_ToMaster to_master = New(openr_wire_TO_MASTER_QUESTION);
    to_master.body._u.question = {
        object, function, arena_.Numbers(std::move(numbers)), arena_.Text(text), {}};
    return to_master;
  }

  // Lets the worker send `samples`, then delivers a message to its object.
  void Deliver(const std::vector<openr_wire_ToMaster>& samples) {
    for (const openr_wire_ToMaster& to_master : samples) channel_->Send(to_master);
    {
      const CurrentScope scope(&system_, &sender_->host());
      system_.Post(system_.NewMessage(remote_->id, kEntry));
    }
    system_.RunFor(run_us_);
    arena_.Clear();
  }
  // Returns the reason of the loss after the worker has sent `to_master` in a handler; "" without a
  // loss.
  std::string LossBy(const openr_wire_ToMaster& to_master) {
    Deliver({to_master});
    EXPECT_LE(losses_.size(), 1u);
    return losses_.empty() ? "" : losses_[0];
  }

  // Does the same for any action that reads the sample.
  std::string LossBy(const openr_wire_ToMaster& to_master, const std::function<void()>& action) {
    channel_->Send(to_master);
    arena_.Clear();
    try {
      action();
    } catch (const ProcessLost& lost) {
      return lost.what();
    }
    return "";
  }
  openr_wire_ToMaster State(uint32_t region, const std::string& bytes) {
    openr_wire_ToMaster to_master = New(openr_wire_TO_MASTER_STATE);
    auto& regions = to_master.body._u.state.regions;
    regions = arena_.Sequence<std::remove_reference_t<decltype(regions)>>(
        std::vector<openr_wire_RegionBytes>{{region, arena_.Bytes(bytes.data(), bytes.size())}});
    return to_master;
  }
  std::string LossByState(const openr_wire_ToMaster& to_master) {
    return LossBy(to_master, [this] { process_.FetchState(remote_->id); });
  }
  openr_wire_ToMaster Loaded(const std::vector<ObjectId>& ids) {
    std::vector<openr_wire_LoadedObject> loaded;
    for (const ObjectId id : ids) {
      loaded.push_back({});
      loaded.back().id = id;
      loaded.back().name = loaded.back().problem = arena_.Text("");
    }
    openr_wire_ToMaster to_master = New(openr_wire_TO_MASTER_LOADED);
    auto& objects = to_master.body._u.loaded.objects;
    objects = arena_.Sequence<std::remove_reference_t<decltype(objects)>>(loaded);
    return to_master;
  }
  // Orders the worker to load the remote object, and waits for its answer.
  void LoadRemote() {
    openr_wire_ObjectEntry entry{};
    entry.id = remote_->id;
    entry.name = entry.path = arena_.Text("");
    entry.is_own = true;
    openr_wire_Load load{};
    load.objects =
        arena_.Sequence<decltype(load.objects)>(std::vector<openr_wire_ObjectEntry>{entry});
    process_.loader().Load(load);
  }
  // Does the same for an answer to the order to load the remote object.
  std::string LossByLoaded(const openr_wire_ToMaster& to_master) {
    return LossBy(to_master, [this] { LoadRemote(); });
  }
  std::string TextHere() { return {system_.regions().BaseOf(region_here_), kBytes}; }

  Bus bus_{Options()};
  RemoteProcess process_{&bus_, "liar", false, [this] { return Health(); },
                         [](const std::string&) {}};
  System system_;
  SubjectProbe* sender_ = nullptr;
  RemoteObject* remote_ = nullptr;
  std::unique_ptr<WorkerChannel> channel_;
  WireArena arena_;
  std::vector<std::string> losses_;
  int64_t run_us_ = 1'000'000;  // virtual time for which Deliver() runs the master
  uint32_t region_here_ = 0, region_there_ = 0;
};

}  // namespace openr_host

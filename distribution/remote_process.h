// The master's side of one process of a distributed run.
//
// Handlers of its objects are run one at a time, each to its end or to where it waits; what they
// did is done here again, in the same order, as by their stand-ins (RemoteObject).  So numbers,
// order and trace are those of a run in one process.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "distribution/bus.h"
#include "distribution/latency.h"
#include "distribution/marshaller.h"
#include "distribution/process_slot.h"
#include "runtime/core/uplink.h"

class RCRegion;

namespace openr_host {

class Object;
class RemoteObject;
class System;
struct RunEnd;

// The same, by the fault of the object whose handler ran.
struct ProcessCrashed : ProcessLost {
  using ProcessLost::ProcessLost;
};

// It went before it took part: another one of its name may do better.
struct ProcessRefused : ProcessLost {
  using ProcessLost::ProcessLost;
};

class RemoteProcess {
 public:
  // `is_external`: somebody else starts it.  `health` says what is wrong with the process, or "";
  // `say` speaks to people.
  RemoteProcess(Bus* bus, std::string name, bool is_external, std::function<std::string()> health,
                std::function<void(const std::string&)> say);

  const std::string& name() const { return name_; }
  const ProcessSlot::Identity& identity() const { return slot_.identity(); }
  ProcessSlot& slot() { return slot_; }
  bool is_lost() const { return is_lost_; }
  void set_lost() { is_lost_ = true; }

  // Everything here throws ProcessLost.

  // The process has come, within `limit_ms` and before the run is to end.  `advice` is what people
  // are to do for one that they have to start; "" for others.
  void WaitForJoin(int64_t limit_ms, const std::string& advice,
                   const std::function<bool()>& is_ending);

  // Bytes of heap that are in use on a robot, but for those of the objects there.
  uint64_t HeapElsewhere(System* system, int robot) const;

  // What holds for the whole run.
  void Welcome(System* system, const openr_wire_Welcome& welcome);

  // It takes over what is new in the master's tables and loads those of its objects.
  void Load(const openr_wire_Load& load);
  // The stand-in of one of its objects, before that is loaded.
  void Add(RemoteObject* object);

  // The same for one that comes back, without waiting: it is is_reported; true when it is done.  It
  // is lost still, until Rejoin().
  void BeginLoad(const openr_wire_Load& load);
  bool HasLoaded(const std::map<ObjectId, RemoteObject*>& objects);
  // The new stand-ins, which have taken the place of the old ones.
  void Rejoin(const std::map<ObjectId, RemoteObject*>& objects);

  // Object `id` of another process, or of this one, has been replaced.
  void Forget(ObjectId id);

  // From now on nobody waits for a handler but its object: what it did comes when it comes, and
  // HandleReceived() does it.  For runs whose clock is that on the wall.
  void RunFree() { is_free_ = true; }

  // In a free run: a handler of the object is under way, and not waiting for anybody.
  bool IsAtWork(ObjectId object) const { return running_.contains(object); }

  // Messages in its objects' hands in a free run, but for what comes back when it is lost, and for
  // that of the handler that brought it down.
  size_t CountUndelivered() const;

  // Of what the handlers of other objects are to do nothing is kept back any more.
  void FlushBatch();

  // Does what has come since.  Not from a handler.  True when something had.
  bool HandleReceived();
  // Whether it is there at all.
  void CheckHealth();

  // Times from handing a message over to hearing that its handler is done.
  const Latency& latency() const { return latency_; }
  Latency LatencyOf(ObjectId object) const {
    const auto found = latency_of_.find(object);
    return found == latency_of_.end() ? Latency() : found->second;
  }

  // Runs the handler of `message`, which is being delivered to `object`.
  // False when its process was lost before the end of the handler.
  bool RunHandler(RemoteObject* object, const Message& message);

  // From now on it is soon given up when it does not answer.
  void ShortenTimeouts() { has_short_timeout_ = true; }

  // Bytes of the state hash of the subjects of `object`; its regions become as they are there.
  std::string FetchState(ObjectId object);

  // It is lost, and the run goes on: what is lent there goes back to whom it belongs, handlers that
  // wait end.
  void ReleaseAll();

  // Why it is gone, as the two above found out, which do not throw; "" while it is not.
  const std::string& loss() const { return loss_; }
  // Whose handler brought it down, as far as that is known.
  bool has_crashed() const { return crashed_; }
  ObjectId crashed_object() const { return crashed_object_; }

  // What a subject of the object that was lost had sent comes back.
  void TakeBack(RCRegion* region);
  // A message that the process did not hear any more: what it gives back is here.
  void Unheard(const Message& message);

  // Says it of a process that has nothing to do at the moment, too.
  std::string FindProblem() const;
  // The same, or what its last word says.
  std::string FindLoss();

  // Lets the process end and tells it why the run ended (DescribeEnd(), or "").  Called before the
  // System is destroyed.
  void End(const std::string& why);

 private:
  using ReceivedSample = MasterChannel::ReceivedSample;

  // What RunHandler() came to.
  struct Stop {
    openr_wire_StopKind kind = openr_wire_STOP_DONE;
    uint64_t box = 0;
    int64_t timeout_us = -1;
    uint32_t size = 0;
    std::string why;
  };

  static openr_wire_ToWorker NewToWorker(openr_wire_ToWorkerKind kind);
  void Send(const openr_wire_ToWorker& to_worker, bool batched = false);
  bool WillSendMore() const;
  ReceivedSample Next();
  void CheckGoodbye(const openr_wire_ToMaster& to_master) const;
  void ReportSilence();
  std::optional<Stop> WaitForStop(RemoteObject* object);
  std::optional<Stop> WaitForStopInFreeRun(RemoteObject* object);
  Stop ApplyStop(const openr_wire_ToMaster& to_master);
  void RecordHeap(int robot, uint64_t bytes);
  void HandleFreeSample(const openr_wire_ToMaster& to_master);
  void HandleForgotten(const openr_wire_ToMaster& to_master);
  bool HandleLoaded(const openr_wire_ToMaster& to_master,
                    const std::map<ObjectId, RemoteObject*>& objects);
  template <typename Action>
  void RecordLoss(const Action& action);
  [[noreturn]] void Crash(const openr_wire_Crashed& crashed);
  void WakeHandler(ObjectId object, uint64_t box);
  bool HandleRequest(const openr_wire_ToMaster& to_master);
  void SendAnswer(const Answer& answer);
  void Apply(const openr_wire_ToMaster& to_master, Object* self);
  void EndRobot(NoteKind kind, int robot, const RunEnd& why);
  void ApplyNote(NoteKind kind, const std::vector<uint64_t>& numbers, const std::string& text);
  void Unpin(uint32_t region);
  int32_t Post(const openr_wire_PostedMessage& posted, Object* self);
  void Check(const openr_wire_Message& in, const Object* self);
  void CheckEnds(const openr_wire_Message& in, const Object* self);
  bool MayUse(uint32_t region) const;
  bool IsOwn(uint32_t region) const;
  static bool Answers(const Message& message, const Object* self);
  void ResumeWithReply(RemoteObject* object, const Stop& stop, uint64_t session);
  void ResumeWithLine(RemoteObject* object, const Stop& stop, uint64_t session);
  void ReturnExported();
  Object* ObjectOf(ObjectId id);
  [[noreturn]] void Refuse(const std::string& what);

  const std::string name_;
  const std::function<std::string()> health_;
  const std::function<void(const std::string&)> say_;
  const std::string wait_reason_;  // what a proxy waits for
  ProcessSlot slot_;
  System* system_ = nullptr;
  std::unique_ptr<Marshaller> marshaller_;
  std::map<ObjectId, RemoteObject*> objects_;
  std::set<ObjectId> awaited_objects_;     // to be loaded there
  uint64_t session_ = 0;                   // counts on when it comes back
  std::map<uint32_t, int> pins_;           // that objects there have, by region
  std::map<ObjectId, uint64_t> dropped_;   // as it counts them
  std::map<int, uint64_t> heap_by_robot_;  // bytes in use by its objects, by robot
  bool is_lost_ = false;
  Latency latency_;
  std::map<ObjectId, Latency> latency_of_;
  // Of free runs: handlers under way, by object, and the box by which their proxy waits.
  bool is_free_ = false;
  uint64_t wake_box_count_ = 0;  // that there were
  std::map<ObjectId, uint64_t> running_;
  std::map<ObjectId, Stop> stops_;
  int64_t last_heard_ms_ = 0;  // the last time, or when it was given something to do
  bool has_short_timeout_ = false;
  bool is_silent_ = false;  // people have been is_reported
  std::string loss_;        // why the process is gone
  bool crashed_ = false;
  ObjectId crashed_object_ = kNoObject;
};

}  // namespace openr_host

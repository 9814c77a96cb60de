// A worker process runs the handlers of some objects for a master in another process.
//
// The System of a worker has all objects of the run in its tables, with the same ids, but code only
// for its own objects.  A worker does one thing at a time: the master sends a message, the handler
// of the message runs, and all effects of the handler (messages and calls for the master) go back
// in one sample.  If a handler needs an answer of the master, the worker waits for the answer
// before the handler goes on.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "distribution/bus.h"
#include "distribution/marshaller.h"
#include "distribution/master_link.h"
#include "runtime/core/message.h"

namespace openr_host {

class Object;
class System;

struct WorkerOptions {
  BusOptions bus;
  std::string process;  // name of this process in the placement
  std::string session;  // session given by the run; "" if the worker requests a session
  std::string stick;    // folder of the Memory Stick on this host; "" to use the master's path
  int64_t master_wait_ms = 60'000;     // time limit for finding the master, in ms of the wall clock
  bool waits_for_predecessor = false;  // whether to wait until an earlier process of this name ends
  // Returns whether the user has told this process to end; may be null.
  std::function<bool()> is_end_requested;
  std::function<void(const std::string& line)> say;  // prints a line for the user
  // Returns a local folder to use as the Memory Stick when the run's folder is not on this host, or
  // "".  The worker uses the folder only if its files are the same as in the run's folder.  The
  // function itself may be null.
  std::function<std::string()> own_stick;
  // A function that is called once, with the folder of the Memory Stick, before objects are loaded;
  // may be null.  Returns the reason why this process cannot load the images on the stick, or "".
  // The worker then refuses the run, which waits for another process.
  std::function<std::string(const std::string& stick)> find_stick_problem;
  // A function that is called once, with the folder of the Memory Stick, before objects are loaded;
  // may be null.  With this folder, openr join chooses the file for crash records.
  std::function<void(const std::string& stick)> before_loading;
};

class Worker : public MasterLink {
 public:
  explicit Worker(WorkerOptions options);
  ~Worker() override;

  // Runs until the master ends this worker.  Returns "" or an error.
  std::string Run();

  // Returns whether another Run() would fail, too.  Another Run() fails if the worker has the wrong
  // version of the protocol or the wrong stick, or was given no session.
  bool is_refused() const { return is_refused_; }

  // Tells the master that the present handler ends this process, for instance by a crash.  Called
  // by a signal handler in the middle of the object's code.  A signal that comes in a DeferredEnd
  // section is put off until the end of the section, because the section may hold locks of Cyclone
  // DDS.
  void ReportCrash(std::string_view text);

  // ---- MasterLink
  int32_t Post(OwnedMessage message, int64_t delay_us) override;
  void Tell(uint32_t function, const CallArguments& arguments) override;
  CallResult Ask(uint32_t function, const CallArguments& arguments) override;
  void RecordWait(uint64_t box, int64_t timeout_us, std::string_view why) override;
  void RecordWaitForLine(uint64_t box, size_t size) override;

 private:
  using ReceivedSample = WorkerChannel::ReceivedSample;

  // The reply, or the line of the console, that a handler waits for in the middle of its code.
  struct Wait {
    openr_wire_StopKind kind = openr_wire_STOP_DONE;
    uint64_t box = 0;
    int64_t timeout_us = -1;
    size_t size = 0;
    std::string why;
  };

  // Joins the run: gets a session, sends Hello and receives Welcome.  Returns "" or an error.
  std::string Join();
  std::string RequestSession();
  bool IsEndRequested() const { return options_.is_end_requested && options_.is_end_requested(); }
  void SayGoodbye(const std::string& text);
  bool WaitFor(const ChannelBase& channel) const;
  std::string NoRunFound() const;
  std::string SetUp(const openr_wire_Welcome& welcome);
  std::string LoadObjects(const openr_wire_Load& load);
  void CheckRobot(int robot) const;
  std::string AddRobot(const openr_wire_RobotEntry& entry);
  void FindStick(uint64_t hash);
  void AddObject(const openr_wire_ObjectEntry& entry, std::vector<openr_wire_LoadedObject>* loaded);
  openr_wire_LoadedObject Describe(const Object& object);
  void SendLoaded(std::vector<openr_wire_LoadedObject> loaded);
  // Handles samples of the master until it ends this worker.  Returns "" or an error.
  std::string Serve();
  void ReportJoined();
  void ReportRunEnded(const openr_wire_End& end);
  void Deliver(const openr_wire_Deliver& deliver, bool timed_out);
  void RunTimed(ObjectId id);
  void SetHeapOfOtherProcesses(int robot, uint64_t bytes);
  uint64_t HeapOfThisProcess(int robot) const;
  void SendStopped(Object* object);
  void SendState(ObjectId id);
  void Forget(ObjectId id);
  void TakeBack(const openr_wire_TakeBack& in);

  static openr_wire_ToMaster NewToMaster(openr_wire_ToMasterKind kind);
  void Send(const openr_wire_ToMaster& to_master, bool batched = false);
  [[noreturn]] void ExitWithError(const std::string& why);
  // Moves to `to_master` the effects of handlers (messages and calls for the master) that no sample
  // has sent yet.
  void MoveEffectsTo(openr_wire_ToMaster* to_master);
  // Returns the next sample of the master.  If `answer` is true, returns only an answer and keeps
  // other samples for later.  The result is empty if the master is lost or the user ends this
  // process.
  ReceivedSample Next(bool answer);
  CallResult WaitForAnswer();
  // ---- Functions that are defined in worker_link.cc
  bool MayBeRefused(const Message& message);
  bool CancelPendingPin(uint64_t region);
  void TrackSharedBuffers(const Object& object, const Message& message);
  void KeepUntilSent(uint32_t region);
  void SendOnce(openr_wire_NotifiedRegion* part);
  openr_wire_PostedMessage Encode(const Message& message, int64_t delay_us);

  const WorkerOptions options_;
  Bus bus_;
  std::unique_ptr<WorkerChannel> channel_;
  std::unique_ptr<System> system_;
  std::unique_ptr<Marshaller> marshaller_;
  std::string session_;
  bool is_refused_ = false;
  std::string stick_;                       // folder of the Memory Stick in use
  bool has_checked_stick_ = false;          // whether LoadObjects() has checked the stick
  std::set<std::string> own_object_names_;  // names of this worker's objects
  bool has_reported_joined_ = false;
  // For each robot, the number of heap bytes used in other processes.
  std::map<int, uint64_t> heap_of_other_processes_;
  bool is_free_ = false;             // whether the master does not wait for handlers (a free run)
  std::set<ObjectId> fast_objects_;  // objects whose last handler took less than kFastHandlerNs
  bool is_shutting_down_ =
      false;  // whether the objects are being unloaded, so that no handler runs
  // The object whose image is loaded now; kNoObject if none is loaded.
  ObjectId loading_ = kNoObject;
  // Entries of objects in other processes.  The master has told this worker that these entries
  // exist, so the worker need not ask again before it sends a message to them.
  std::set<std::pair<ObjectId, uint32_t>> known_entries_;
  std::deque<ReceivedSample> deferred_;  // samples that arrived while an answer was awaited
  // The effects of the present handler that have not been sent, and the memory that they point to.
  WireArena arena_;
  std::vector<openr_wire_Effect> effects_;
  std::vector<uint32_t> pinned_;  // regions whose memory is kept until their bytes have been sent
  std::map<uint32_t, openr_wire_NotifiedRegion>
      parts_in_sample_;  // data that the next sample already contains; the key is the region's id
  std::map<ObjectId, Wait> waits_;
};

}  // namespace openr_host

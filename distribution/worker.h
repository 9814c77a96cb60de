// A process that runs the handlers of some objects for a master elsewhere.
//
// It has a System whose tables name all objects of the run under the same ids; only its own have
// code.  One thing is done at a time: the master delivers a message, the handler runs, what it did
// goes back in one sample.  Questions in between are answered before the handler goes on.
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
#include "runtime/core/system.h"
#include "runtime/core/uplink.h"

namespace openr_host {

struct WorkerOptions {
  BusOptions bus;
  std::string process;                               // its name in the placement
  std::string session;                               // given by the run; "": it has to knock
  std::string stick;                                 // instead of the master's path; "": that one
  int64_t master_wait_ms = 60'000;                   // for the master to show up
  bool waits_for_predecessor = false;                // it waits until the one before it is gone
  std::function<bool()> is_ended;                    // somebody ends it; null: nobody does
  std::function<void(const std::string& line)> say;  // for people
  // A folder to look at where that of the run is not on this host, "" for none; may be null.  It is
  // used if its files are those of the run.
  std::function<std::string()> own_stick;
  // Called before objects are loaded, with the folder of the stick.
  std::function<void(const std::string& stick)> begins;
};

class Worker : public Uplink {
 public:
  explicit Worker(WorkerOptions options);
  ~Worker() override;

  // Until the master says that it is over.  "" or what went wrong.
  std::string Run();

  // Whether that would be so the next time as well: another version, another stick, no place.
  bool is_refused() const { return is_refused_; }

  // Tells the master that the handler that runs ends this process; from a signal handler on top of
  // the object's code, but not while it is Indivisible.
  void ReportCrash(std::string_view text);

  // ---- Uplink
  int32_t Post(Message* message, int64_t delay_us) override;
  void Tell(NoteKind kind, std::vector<uint64_t> numbers, std::string_view text) override;
  Answer Ask(const Question& question) override;
  void Waits(uint64_t box, int64_t timeout_us, std::string_view why) override;
  void WaitsForLine(uint64_t box, size_t size) override;

 private:
  using ReceivedSample = WorkerChannel::ReceivedSample;

  // What a handler that has not returned waits for.
  struct Wait {
    openr_wire_StopKind kind = openr_wire_STOP_DONE;
    uint64_t box = 0;
    int64_t timeout_us = -1;
    size_t size = 0;
    std::string why;
  };

  std::string Join();
  std::string RequestSession();
  bool IsEndRequested() const { return options_.is_ended && options_.is_ended(); }
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
  std::string Serve();
  void ReportJoined();
  void ReportRunEnded(const openr_wire_End& end);
  void Deliver(const openr_wire_Deliver& deliver, bool timed_out);
  void RunTimed(ObjectId id);
  void SetHeapElsewhere(int robot, uint64_t bytes);
  uint64_t HeapHere(int robot) const;
  void SendStopped(Object* object);
  void SendState(ObjectId id);
  void Forget(ObjectId id);

  static openr_wire_ToMaster NewToMaster(openr_wire_ToMasterKind kind);
  void Send(const openr_wire_ToMaster& to_master, bool batched = false);
  [[noreturn]] void ExitWithError(const std::string& why);
  // What handlers did since the last sample goes with `up`.
  void MoveEffectsTo(openr_wire_ToMaster* to_master);
  // The next sample, of the kind given if it is an answer that is waited for; empty when the
  // master is gone.
  ReceivedSample Next(bool answer);
  Answer WaitForAnswer();
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
  std::string stick_;                       // its folder
  bool has_called_begins_ = false;          // `begins` has been called
  std::set<std::string> own_object_names_;  // of its objects
  bool has_reported_joined_ = false;
  std::map<int, uint64_t> heap_elsewhere_;  // bytes in other processes, by robot
  bool is_free_ = false;                    // the run goes by the clock on the wall
  std::set<ObjectId> fast_objects_;         // whose last handler was
  bool is_shutting_down_ = false;           // nobody listens: objects are being unloaded
  std::set<std::pair<ObjectId, uint32_t>> known_entries_;  // that there are, as far as asked for
  std::deque<ReceivedSample> deferred_;                    // came while an answer was waited for
  // Of the handler that runs.
  WireArena arena_;
  std::vector<openr_wire_Effect> effects_;
  std::vector<uint32_t> pinned_;  // regions whose bytes are to be sent
  std::map<uint32_t, openr_wire_NotifiedRegion>
      parts_in_sample_;  // whose bytes go with the next sample
  std::map<ObjectId, Wait> waits_;
};

}  // namespace openr_host

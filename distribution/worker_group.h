// All processes of a distributed run, seen from the master: started, greeted, watched, ended.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "distribution/bus.h"
#include "distribution/child_process.h"
#include "distribution/name_claim.h"
#include "distribution/placement.h"
#include "distribution/remote_object.h"
#include "distribution/remote_process.h"
#include "runtime/core/system.h"

namespace openr_host {

struct WorkerGroupOptions {
  BusOptions bus;
  Placement placement;
  // Command line of a process here, to which its name is added.
  std::vector<std::string> command;
  // What it begins with, for a debugger or Valgrind.
  std::vector<std::string> wrapper;
  std::string stick;         // folder of the master's stick
  bool is_free = false;      // the clock on the wall rules, see RemoteProcess::RunFree()
  int64_t wait_ms = 60'000;  // for a process to come
  int restarts = 0;          // how often each process of this host is started again
  std::function<void(const std::string& line)> say;  // for people
  // How often the run was asked to end: once, nobody is waited for who is away; twice, it ends at
  // once.  Null: never.
  std::function<int()> interrupts;
};

class WorkerGroup {
 public:
  // Starts the processes of this host.  Throws std::runtime_error.
  explicit WorkerGroup(WorkerGroupOptions options);
  ~WorkerGroup();  // whoever has not ended yet is killed
  WorkerGroup(const WorkerGroup&) = delete;
  WorkerGroup& operator=(const WorkerGroup&) = delete;

  Bus* bus() { return &bus_; }

  // For System::LoadStick(): stand-ins for the objects that live elsewhere.
  System::StandIns StandInsFor(System* system, int robot);

  // What is wrong with the names of a placement, when all robots have been loaded; "".
  std::string UnknownObjects() const;

  // Before Boot(), when all robots have been loaded: tells all processes of the rest.  "" or what
  // went wrong, here or in a stand-in.
  std::string Connect();

  struct ProcessFacts {
    std::string name;
    std::string host;
    int64_t pid = 0;
    std::vector<std::string> objects;
    std::string lost;  // why it is not there any more; ""; host and pid are those it had
    int losses = 0;    // how often it was lost, and came back
    int returns = 0;
    uint64_t handlers = 0;  // run there; and how long each took, with the way there and back
    double median_us = 0;
    double p99_us = 0;
    double max_us = 0;
  };
  std::vector<ProcessFacts> Describe() const;

  // Bytes of heap that each object elsewhere had at most.
  std::map<ObjectId, uint64_t> HeapMax() const;

  // `listener` hears of each object of a process that is gone, if the run goes on without, and of
  // each that has come back.
  void OnCrash(std::function<void(Object*)> listener) { crash_listener_ = std::move(listener); }
  void OnReturn(std::function<void(Object*)> listener) { return_listener_ = std::move(listener); }

  // `listener` hears which process is gone, at the moment when the run sees it.
  void OnLoss(std::function<void(const std::string& process)> listener) {
    loss_listener_ = std::move(listener);
  }

  // Looks at processes that have nothing to do, and lets those that were lost come back.  Not from
  // a handler.
  void CheckWorkers();

  // In a free run: waits at most `timeout_us` for news of the processes and does them.  Not from a
  // handler.
  void Pump(int64_t timeout_us);

  // From now on a process that does not answer is soon given up.
  void ShortenTimeouts();

  // Findings about messages that nobody heard.
  void ReportLosses();

  // The run is over: the processes end.  Before the System does.
  void End();

 private:
  // Where a process is that was lost.
  enum class Stage {
    kRunning,       // it was not
    kNotRestarted,  // for good
    kCleaningUp,    // its objects' things are being put away; what remains of it ends
    kJoining,       // a new one, which has not said its name
    kLoading,       // its images
    kReplacing,     // its objects are about to take their places
  };
  struct Member {
    std::string name;
    std::unique_ptr<ChildProcess> child;  // null: on another host
    std::unique_ptr<RemoteProcess> process;
    std::map<ObjectId, RemoteObject*> objects;
    std::string lost;
    bool is_external = false;  // somebody else starts it
    bool is_welcomed = false;
    size_t robots = 0;  // that it knows of, and objects
    size_t known = 0;
    // For its return.
    Stage stage = Stage::kRunning;
    bool crashed = false;
    bool is_cleaned_up = false;
    bool attempt_failed = false;  // the last attempt
    int64_t since_ms = 0;         // it has been in this stage
    bool is_reported = false;     // that this takes long
    int restarts_left = 0;
    int losses = 0;
    int returns = 0;
    uint64_t unheard_before = 0;
    std::vector<std::unique_ptr<RemoteObject>> new_objects;
    std::map<ObjectId, RemoteObject*> successors;
  };

  void Start(Member* member);
  std::string ProblemOf(const Member& member) const;
  void Welcome(Member* member);
  openr_wire_Load NextLoadFor(Member* member, WireArena* arena);
  void LoadNewObjects(Member* member);
  void SendNextLoad(Member* member);
  void WaitForAnotherWorker(Member* member, const std::string& why);
  bool IsEnding() const { return options_.interrupts && options_.interrupts() >= 1; }
  bool HandleReceived();
  bool IsInterrupted() const { return options_.interrupts && options_.interrupts() >= 2; }
  void HandleLoss(const RemoteObject* about, RemoteObject::Loss loss, const std::string& why);
  void StopRun(const RunEnd& why);

  // worker_group_restart.cc
  bool MayRestart(const Member& member) const;
  void CleanUp(Member* member);
  void EnterStage(Member* member, Stage stage);
  void AdvanceRestart(Member* member, bool may_load = true);
  void CheckRestart(Member* member);
  void Restart(Member* member);
  void BeginLoading(Member* member);
  void ReplaceObjects(Member* member);
  void OnReplaced(ObjectId id);
  void FailAttempt(Member* member, const std::string& why);
  bool IsRestarting(const Member& member) const;
  bool AdvanceRestarts();
  void WaitForRestarts();

  const WorkerGroupOptions options_;
  Bus bus_;
  std::unique_ptr<NameClaim> claim_;  // if somebody else starts processes
  std::map<std::string, Member> members_;
  System* system_ = nullptr;
  int64_t next_check_ns_ = 0;  // after processes, in a free run
  std::string problem_;        // the first, before Boot()
  std::function<void(const std::string&)> loss_listener_;
  std::function<void(Object*)> crash_listener_;
  std::function<void(Object*)> return_listener_;
  std::vector<std::string> placed_;  // objects that were found
};

}  // namespace openr_host

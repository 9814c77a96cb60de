// WorkerGroup: all workers of a distributed run, in the master.  It starts, watches, restarts and
// ends the workers.
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
#include "runtime/core/load_stick.h"

namespace openr_host {

class System;
struct RunEnd;

struct WorkerGroupOptions {
  BusOptions bus;
  Placement placement;
  // Command line that starts a worker on this host.  WorkerGroup appends the name of the process
  // and the name of the session.
  std::vector<std::string> command;
  // Command line that is put before `command`, for a debugger or Valgrind.
  std::vector<std::string> wrapper;
  std::string stick;  // folder of the run's Memory Stick, as a path on the master's host
  // True for a free run, in which the master does not wait for handlers
  // (RemoteHandlers::RunFree()).
  bool is_free = false;
  int64_t wait_ms = 60'000;  // time limit for a worker to join, in ms of the wall clock
  int restarts = 0;          // how often each worker may be restarted
  std::function<void(const std::string& line)> say;  // prints a line for the user
  // Returns the number of times that the user has asked the run to end (Ctrl-C).  After the first
  // request, the run no longer waits for workers that have to join or to be restarted.  After the
  // second request, the run ends at once.  If this function is null, the user never asks.
  std::function<int()> interrupts;
};

class WorkerGroup {
 public:
  // Starts the workers of this host.  Throws std::runtime_error.
  explicit WorkerGroup(WorkerGroupOptions options);
  ~WorkerGroup();  // kills the workers on this host that still run
  WorkerGroup(const WorkerGroup&) = delete;
  WorkerGroup& operator=(const WorkerGroup&) = delete;

  Bus* bus() { return &bus_; }

  // Returns functions that make stand-ins in the master for the objects that are placed in workers.
  // LoadStick() calls these functions.
  StandIns StandInsFor(System* system, int robot);

  // Returns an error if the placement names an object that the run does not have or that must stay
  // in the master; else "".  REQUIRES: all robots are loaded.
  std::string UnknownObjects() const;

  // Sends all workers the entries of the master's tables of robots and objects that they do not
  // have yet.  Returns "" or the first error of a worker.  That error may have come earlier, while
  // LoadStick() loaded the objects.  REQUIRES: all robots are loaded, Boot() has not been called.
  std::string Connect();

  // Returns the first error of a worker so far; "" if there is none.
  const std::string& problem() const { return problem_; }

  // The figures of one worker in the report of the run.
  struct ProcessFacts {
    std::string name;
    std::string host;
    int64_t pid = 0;
    std::vector<std::string> objects;
    std::string lost;       // the reason of the loss, "" while the worker runs
    int losses = 0;         // number of times that the worker was lost
    int restarts_done = 0;  // number of times that the worker was restarted
    // Number of times that the worker has run a handler.  The three times below are the median, the
    // 99th percentile and the maximum of the time from sending a message to the worker until the
    // master knows that the message's handler is done.
    uint64_t handlers = 0;
    double median_us = 0;
    double p99_us = 0;
    double max_us = 0;
  };
  std::vector<ProcessFacts> Describe() const;

  // Returns for each object of a worker the most bytes of heap that it has used.
  std::map<ObjectId, uint64_t> HeapMax() const;

  // Sets a listener that is called for each object of a worker when the worker is lost while the
  // run goes on.
  void OnObjectLoss(std::function<void(Object*)> listener) {
    object_loss_listener_ = std::move(listener);
  }
  // Sets a listener that is called for each object of a worker when the worker has been restarted.
  void OnObjectRestart(std::function<void(Object*)> listener) {
    object_restart_listener_ = std::move(listener);
  }

  // Sets a listener that is called with the name of a worker when the master notices that the
  // worker is lost.
  void OnLoss(std::function<void(const std::string& process)> listener) {
    loss_listener_ = std::move(listener);
  }

  // Checks in a lockstep run (the master waits for each handler) whether workers that run no
  // handler still exist, and advances restarts of lost workers.  A worker that runs a handler is
  // checked while the master waits for it.  Must not be called from a handler.
  void CheckWorkers();

  // Waits in a free run (the master does not wait for handlers) for samples of the workers, at most
  // `timeout_us`, and handles them.  Must not be called from a handler.
  void Pump(int64_t timeout_us);

  // Shortens the time after which a worker that does not answer is given up.  To be called when the
  // run ends, so that a stuck worker does not delay the end.
  void ShortenTimeouts();

  // Adds warnings to the report about messages that were not delivered because their worker was
  // lost.
  void ReportLosses();

  // Drops what this object has of the System: messages, and memory in the System's region table.
  // Also called when an exception ends the run, after which nobody may call End().  REQUIRES: the
  // System still exists.
  void ReleaseSystem();

  // Tells all workers that the run has ended.  Kills a worker that this run has started if it does
  // not receive this message, or does not end in time.  REQUIRES: the System still exists.
  void End();

 private:
  // The stages of the restart of a lost worker.
  enum class Stage {
    kRunning,       // the worker is not lost
    kNotRestarted,  // the worker is lost and will not be restarted
    kCleaningUp,    // the objects of the worker are cleaned up, and its old process ends
    kJoining,       // the new process has been started and has not joined yet
    kLoading,       // the new process loads its images
    kReplacing,     // the master's new stand-ins are about to replace the old ones
  };
  // The master's data about one worker.
  struct Member {
    std::string name;
    std::unique_ptr<ChildProcess> child;  // the worker's process; null if a user starts the worker
    std::unique_ptr<RemoteProcess> process;
    std::map<ObjectId, RemoteObject*> objects;
    std::string lost;
    bool is_external = false;  // whether a user starts the worker with openr join
    bool is_welcomed = false;
    // Number of entries of the master's table of robots that were sent to the worker, counted from
    // the beginning of the table.
    size_t robots_sent = 0;
    // Number of entries of the master's table of objects that were sent to the worker, counted from
    // the beginning of the table.
    size_t objects_sent = 0;
    // ---- The state of the loss and the restart of this worker, from here to the end
    Stage stage = Stage::kRunning;
    bool crashed = false;
    bool is_cleaned_up = false;
    bool attempt_failed = false;  // whether the last attempt to restart the worker has failed
    int64_t since_ms = 0;         // wall time in ms when `stage` began
    bool is_reported = false;     // whether the user was told that the stage takes long
    int restarts_left = 0;
    int losses = 0;
    int restarts_done = 0;
    uint64_t undelivered_before = 0;  // number of undelivered messages of all earlier losses
    // Owns the master's new stand-ins for the objects of a restarted worker, until the object table
    // takes them to replace the old stand-ins.
    std::vector<std::unique_ptr<RemoteObject>> new_objects;
    // The new stand-ins of a restarted worker's objects; the key is the id of the object.  The
    // stand-ins remain in this map after the object table has taken them.
    std::map<ObjectId, RemoteObject*> successors;
  };

  void Start(Member* member);
  std::string ProblemOf(const Member& member) const;
  void Welcome(Member* member);
  openr_wire_Load NextLoadFor(Member* member, WireArena* arena);
  void LoadNewObjects(Member* member);
  bool HasSentAll(const Member& member) const;
  void SendNewEntries(Member* member);
  void WaitForAnotherWorker(Member* member, const std::string& why);
  void HandleLoadingCrash(const Member& member, const ProcessCrashed& crashed);
  // Returns whether the user has asked the run to end (Ctrl-C).
  bool IsEnding() const { return options_.interrupts && options_.interrupts() >= 1; }
  // Returns whether the user has asked for the end of the run at least twice, so that the run ends
  // at once.
  bool IsInterrupted() const { return options_.interrupts && options_.interrupts() >= 2; }
  bool HandleReceived();
  void HandleLoss(const RemoteObject* about, RemoteObject::Loss loss, const std::string& why);
  void StopRun(const RunEnd& why);
  static bool HasEnded(const Member& member);
  static bool AwaitExit(const Member& member, int64_t limit_ms);
  void KillAtEnd(const Member& member) const;

  // ---- The restart of a lost worker, in worker_group_restart.cc
  bool MayRestart(const Member& member) const;
  void CleanUp(Member* member);
  void EnterStage(Member* member, Stage stage);
  void AdvanceRestart(Member* member, bool may_load = true);
  void CheckRestart(Member* member);
  void Restart(Member* member);
  void BeginLoading(Member* member);
  bool HasLoadedAll(Member* member);
  void ReplaceObjects(Member* member);
  void OnReplaced(ObjectId id);
  static void DropNewObjects(Member* member);
  void FailAttempt(Member* member, const std::string& why);
  bool IsRestarting(const Member& member) const;
  bool AdvanceRestarts();
  void WaitForRestarts();

  const WorkerGroupOptions options_;
  Bus bus_;
  std::unique_ptr<NameClaim> claim_;  // null if the run has no external workers
  std::map<std::string, Member> members_;
  System* system_ = nullptr;
  int64_t next_check_ns_ = 0;  // time of the next check of the workers in a free run
  std::string problem_;        // the first problem of a worker before Boot(); "" if there is none
  std::function<void(const std::string&)> loss_listener_;
  std::function<void(Object*)> object_loss_listener_;
  std::function<void(Object*)> object_restart_listener_;
  std::vector<std::string> placed_;  // names of objects that are in OBJECT.CFG and run in workers
};

}  // namespace openr_host

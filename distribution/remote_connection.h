// RemoteConnection: the master's end of the connection to one worker process.
//
// The connection sends samples to the worker, receives its samples, and finds out that the worker
// has ended or cannot be reached.  It does not know what the samples mean, except for two: the
// worker's goodbye, by which a worker tells that it ends, and the sample that ends the worker.
//
// The connection owns the slot in which processes of the worker's name join one after the other.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "distribution/bus.h"
#include "distribution/process_slot.h"
#include "runtime/core/message.h"

namespace openr_host {

// Thrown if a handler of the worker's objects has ended the worker process, for instance by a
// crash.
struct ProcessCrashed : ProcessLost {
  ProcessCrashed(const std::string& what, ObjectId crashed) : ProcessLost(what), object(crashed) {}

  ObjectId object;  // the object whose handler has ended the process, or kNoObject if not known
};

// Thrown if the worker has refused the run before taking part.  The run does not fail, because the
// master then waits for another process of the same name.
struct ProcessRefused : ProcessLost {
  using ProcessLost::ProcessLost;
};

// After this time without an answer, the user is told that the worker is silent.
constexpr int64_t kSilenceMs = 2'000;

// Returns a sample of the kind `kind` for a worker, with 0 in all other fields.
openr_wire_ToWorker NewToWorker(openr_wire_ToWorkerKind kind);

class RemoteConnection {
 public:
  using ReceivedSample = MasterChannel::ReceivedSample;

  // `is_external` is true if a user starts the worker.  `health` returns a text that says why the
  // run cannot go on with the worker, for instance because its process has ended; "" if the run can
  // go on.  `say` prints a line for the user.
  RemoteConnection(Bus* bus, std::string name, bool is_external,
                   std::function<std::string()> health,
                   std::function<void(const std::string&)> say);
  RemoteConnection(const RemoteConnection&) = delete;
  RemoteConnection& operator=(const RemoteConnection&) = delete;

  const std::string& name() const { return name_; }
  ProcessSlot& slot() { return slot_; }
  const ProcessSlot::Identity& identity() const { return slot_.identity(); }
  // The channel to the worker; null if no worker has joined or is joining.  Functions of the
  // channel do not throw ProcessLost if the worker is lost; functions of this class, such as Send()
  // and Next(), do.
  MasterChannel* channel() const { return slot_.channel(); }
  // Prints a line for the user.
  void Say(const std::string& line) const { say_(line); }

  // Returns whether the worker is lost and no other process has taken its place yet.
  bool is_lost() const { return is_lost_; }
  void set_lost() { is_lost_ = true; }
  // Returns the number of the present session: how often the worker has been restarted so far.
  uint64_t session() const { return session_; }
  // Returns whether the process of `session` is lost.  A function that waits needs the session in
  // which its wait began, because is_lost() is false again after a restart.
  bool IsOver(uint64_t session) const { return is_lost_ || session != session_; }
  // Ends a restart: the worker does not count as lost any more.
  void Rejoin();

  // Waits until the worker has joined, at most `limit_ms`; stops waiting when `is_ending` returns
  // true.  `advice` tells the user how to start an external worker; "" for other workers.  Throws
  // ProcessLost if the worker has not joined.
  void WaitForJoin(int64_t limit_ms, const std::string& advice,
                   const std::function<bool()>& is_ending);

  // Sends a sample.  If `batched` is true, the sample may wait and share a packet with the next
  // samples (Channel::SendBatched()).  Throws ProcessLost.
  void Send(const openr_wire_ToWorker& to_worker, bool batched = false);
  // Sends the samples that wait to share a packet.
  void FlushBatch();

  // Waits for the next sample of the worker.  Throws ProcessLost if the worker is lost.
  ReceivedSample Next();
  // Returns the next sample that a worker has sent before its end.  Waits only a short time for
  // this sample; the result is empty if no sample arrives in this time.
  ReceivedSample ReceiveLate();
  // Throws ProcessLost if the sample is the worker's goodbye.  The goodbye may arrive at any time.
  void CheckGoodbye(const openr_wire_ToMaster& to_master) const;
  // Throws ProcessLost, because the worker has sent `what`, which is not allowed.
  [[noreturn]] void Refuse(const std::string& what) const;

  // Returns the problem of the worker, or "" if there is none.  Does not wait for a sample of the
  // worker, so the loss of an idle worker, which sends nothing, is found, too.
  std::string FindProblem() const;
  // Returns the problem of the worker as FindProblem() does.  If the worker has sent a goodbye,
  // returns the reason in the goodbye, which is more exact.
  std::string FindLoss();

  // Tells the worker to end.  `why` is the reason why the run has ended: the text of DescribeEnd(),
  // or "".  Returns false if no worker has joined, or if sending fails and the worker is lost.
  bool SendEnd(const std::string& why);
  // Waits until the worker has received all samples, at most `limit_ms`.  Returns whether it has
  // received them.  REQUIRES: SendEnd() has returned true.
  bool AwaitReceipt(int64_t limit_ms);

  // Shortens the time after which Next() gives up a worker that does not answer.  To be called when
  // the run ends.
  void ShortenTimeouts() { has_short_timeout_ = true; }

 private:
  const std::string name_;
  const std::function<std::string()> health_;
  const std::function<void(const std::string&)> say_;
  ProcessSlot slot_;
  bool is_lost_ = false;
  bool has_sent_end_ = false;  // whether SendEnd() has told the worker to end
  uint64_t session_ = 0;
  bool has_short_timeout_ = false;
};

}  // namespace openr_host

// The master's place for one worker process: which process may join, and which process has joined.
//
// Each process that joins gets a session, which has a name of its own.  The Channel of a session is
// in the partition RUN/PROCESS/SESSION, so samples for a lost process never reach the next process.
// A worker that the master has started gets the session on its command line.  An external worker,
// which a user starts with openr join, has no session yet, so it uses a channel in the partition
// RUN/PROCESS.  On this channel it sends a JoinRequest.  The JoinAnswer of the master has the
// session, or the reason of a refusal.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "distribution/bus.h"
#include "distribution/liveness_check.h"

namespace openr_host {

// Thrown if the worker has ended, cannot be reached or has sent invalid data.  what() is a message
// for the user.
struct ProcessLost : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr ChannelTopics kJoinTopics = {&openr_wire_JoinAnswer_desc, "openr_join_answer",
                                       &openr_wire_JoinRequest_desc, "openr_join_request"};
using MasterJoinChannel = Channel<openr_wire_JoinAnswer, openr_wire_JoinRequest>;
using WorkerJoinChannel = Channel<openr_wire_JoinRequest, openr_wire_JoinAnswer>;

// The text that an answer to a join request has in place of a session name if another process has
// the worker's place already.
constexpr const char* kTakenSession = "taken";

// Returns a name such as "host-1234-5", unique in the run.
std::string NewSessionName();
std::string HostName();
// Returns the process that has made a session name: "pid 1234 on host" for "host-1234-5".
std::string MakerOf(const std::string& session);

// The place in the run for the worker of one name.  Different processes may take this place one
// after the other, but only one process has it at any time.
class ProcessSlot {
 public:
  struct Identity {  // the host and process id that the worker reports in its Hello
    std::string host;
    int64_t pid = 0;
  };

  // `is_external` is true if a user starts the worker with openr join.
  ProcessSlot(Bus* bus, std::string process, bool is_external);

  // Gives up the present worker, if there is one, and opens the channel by which a new process with
  // this `session` can join.
  void OpenSession(const std::string& session);

  // Advances the handshake with a joining worker, for at most `timeout_ms`.  Returns true when the
  // handshake is complete: the worker has sent its Hello and can receive.  Throws ProcessLost if
  // the worker has another version of the protocol.
  bool AwaitJoin(int timeout_ms);
  bool has_joined() const { return has_joined_; }

  // Returns whether the joined process has ended, as far as this machine can tell (LivenessCheck).
  bool HasEnded() const;

  // Answers the join requests that have arrived.  Refuses them while a worker has the slot, and
  // after Close(); otherwise the first requester gets a session.  Also tells abandoned workers that
  // they were given up.
  void AnswerPendingRequests();
  // Closes the slot: all later join requests are refused.
  void Close() { is_closed_ = true; }

  // Gives up the joined worker.  If this is an external worker that cannot be reached now,
  // AnswerPendingRequests() tells the worker about this later, when the worker can be reached
  // again.
  void Abandon();

  // The channel to the worker that has joined or is joining; null if there is no such worker.
  MasterChannel* channel() const { return channel_.get(); }
  const Identity& identity() const { return identity_; }
  // Returns the host and process id of the present worker, for reports.  Until that worker has sent
  // its Hello, returns host and process id of the previous worker.
  const Identity& last_identity() const { return identity_.pid == 0 ? previous_ : identity_; }

 private:
  // The next three functions are steps of AwaitJoin() and AnswerPendingRequests().
  bool ReceiveHello(int timeout_ms);
  void NotifyAbandoned();
  void AnswerJoinRequest(const openr_wire_JoinRequest& request);

  Bus* const bus_;
  const std::string process_;
  std::unique_ptr<MasterJoinChannel> join_channel_;
  std::unique_ptr<MasterChannel> channel_;
  // An external worker that the master has given up.  The worker may not know this yet.
  struct AbandonedWorker {
    std::unique_ptr<MasterChannel> channel;
    bool is_notified = false;
  };
  std::vector<AbandonedWorker> abandoned_;
  std::string requester_id_;  // JoinRequest::id of the process that got the session
  std::string session_;
  int64_t session_opened_ms_ = 0;  // time at which the external worker got its session
  bool is_closed_ = false;
  bool has_joined_ = false;
  Identity identity_;
  Identity previous_;
  LivenessCheck liveness_;
  mutable int64_t next_check_ms_ = 0;  // time on the wall clock of the next liveness check
};

}  // namespace openr_host

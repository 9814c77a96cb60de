// The place of one process in a run, seen from the master: who may come, who is there.
//
// Each that comes has a session, with a Line of its own in the partition RUN/PROCESS/SESSION, so
// that samples of one that is gone never reach its successor.  A process that the run has started
// is told its session.  One that somebody else starts knocks at the door, two topics in the
// partition RUN/PROCESS, and hears which session is its own, or why there is none.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "distribution/bus.h"
#include "distribution/liveness_check.h"

namespace openr_host {

// The process is gone or talks nonsense; what() says so to people.
struct ProcessLost : std::runtime_error {
  using std::runtime_error::runtime_error;
};

constexpr ChannelTopics kJoinTopics = {&openr_wire_JoinAnswer_desc, "openr_join_answer",
                                       &openr_wire_JoinRequest_desc, "openr_join_request"};
using MasterJoinChannel = Channel<openr_wire_JoinAnswer, openr_wire_JoinRequest>;
using WorkerJoinChannel = Channel<openr_wire_JoinRequest, openr_wire_JoinAnswer>;

// Instead of a session: none, as long as somebody else is there.
constexpr const char* kTakenSession = "taken";

// "host-1234-5": no two of a run are equal.
std::string NewSessionName();
std::string HostName();
// "pid 1234 on host": who has made the name of a session.
std::string MakerOf(const std::string& session);

class ProcessSlot {
 public:
  struct Identity {  // as who sits there says of itself
    std::string host;
    int64_t pid = 0;
  };

  // `is_external`: somebody else starts the process.
  ProcessSlot(Bus* bus, std::string process, bool is_external);

  // From now on one with this session may come.
  void OpenSession(const std::string& session);

  // Does what there is to do for one to come, waiting at most `timeout_ms`.  True when it is
  // there: it has said its name and hears.  Throws ProcessLost when it is of another version.
  bool AwaitJoin(int timeout_ms);
  bool has_joined() const { return has_joined_; }

  // Whether who is there has been killed, or has ended, as far as that is seen from here.
  bool HasEnded() const;

  // Answers whoever else knocks: that somebody is there, or that nobody may come.
  void RefuseOtherRequests();
  // Nobody may come any more.
  void Close() { is_closed_ = true; }

  // Whoever is there is not heard any more; told so as soon as it can be reached again.
  void Abandon();

  // Of who is there or is coming; null: nobody.
  MasterChannel* channel() const { return channel_.get(); }
  const Identity& identity() const { return identity_; }
  // Of who was there last.
  const Identity& last_identity() const { return identity_.pid == 0 ? previous_ : identity_; }

 private:
  bool ReceiveHello(int timeout_ms);
  void NotifyAbandoned();
  void AnswerJoinRequest(const openr_wire_JoinRequest& request);

  Bus* const bus_;
  const std::string process_;
  std::unique_ptr<MasterJoinChannel> join_channel_;
  std::unique_ptr<MasterChannel> channel_;
  // To those that were abandoned because they could not be reached, and may not have noticed.
  struct Abandoned {
    std::unique_ptr<MasterChannel> channel;
    bool is_notified = false;
  };
  std::vector<Abandoned> abandoned_;
  std::string requester_id_;  // who was given the session
  std::string session_;
  int64_t session_opened_ms_ = 0;  // when
  bool is_closed_ = false;
  bool has_joined_ = false;
  Identity identity_;
  Identity previous_;
  LivenessCheck liveness_;
  mutable int64_t next_check_ms_ = 0;  // after the process
};

}  // namespace openr_host

// The server of a run.  It lets other commands of this user ask for the state of the run and give
// inputs to it while it goes on.
//
// The server listens on a socket in LiveFolder().  A client sends one JSON object a line, and gets
// one JSON object a line (docs/inputs.md, "The socket of a run").  A client that watches the run
// also gets events, which are lines that answer no request.  The run serves its clients between
// frames, in its only thread, and never waits for a client: it closes a client that does not take
// its answers, or that sends too long a line.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "openr/live/live_events.h"

namespace openr_host {

class Couplings;

class LiveServer {
 public:
  // The largest number of bytes of a request.  This limit, kAnswersMax and kClientsMax keep clients
  // from making the run use much memory.  The server closes a client that exceeds a limit.
  static constexpr size_t kRequestMax = size_t{64} << 10;
  // The largest number of bytes of answers that a client has not taken yet.
  static constexpr size_t kAnswersMax = size_t{4} << 20;
  // The largest number of clients at one time.  The panel lets at most 16 pages be open at once,
  // and each page needs one client, so this number is enough.
  static constexpr size_t kClientsMax = 32;

  // The type of the function that returns the answer to a request; in a run it is AnswerLive().
  using Answer = std::function<nlohmann::ordered_json(const nlohmann::json& request)>;

  // Makes the socket of this run, and removes the sockets of runs that were killed.  `answer`
  // answers the requests that ask for the state of the run or change it.  `events`, which must
  // outlive the server, makes the events; null: no client can watch.  `couplings` must outlive the
  // server, too; null: the request "couple" is refused.
  // Throws std::runtime_error if the socket cannot be made.
  LiveServer(const std::string& name, Answer answer, LiveEvents* events,
             Couplings* couplings = nullptr);
  // Closes the server and removes its socket.  Waits at most 3 s for clients that have not taken
  // all their answers.
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  // Serves the clients without waiting for them.  Does so at most every 2 ms of wall time, because
  // a run at full speed calls this function every few microseconds.
  void Serve();

  // Serves the clients like Serve(), but first waits until a client sends something, or for
  // `timeout_ms`.  A run that is paused calls this function.
  void WaitAndServe(int timeout_ms);

  // Closes the server's sockets in this fork of the process.  The original process keeps its server
  // and its clients.
  void Forget();
  // Makes a new socket for this fork of the process, which is a run of its own from now on.  Throws
  // std::runtime_error if the socket cannot be made.  REQUIRES: Forget() was called.
  void OpenAgain();

  // Returns whether any client watches the run.
  bool is_watched() const;

 private:
  // A kind of event that a client watches, and the time between two events of this kind.
  struct Watch {
    size_t kind;          // index of LiveEvents::Kinds()
    int64_t interval_ns;  // least time between two events of this kind
    int64_t next_ns;      // earliest time of the next event
  };

  struct Client {
    uint64_t number;  // number of the client; no other client of this run ever has it
    int descriptor;
    std::string received;  // the first bytes of a request that is not complete yet
    std::string to_send;   // answers that the socket has not taken yet
    std::vector<Watch> watches;
    EventCursor cursor;
  };

  void Accept();
  bool Receive(Client* client);
  bool Send(Client* client);
  bool AnswerLines(Client* client);
  nlohmann::ordered_json AnswerTo(Client* client, const nlohmann::json& request);
  nlohmann::ordered_json BeginWatch(Client* client, const nlohmann::json& request);
  void SendEvents(Client* client, int64_t now_ns);
  void UpdateGraphWatch();
  void SendLastAnswers();
  void ServeAll();

  void Open();

  const std::string name_;
  const Answer answer_;
  LiveEvents* const events_;
  Couplings* const couplings_;
  std::string path_;
  // Id of the process that made the socket of this run.  Only this process removes the socket, and
  // no fork of it.
  int process_ = 0;
  int listener_ = -1;
  int64_t next_ns_ = 0;
  uint64_t client_count_ = 0;  // number of clients that have connected so far
  std::vector<Client> clients_;
};

}  // namespace openr_host

// RunServer: the other end of the pipe of the Python module openr_host.  It makes one run and does
// what the commands on the pipe say (command_table.h), until the pipe is closed.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "openr/ending/end_guards.h"
#include "openr/serve/observation.h"
#include "openr/serve/request_pipe.h"
#include "openr/serve/served_run.h"

namespace openr_host {

class RunServer {
 public:
  explicit RunServer(RequestPipe* pipe) : pipe_(*pipe) {}
  ~RunServer();

  // Serves requests until the other end of the pipe is closed, then finishes the run.  The process
  // that has started the run then waits for its forks, and for the forks of these, because they use
  // its files.  A fork does not wait, because only it uses its files.  Returns the exit code.
  int Serve();
  // Returns whether this process is a fork that the command "fork" has made.
  bool is_copy() const { return is_copy_; }

 private:
  using Json = nlohmann::json;

  struct Answer;   // server_answer.h
  struct Request;  // server_answer.h
  using Work = Answer (RunServer::*)(const Request& request);
  static Work WorkOf(const std::string& name);

  bool ServeOne();
  Answer Do(const Request& request);
  Answer Refusal(const std::string& text) const;
  Answer Time();
  ServedRun& run();
  ServedRun& BootedRun();
  void CheckIsNotFinished();
  void BeginGuards(const std::vector<std::string>& crash_logs, int64_t handler_limit_us);
  void ReportEnding(Ending* ending);
  void SendFinalState(const Ending& ending);
  int64_t LimitOf(const Request& request);
  Answer BecomeCopy(int socket, const std::string& record,
                    const std::function<void(const std::string& problem)>& tell);

  Answer DoStart(const Request& request);
  Answer DoBoot(const Request& request);
  Answer DoRun(const Request& request);
  Answer DoStep(const Request& request);
  Answer DoUntil(const Request& request);
  Answer DoExpect(const Request& request);
  Answer DoWatch(const Request& request);
  Answer DoWatched(const Request& request);
  Answer DoObserve(const Request& request);
  Answer DoActuate(const Request& request);
  Answer DoAct(const Request& request);
  Answer DoConnect(const Request& request);
  Answer DoSend(const Request& request);
  Answer DoReceive(const Request& request);
  Answer DoDisconnect(const Request& request);
  Answer DoFork(const Request& request);
  Answer DoRead(const Request& request);
  Answer DoConsole(const Request& request);
  Answer DoPicture(const Request& request);
  Answer DoMotion(const Request& request);
  Answer DoReport(const Request& request);
  Answer DoFinish(const Request& request);
  Answer DoLive(const Request& request);

  RequestPipe& pipe_;
  bool is_copy_ = false;
  // A function that is called when a crash, or code that does not return, ends the process.
  // This function is registered first, so it is called last, after the function that completes the
  // recording of `run_`.  So the recording is complete even if this function crashes while it makes
  // the report.
  const EndingAction final_state_action_{[this](Ending* ending) { SendFinalState(*ending); }};
  std::unique_ptr<ServedRun> run_;
  std::optional<EndGuards> guards_;
  Observation observation_;
  std::vector<std::string> actuators_;
};

}  // namespace openr_host

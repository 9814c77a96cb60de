#include "openr/serve/run_server.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/print_plain.h"
#include "cli/process_copy.h"
#include "openr/live/live_events.h"
#include "openr/run/report.h"
#include "openr/serve/command_table.h"
#include "openr/serve/request_too_long.h"
#include "openr/serve/server_answer.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Returns the last message about a run that has ended while its images were loaded.  It has the
// members of the last message about other runs, but the report is as short as that of openr run.
nlohmann::ordered_json StateWhileLoading(const Ending& ending) {
  const Object& object = *ending.object;
  const nlohmann::ordered_json finding = {{"severity", SeverityName(Severity::kError)},
                                          {"robot", object.robot},
                                          {"object", object.name},
                                          {"time_s", 0.0},
                                          {"message", 0},
                                          {"said", ""},
                                          {"count", 1},
                                          {"text", std::string(ending.finding.text())}};
  const auto findings = nlohmann::ordered_json::array({finding});
  return {{"findings", findings},
          {"console", nlohmann::ordered_json::array()},
          {"report",
           {{"error", std::string(ending.record.text())},
            {"ended_by", EndName(ending.kind)},
            {"findings", findings}}}};
}

}  // namespace

RunServer::~RunServer() = default;

RunServer::Work RunServer::WorkOf(const std::string& name) {
  static const std::map<std::string, Work> works = {{"start", &RunServer::DoStart},
                                                    {"boot", &RunServer::DoBoot},
                                                    {"run", &RunServer::DoRun},
                                                    {"step", &RunServer::DoStep},
                                                    {"until", &RunServer::DoUntil},
                                                    {"expect", &RunServer::DoExpect},
                                                    {"watch", &RunServer::DoWatch},
                                                    {"watched", &RunServer::DoWatched},
                                                    {"observe", &RunServer::DoObserve},
                                                    {"actuate", &RunServer::DoActuate},
                                                    {"act", &RunServer::DoAct},
                                                    {"connect", &RunServer::DoConnect},
                                                    {"send", &RunServer::DoSend},
                                                    {"receive", &RunServer::DoReceive},
                                                    {"disconnect", &RunServer::DoDisconnect},
                                                    {"fork", &RunServer::DoFork},
                                                    {"read", &RunServer::DoRead},
                                                    {"console", &RunServer::DoConsole},
                                                    {"picture", &RunServer::DoPicture},
                                                    {"motion", &RunServer::DoMotion},
                                                    {"report", &RunServer::DoReport},
                                                    {"finish", &RunServer::DoFinish}};
  const auto found = works.find(name);
  return found == works.end() ? &RunServer::DoLive : found->second;
}

int RunServer::Serve() {
  while (ServeOne()) {
  }
  int exit_code = kExitGood;
  if (run_ != nullptr) {
    const std::string problem = run_->Finish();
    if (!problem.empty()) PrintPlain(stderr, "openr serve: {}\n", problem);
    if (!problem.empty()) exit_code = kExitWrong;
  }
  if (!is_copy_) WaitForAllCopies();
  return exit_code;
}

// Serves one request of the program that drives the run.  Returns false if the other end of the
// pipe is closed.
bool RunServer::ServeOne() {
  // Removes forks of this process that have ended, because they stay as zombies until somebody
  // waits for them.
  while (waitpid(-1, nullptr, WNOHANG) > 0) {
  }
  std::string text, bytes;
  Answer answer;
  try {
    if (!pipe_.Receive(&text, &bytes)) return false;
    Json json = ParseJson<Json>(text);
    const std::string problem = CompleteRequest(&json);
    answer = problem.empty() ? Do({json, bytes}) : Refusal(problem);
  } catch (const Json::exception&) {
    answer = Refusal("the request is no JSON");
  } catch (const JsonTooDeep& error) {
    answer = Refusal(error.what());
  } catch (const RequestTooLong& error) {
    // Ends the server, because the bytes of the refused request are still in the pipe, so the
    // beginning of the next request cannot be found.
    pipe_.Send(JsonText(Refusal(error.what()).json), "");
    return false;
  }
  pipe_.DropDescriptors();
  return pipe_.Send(JsonText(answer.json), answer.bytes);
}

RunServer::Answer RunServer::Refusal(const std::string& text) const {
  return {{{"error", text}, {"kind", "refused"}}, ""};
}

// Does the work of the command in `request`.  If the run is over, the answer also says how the run
// ended.
RunServer::Answer RunServer::Do(const Request& request) {
  Answer answer;
  try {
    answer = (this->*WorkOf(request.json.at("do")))(request);
  } catch (const std::exception& error) {
    answer = Refusal(error.what());
  }
  if (run_ != nullptr && run_->system().end()) {
    const RunEnd& end = *run_->system().end();
    answer.json["ended"] = {{"by", EndName(end.kind)}, {"why", end.why}};
  }
  return answer;
}

ServedRun& RunServer::run() {
  if (run_ == nullptr) throw std::runtime_error("there is no run yet; start makes one");
  return *run_;
}

ServedRun& RunServer::BootedRun() {
  if (!run().has_booted()) throw std::runtime_error("the robot has not booted yet; boot does that");
  return *run_;
}

// Throws std::runtime_error if the client has told the run to finish, because the run cannot go on
// then.  Does not throw if the run has ended because all robots are off: the answer to the command
// says so.
void RunServer::CheckIsNotFinished() {
  if (BootedRun().is_finished())
    throw std::runtime_error("the run is finished; it can be read but cannot go on");
}

RunServer::Answer RunServer::Time() {
  return {{{"time_s", static_cast<double>(run().system().now_us()) / 1e6}}, ""};
}

// Makes this process report a crash of an object, or code of an object that runs longer than
// `handler_limit_us`, before the process ends.  The process then writes a crash record and answers
// the present request.
void RunServer::BeginGuards(const std::vector<std::string>& crash_logs, int64_t handler_limit_us) {
  EndGuardOptions options;
  options.answer_first = [this](Ending* ending) { ReportEnding(ending); };
  options.crash_logs = crash_logs;
  options.handler_limit_us = handler_limit_us;
  options.limit_name = "handler_limit_s";
  guards_.emplace(std::move(options));
}

// Answers the present request when the process ends (docs/endings.md), because the program that
// drives the run waits for its answer.  Called in a signal handler.
void RunServer::ReportEnding(Ending* ending) {
  const RunEnd end = EndOf(*ending);
  const nlohmann::ordered_json answer = {{"error", std::string(ending->record.text())},
                                         {"kind", "ended"},
                                         {"ended", {{"by", EndName(end.kind)}, {"why", end.why}}}};
  pipe_.Send(JsonText(answer), "");
  ending->answered = true;
}

// Sends a second message after the message that ReportEnding() sends.  The second message has what
// the commands findings, console and report would answer now, because the program that drives the
// run cannot ask a process that ends.  Called in a signal handler.
void RunServer::SendFinalState(const Ending& ending) {
  try {
    if (run_ == nullptr) {
      pipe_.Send(JsonText(StateWhileLoading(ending)), "");
      return;
    }
    NoteTheEnding(ending, &run_->simulation());
    const Json from_first = {{"first", 0}};
    const nlohmann::ordered_json words = {{"findings", FindingsJson(run_->live())["findings"]},
                                          {"console", DoConsole({from_first, ""}).json["lines"]},
                                          {"report", run_->Report()}};
    pipe_.Send(JsonText(words), "");
  } catch (const std::exception&) {
    return;  // the pipe is closed, so the program gets no second message
  }
  PrintHandledMessage(ending);  // called last, because a crash in this call must not prevent Send()
}

}  // namespace openr_host

// The part of RunServer for commands that use the robot's network, copy the run and read its state.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cli/process_copy.h"
#include "openr/live/live_answers.h"
#include "openr/motion/mtn_csv.h"
#include "openr/motion/mtn_writer.h"
#include "openr/render/picture_request.h"
#include "openr/serve/run_server.h"
#include "openr/serve/server_answer.h"

namespace openr_host {
namespace {

using OrderedJson = nlohmann::ordered_json;

int IntegerOf(const nlohmann::json& request, const char* name) {
  const auto value = request.at(name).get<int64_t>();
  if (value < 0 || value > INT32_MAX)
    throw std::runtime_error(fmt::format("{} is {}, out of range", name, value));
  return static_cast<int>(value);
}

// A pipe by which a new copy of this process tells the original that it is ready.
class ReadyPipe {
 public:
  ReadyPipe() {
    if (pipe2(ends_, O_CLOEXEC) != 0) throw std::runtime_error(std::strerror(errno));
  }
  ~ReadyPipe() {
    close(ends_[0]);
    close(ends_[1]);
  }
  ReadyPipe(const ReadyPipe&) = delete;
  ReadyPipe& operator=(const ReadyPipe&) = delete;

  // Called in the copy.  Tells the original process the problem because of which the copy cannot go
  // on; "": the copy is ready.
  void Send(const std::string& problem) const {
    const std::string text = problem + '\n';
    [[maybe_unused]] const ssize_t count = write(ends_[1], text.data(), text.size());
  }
  // Called in the original process.  Waits for the text that the copy gives to Send(), and returns
  // this text.
  std::string Receive() {
    close(std::exchange(ends_[1], -1));
    std::string text;
    for (char part[512];;) {
      const ssize_t count = read(ends_[0], part, sizeof part);
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return "the copy has ended";
      text.append(part, static_cast<size_t>(count));
      if (text.ends_with('\n')) return text.substr(0, text.size() - 1);
    }
  }

 private:
  int ends_[2] = {-1, -1};
};

}  // namespace

RunServer::Answer RunServer::DoConnect(const Request& request) {
  CheckIsNotFinished();
  if (!run_->ForkProblem().empty())
    throw std::runtime_error("connect is for network='inside'; this run has sockets of the host");
  const int port = IntegerOf(request.json, "port");
  if (port < 1 || port > 65535) throw std::runtime_error(fmt::format("{} is no port", port));
  const int connection = run_->clients().Connect(run_->system(), IntegerOf(request.json, "robot"),
                                                 static_cast<uint16_t>(port));
  return {{{"connection", connection}}, ""};
}

RunServer::Answer RunServer::DoSend(const Request& request) {
  CheckIsNotFinished();
  run_->clients().Send(IntegerOf(request.json, "connection"), request.bytes);
  return Time();
}

RunServer::Answer RunServer::DoReceive(const Request& request) {
  CheckIsNotFinished();
  const int connection = IntegerOf(request.json, "connection");
  const auto count = static_cast<size_t>(IntegerOf(request.json, "count"));
  RobotClients& clients = run_->clients();
  const auto is_there = [&] {
    const RobotClients::State state = clients.StateOf(connection);
    return state.waiting >= count || state.has_ended;
  };
  if (const RobotClients::State state = clients.StateOf(connection);
      state.is_closed && state.waiting < count)
    throw std::runtime_error("the connection is closed");
  if (!is_there()) run_->RunUntilHolds(is_there, LimitOf(request));
  Answer answer = Time();
  // Takes no bytes from the connection when fewer than `count` have come.  The bytes then wait in
  // the connection, so that a later request can get all wanted bytes together.
  if (clients.StateOf(connection).waiting >= count)
    answer.bytes = clients.Take(connection, count == 0 ? SIZE_MAX : count);
  answer.json["open"] = clients.StateOf(connection).is_open;
  return answer;
}

RunServer::Answer RunServer::DoDisconnect(const Request& request) {
  run().clients().Close(IntegerOf(request.json, "connection"));
  return Time();
}

// Makes a copy of this process, and returns in both processes.  The original answers the request at
// its own pipe.  The copy answers at the socket that came with the request; this answer tells the
// program at the other end that the copy runs.
RunServer::Answer RunServer::DoFork(const Request& request) {
  const int socket = pipe_.TakeDescriptor();
  if (socket < 0)
    throw std::runtime_error(pipe_.is_socket()
                                 ? "fork needs a socket for the copy beside the request"
                                 : "fork needs a Unix socket as standard input, not a pipe");
  const auto record = request.json.at("record").get<std::string>();
  try {
    if (const std::string why = run().ForkProblem(); !why.empty())
      throw std::runtime_error("this run cannot be copied: " + why);
    if (!record.empty() && !run_->is_recorded())
      throw std::runtime_error("the run has no recording that could go on in " + record);
    // Makes this process a "subreaper" (prctl(2)): if a copy ends, this process becomes the parent
    // of the copies that the ended copy has made.  So Serve() waits for them, too.
    if (!is_copy_) prctl(PR_SET_CHILD_SUBREAPER, 1);
    ReadyPipe ready;
    const pid_t copy = CopyProcess(Flushed::kOwn, Orphan::kGoesOn);
    if (copy < 0) throw std::runtime_error(std::strerror(errno));
    if (copy == 0) return BecomeCopy(socket, record, [&](const std::string& t) { ready.Send(t); });
    // Waits until the copy has files of its own, because until then a change to the files by this
    // process would also change the files of the copy.
    const std::string problem = ready.Receive();
    if (!problem.empty()) throw std::runtime_error("this run cannot be copied: " + problem);
    close(socket);
    return {{{"process", copy}}, ""};
  } catch (...) {
    close(socket);
    throw;
  }
}

// Prepares this process, a new fork of the run, to serve requests at `socket`.  Calls `tell` with
// "" when the process is ready, or with an error.
RunServer::Answer RunServer::BecomeCopy(int socket, const std::string& record,
                                        const std::function<void(const std::string&)>& tell) {
  try {
    run_->BecomeCopy(record);
    guards_->StartAgain();
    // This process is now a copy of the run with a Memory Stick of its own, and must write a crash
    // record to that stick.
    guards_->set_crash_logs(run_->CrashLogs());
  } catch (const std::exception& error) {
    tell(error.what());
    // Ends the copy, because a copy without files of its own cannot go on, and must not read
    // requests from the pipe of the original process.
    _exit(1);
  }
  is_copy_ = true;
  pipe_.UseSocket(socket);
  tell("");
  return Time();
}

RunServer::Answer RunServer::DoRead(const Request& request) {
  OrderedJson values = OrderedJson::object();
  for (const auto& name : request.json.at("names")) {
    for (const ReadValue& value : FindValues(name.get<std::string>(), run().view())) {
      const Value now = value.read(run_->view());
      std::visit([&](const auto& known) { values[value.name] = known; }, now);
    }
  }
  Answer answer = Time();
  answer.json["values"] = std::move(values);
  return answer;
}

RunServer::Answer RunServer::DoConsole(const Request& request) {
  const ConsoleLog& console = run().console();
  const uint64_t oldest = console.count() - console.lines().size();
  const uint64_t first = std::clamp<uint64_t>(
      static_cast<uint64_t>(IntegerOf(request.json, "first")), oldest, console.count());
  OrderedJson lines = OrderedJson::array();
  for (uint64_t i = first; i < console.count(); ++i)
    lines.push_back(console.lines()[static_cast<size_t>(i - oldest)].text);
  return {{{"first", first}, {"next", console.count()}, {"lines", std::move(lines)}}, ""};
}

RunServer::Answer RunServer::DoPicture(const Request& request) {
  PictureRequest picture;
  const int robot = IntegerOf(request.json, "robot");
  const auto text = [&](const char* name) { return request.json.at(name).get<std::string>(); };
  const std::string view = text("view");
  const std::string size = view == "camera" ? "" : ",size=" + text("size");
  std::string problem =
      ParsePictureRequest(fmt::format("view={},robot={}{}", view, robot, size), &picture);
  if (!problem.empty()) throw std::runtime_error(problem);
  const auto& robots = run().simulation().robots();
  if (robot >= static_cast<int>(robots.size()))
    throw std::runtime_error(fmt::format("there is no robot {}", robot));
  picture.file = text("file");
  const bool is_together = run_->simulation().is_together();
  problem = WritePicture(picture, robots[static_cast<size_t>(robot)],
                         is_together ? robots : std::vector<VirtualRobot*>{});
  if (!problem.empty()) throw std::runtime_error(problem);
  return Time();
}

RunServer::Answer RunServer::DoMotion(const Request& request) {
  MotionFile motion = ParseMotionCsv(request.json.at("csv").get<std::string>());
  motion.name = request.json.at("name").get<std::string>();
  const std::vector<uint8_t> bytes = WriteMtn(motion);
  return {{{"size", bytes.size()}}, std::string(bytes.begin(), bytes.end())};
}

RunServer::Answer RunServer::DoReport(const Request&) { return {run().Report(), ""}; }

RunServer::Answer RunServer::DoFinish(const Request&) {
  const std::string problem = BootedRun().Finish();
  if (!problem.empty()) throw std::runtime_error(problem);
  return {run_->Report(), ""};
}

// Does the work of a command that clients of a run's socket can send, too (docs/inputs.md).
RunServer::Answer RunServer::DoLive(const Request& request) {
  if (request.json.at("do") == "input") CheckIsNotFinished();
  OrderedJson answer = AnswerLive(run().live(), request.json);
  if (answer.contains("error")) answer["kind"] = "refused";
  return {std::move(answer), ""};
}

}  // namespace openr_host

// The fuzz target live_request: what clients send to the socket of a run (docs/inputs.md).
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "openr/live/console_log.h"
#include "openr/live/couplings.h"
#include "openr/live/live_answers.h"
#include "openr/live/live_context.h"
#include "openr/live/live_folder.h"
#include "openr/live/live_server.h"
#include "openr/live/message_history.h"
#include "openr/live/run_clock.h"
#include "openr/rewind/rewind.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/hasher.h"
#include "runtime/base/temp_folder.h"
#include "runtime/core/system.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {
namespace {

constexpr char kServedName[] = "fuzz";
constexpr int64_t kServedFrameUs = 8000;

// Returns a folder with a stick without objects.  The sockets of runs lie in it, too, so that other
// programs of the user do not find them.
const std::string& ServedFolder() {
  static const TempFolder folder(TempUse::kSmallFiles);
  static const bool is_made = [] {
    const std::string conf = folder.path() + "/stick/OPEN-R/MW/CONF";
    std::filesystem::create_directories(conf);
    for (const char* const name : {"OBJECT.CFG", "CONNECT.CFG"})
      std::ofstream(conf + "/" + name) << "";
    return setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 1) == 0;
  }();
  FuzzCheck(is_made, "a folder for the run");
  return folder.path();
}

SimulationOptions ServedOptions() {
  SimulationOptions options;
  options.stick = ServedFolder() + "/stick";
  options.body = "ideal";
  options.images = kImagesOfPattern;
  options.host_network = false;
  options.writable_stick = false;
  options.console = [](std::string_view) {};
  return options;
}

// A run with the server of its socket.
class RequestedRun {
 public:
  RequestedRun() {
    // Checkpoints would be forks of the fuzz program.
    RewindParts parts;
    parts.simulation = &simulation_;
    parts.no_rewind_reason = "the run is fuzzed";
    rewind_.Begin(std::move(parts));
    simulation_.system().Boot();
  }

  // Answers what clients have sent.
  void Serve() { server_.WaitAndServe(0); }
  void RunFrame() {
    System& system = simulation_.system();
    if (!system.powered_off()) system.RunUntil(system.now_us() + kServedFrameUs);
  }
  RunClock* clock() { return &clock_; }

 private:
  Simulation simulation_{ServedOptions()};
  RunClock clock_{1};
  ConsoleLog console_;
  MessageHistory history_{&simulation_.system()};
  Rewind rewind_;
  Couplings couplings_{&clock_, &rewind_};
  LiveEvents events_{{&simulation_, &clock_, &console_, &history_, nullptr, &rewind_}};
  const LiveContext context_{&simulation_, &clock_, &console_, &history_, &events_, &rewind_};
  LiveServer server_{
      kServedName, [this](const nlohmann::json& request) { return AnswerLive(context_, request); },
      &events_, &couplings_};
};

class RequestingClient {
 public:
  RequestingClient() : descriptor_(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    const std::string path = LiveSocketPath(kServedName);
    FuzzCheck(path.size() < sizeof address.sun_path, "a short path");
    std::memcpy(address.sun_path, path.c_str(), path.size());
    FuzzCheck(
        connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0,
        "a client");
  }
  ~RequestingClient() { close(descriptor_); }
  RequestingClient(const RequestingClient&) = delete;
  RequestingClient& operator=(const RequestingClient&) = delete;

  // Sends one line and checks that it gets one answer.
  void Ask(std::string_view line, RequestedRun* run) {
    const std::string text = std::string(line) + "\n";
    FuzzCheck(send(descriptor_, text.data(), text.size(), MSG_NOSIGNAL) ==
                  static_cast<ssize_t>(text.size()),
              "a line is sent");
    const int answers = answers_;
    run->Serve();
    while (Receive()) run->Serve();
    FuzzCheck(answers_ == answers + 1, "each request has an answer");
  }

 private:
  // Reads what has come.  Returns false if nothing has.
  bool Receive() {
    char buffer[64 << 10];
    const ssize_t count = recv(descriptor_, buffer, sizeof buffer, 0);
    FuzzCheck(count != 0, "a client with short requests is not closed");
    if (count < 0) return false;
    received_.append(buffer, static_cast<size_t>(count));
    for (size_t end; (end = received_.find('\n')) != std::string::npos;) {
      const auto line = nlohmann::json::parse(received_.substr(0, end), nullptr, false);
      received_.erase(0, end + 1);
      FuzzCheck(line.is_object(), "an answer is a JSON object");
      if (!line.contains("event")) ++answers_;
    }
    return true;
  }

  const int descriptor_;
  std::string received_;  // the begin of a line that is not complete
  int answers_ = 0;
};

// Notes the name of the request and the names of its members, because all requests have the same
// branches.
void NoteMembers(std::string_view line) {
  const auto request = nlohmann::json::parse(line, nullptr, false);
  if (!request.is_object() || !request.contains("do") || !request["do"].is_string()) return;
  std::string names = request["do"].get<std::string>();
  if (names.size() > 10) return;
  constexpr const char* kMembers[] = {"line",  "name",   "step",       "rate",   "pause",
                                      "count", "layer",  "connection", "events", "robot",
                                      "to_s",  "back_s", "with"};
  for (const char* const member : kMembers) names += request.contains(member) ? '1' : '0';
  ReachFuzzState(HashBytes(names.data(), names.size()));
}

}  // namespace

bool fuzz::live_request(std::string_view bytes) {
  RequestedRun run;
  RequestingClient client;
  RunClock* const clock = run.clock();
  while (!bytes.empty()) {
    const size_t end = std::min(bytes.find('\n'), bytes.size());
    client.Ask(bytes.substr(0, end), &run);
    NoteMembers(bytes.substr(0, end));
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    run.RunFrame();
    // All states of the clock have the same branches.
    constexpr uint64_t kClockStates = 1000;
    ReachFuzzState(kClockStates + (clock->paused() ? 1 : 0) + (clock->rate() > 2 ? 2 : 0));
  }
  // Takes the steps that wait, because the clock does not say how many there are.
  int steps = 0;
  while (steps < 3 && clock->TakeStep() != RunClock::Step::kNone) ++steps;
  return clock->paused() && clock->rate() > 2 && steps == 3;
}

}  // namespace openr_host

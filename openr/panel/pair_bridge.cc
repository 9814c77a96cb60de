#include "openr/panel/pair_bridge.h"

#include <fmt/format.h>

#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "cli/json_text.h"
#include "openr/live/live_client.h"
#include "openr/live/request_reader.h"
#include "openr/pair/remote_pair.h"
#include "openr/panel/endpoints.h"

namespace openr_host {

// The data that a PairBridge and its thread share.
struct PairBridge::Work {
  Work(const LiveRun& in_run, size_t in_robot, const remote::Address& in_second,
       nlohmann::json in_id, std::shared_ptr<AnswerQueue> in_answers)
      : run(in_run),
        robot(in_robot),
        second(in_second),
        id(std::move(in_id)),
        answers(std::move(in_answers)) {}

  const LiveRun run;
  const size_t robot;
  const remote::Address second;
  const nlohmann::json id;  // id of the request that connects the robots
  const std::shared_ptr<AnswerQueue> answers;
  PairOptions options;
  PairControl control;
  std::atomic<bool> is_over = false;
};

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr int kFrameMs = 8;
constexpr int kPeriodMinMs = 32, kPeriodMaxMs = 1000;
constexpr int kRunTimeoutMs = 3000;
constexpr double kCdegInDeg = 100;
constexpr size_t kKnownMax = 1000;

std::atomic<int> g_pair_threads = 0;

// Returns whether the server connects the two robots of `work` for the first time.
bool IsFirstTime(const PairBridge::Work& work) {
  static std::mutex mutex;
  static std::set<std::string> known;
  const std::lock_guard lock(mutex);
  // Forgets all pairs of robots when kKnownMax pairs are known.  Pages may name any number of
  // robots, and this set must not grow without limit.
  if (known.size() >= kKnownMax) known.clear();
  return known.insert(fmt::format("{} {} {}", work.run.socket, work.robot, work.second.Text()))
      .second;
}

const char* NameOf(Follow follow) {
  return follow == Follow::kFirst ? "simulation" : follow == Follow::kSecond ? "robot" : "none";
}

PairSettings SettingsOf(const nlohmann::json& request) {
  PairSettings settings;
  settings.follows_motions = RequestReader(request).BoolOr("simulation", true);
  const std::string follow = RequestReader(request).TextOr("follow", "none");
  if (follow == "simulation") {
    settings.follow = Follow::kFirst;
  } else if (follow == "robot") {
    settings.follow = Follow::kSecond;
  } else if (follow != "none") {
    throw std::runtime_error(
        fmt::format("'follow' is none, simulation or robot, not '{}'", follow));
  }
  if (settings.follow == Follow::kFirst && !settings.follows_motions)
    throw std::runtime_error("the simulation is not controlled, so it cannot follow the robot");
  return settings;
}

OrderedJson DegreesJson(const std::vector<int32_t>& values) {
  OrderedJson degrees = OrderedJson::array();
  for (const int32_t value : values) degrees.push_back(value / kCdegInDeg);
  return degrees;
}

template <typename Value>
OrderedJson OrNull(const std::optional<Value>& value) {
  return value ? OrderedJson(*value) : OrderedJson();
}

OrderedJson EventOf(const PairBridge::Work& work, const char* state) {
  return {{"event", "pair"},
          {"pair", work.id},
          {"robot", work.robot},
          {"endpoint", work.second.Text()},
          {"state", state}};
}

OrderedJson StatusJson(const PairBridge::Work& work, const PairStatus& status) {
  OrderedJson event = EventOf(work, "connected");
  event["follow"] = NameOf(status.follow);
  event["round_trip_ms"] = OrNull(status.round_trip_ms[kSecond]);
  event["run_round_trip_ms"] = OrNull(status.round_trip_ms[kFirst]);
  event["lag_ms"] = OrNull(status.lag_ms);
  event["robot_state"] = status.state[kSecond];
  event["deg"] = DegreesJson(status.joints[kSecond]);
  event["motion"] = status.motion;
  event["key_frame"] = status.key_frame;
  event["key_frames"] = status.key_frames;
  event["refusal"] = {{"simulation", status.refusal[kFirst]}, {"robot", status.refusal[kSecond]}};
  return event;
}

// A coupling of a robot of the run with a second robot.  While it exists, the run goes on in real
// time and cannot be rewound.
class Coupling {
 public:
  // Begins the coupling of the two robots of `work`.  Throws std::runtime_error if the run refuses
  // the coupling.
  explicit Coupling(const PairBridge::Work& work) : live_(work.run, kRunTimeoutMs), work_(work) {
    const OrderedJson answer = Ask(work.second.Text());
    if (answer.contains("error")) throw std::runtime_error(answer["error"].get<std::string>());
  }
  ~Coupling() {
    try {
      Ask("");  // ends the coupling, so that the run has its earlier rate again at once
    } catch (const std::exception&) {
      // Ignores an error of the request that ends the coupling: either the run has ended, or the
      // run ends the coupling when it sees that the connection is closed.
    }
  }
  Coupling(const Coupling&) = delete;
  Coupling& operator=(const Coupling&) = delete;

 private:
  OrderedJson Ask(const std::string& with) {
    return live_.Ask({{"do", "couple"}, {"robot", work_.robot}, {"with", with}});
  }

  LiveClient live_;
  const PairBridge::Work& work_;
};

// Prepares the pair as Hohl 2004, section 3.3.1 describes: gives the first robot's joints the
// limits of the second robot's joints and, if these two robots are connected for the first time,
// switches lights and ears off.  Returns the answer for the page.
OrderedJson Prepare(const PairBridge::Work& work, RemotePair* pair) {
  OrderedJson joints = OrderedJson::array();
  const std::vector<RcJointState> limits = pair->CopyLimits();
  for (size_t i = 0; i < limits.size(); ++i) {
    joints.push_back({{"name", pair->joints()[i].name},
                      {"speed", limits[i].speed / kCdegInDeg},
                      {"accel", limits[i].acceleration / kCdegInDeg}});
  }
  const bool is_first = IsFirstTime(work);
  if (is_first) pair->ResetLights();
  return {{"endpoint", work.second.Text()},
          {"model", pair->info(kSecond).design},
          {"software", pair->info(kSecond).software},
          {"first_time", is_first},
          {"joints", std::move(joints)}};
}

void Send(const PairBridge::Work& work, OrderedJson json) { work.answers->Add(JsonText(json)); }

void SendAnswer(const PairBridge::Work& work, OrderedJson answer) {
  if (!work.id.is_null()) answer["id"] = work.id;
  Send(work, std::move(answer));
}

// Connects both robots and serves them until the connection ends.  Returns the reason why the
// connection was lost.  Returns "" if a page ended the connection, or if the page already knows why
// the connection could not be made.
std::string ServePair(PairBridge::Work* work) {
  bool is_connected = false;
  try {
    RefuseOwnRobots(work->run, work->second);
    RemotePair pair(AddressInRun(work->run, work->robot), work->second, work->options);
    // Ends here if the page has ended the connection meanwhile, because connecting to the robots
    // may take seconds.
    if (work->control.is_ended()) return "";
    const Coupling coupling(*work);
    SendAnswer(*work, Prepare(*work, &pair));
    is_connected = true;
    pair.Run(&work->control,
             [work](const PairStatus& status) { Send(*work, StatusJson(*work, status)); });
  } catch (const std::exception& error) {
    if (is_connected) return error.what();
    work->is_over = true;
    SendAnswer(*work, {{"error", error.what()}});
  }
  return "";
}

}  // namespace

PairBridge::PairBridge(const LiveRun& run, size_t robot, const nlohmann::json& request,
                       std::shared_ptr<AnswerQueue> answers)
    : work_(std::make_shared<Work>(run, robot,
                                   ParseEndpoint(RequestReader(request).At("endpoint").Text()),
                                   request.value("id", nlohmann::json()), std::move(answers))) {
  const auto period_ms = static_cast<int>(
      RequestReader(request).WholeOr("period_ms", kPeriodMinMs, kPeriodMaxMs, kPeriodMinMs));
  work_->options.period = period_ms / (kFrameMs * RC_FRAMES_PER_VECTOR) * RC_FRAMES_PER_VECTOR;
  work_->options.first_may_pause = true;
  work_->control.SetSettings(SettingsOf(request));
  if (g_pair_threads >= kThreadsMax)
    throw std::runtime_error("too many connections to robots are being closed; try again soon");
  ++g_pair_threads;
  try {
    // Detaches the thread, because the event loop must not wait for a robot that does not answer.
    std::thread([work = work_] {
      const std::string why = ServePair(work.get());
      work->is_over = true;
      OrderedJson event = EventOf(*work, why.empty() ? "closed" : "lost");
      event["why"] = why;
      Send(*work, std::move(event));
      --g_pair_threads;
    }).detach();
  } catch (const std::system_error&) {
    --g_pair_threads;  // this computer cannot make a thread
    throw;
  }
}

PairBridge::~PairBridge() { work_->control.End(); }

void PairBridge::Set(const nlohmann::json& request) {
  work_->control.SetSettings(SettingsOf(request));
}

bool PairBridge::is_over() const { return work_->is_over; }

bool PairBridge::HasThreads() { return g_pair_threads > 0; }

}  // namespace openr_host

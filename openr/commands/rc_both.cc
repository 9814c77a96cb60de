// The actions of `openr rc` for two robots at once.
#include "openr/commands/rc_both.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/print_plain.h"
#include "cli/standard_streams.h"
#include "openr/commands/rc_format.h"
#include "openr/pair/remote_pair.h"
#include "openr/remote/connection.h"
#include "openr/remote/error.h"
#include "openr/run/interrupt.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// Duration of a sensor vector, which has 4 frames of 8 ms.
constexpr int64_t kFollowVectorUs = 32'000;
constexpr int64_t kFollowPeriodMaxUs = 10'000'000;
// Number of status reports about the pair of robots after which a line is printed.  This makes one
// line a second, because RemotePair reports the status every 200 ms.
constexpr int kStatusesPerReport = 5;

// Robot that performs the same action as another robot (--with), and the result of the action at
// this robot.
struct Partner {
  std::string address;
  std::unique_ptr<remote::Connection> connection;
  std::string problem;
  Json refusal;  // answer for --json if the robot has refused the request; else null
  // True: nobody reads standard output any more, so the robot's answer is lost.
  bool is_answer_lost = false;
};

void PerformOne(Partner* robot, const RcFlags& flags, const RcAction& action) {
  const RcRobotLabel label(robot->address);
  try {
    action(robot->connection.get(), flags);
  } catch (const remote::Error& error) {
    robot->problem = error.what();
    if (error.code() != remote::ErrorCode::kRefused) return;
    robot->problem =
        fmt::format("{}: {} refused: {}", robot->address, FrameText(error.frame()), error.what());
    robot->refusal = {{"robot", robot->address},
                      {"frame", FrameJson(error.frame())},
                      {"error", error.text()},
                      {"status", error.status()}};
  } catch (const ReaderGone&) {
    robot->is_answer_lost = true;
  } catch (const std::exception& error) {
    robot->problem = error.what();
  }
}

std::string Milliseconds(const std::optional<double>& value) {
  return value ? fmt::format("{:.0f} ms", *value) : "unknown";
}

// Prints one line about a robot that follows another robot: the lag, and the joint with the largest
// difference between the two robots.
void PrintFollowing(const RcFlags& flags, const std::vector<RcDescription>& joints,
                    const PairStatus& status) {
  const auto &mine = status.joints[kFirst], &other = status.joints[kSecond];
  size_t largest = 0;
  int64_t difference = 0;
  for (size_t i = 0; i < std::min({mine.size(), other.size(), joints.size()}); ++i) {
    const int64_t here = std::abs(int64_t{mine[i]} - other[i]);
    if (here < difference) continue;
    difference = here;
    largest = i;
  }
  const std::string name = joints.empty() ? "" : joints[largest].name;
  if (flags.json) {
    Json json = {{"lag_ms", status.lag_ms ? Json(*status.lag_ms) : Json()},
                 {"round_trip_ms", Json::array()},
                 {"difference_deg", static_cast<double>(difference) / 100},
                 {"joint", name},
                 {"states", {status.state[kFirst], status.state[kSecond]}},
                 {"motion", status.motion},
                 {"refusal", status.refusal[kFirst]}};
    for (const auto& each : status.round_trip_ms)
      json["round_trip_ms"].push_back(each ? Json(*each) : Json());
    PrintAnswer(JsonText(json) + "\n");
  } else {
    const std::string lag = status.lag_ms ? fmt::format("{} ms", *status.lag_ms) : "unknown";
    const std::string& why = status.refusal[kFirst];
    PrintAnswer(TerminalText(fmt::format(
        "lag {}; round trips {} and {}; largest difference {} {:.2f} deg{}{}\n", lag,
        Milliseconds(status.round_trip_ms[kFirst]), Milliseconds(status.round_trip_ms[kSecond]),
        name, static_cast<double>(difference) / 100, why.empty() ? "" : "; refused: ", why)));
  }
  FlushAnswer();
}

}  // namespace

int PerformAtBoth(const RcFlags& flags, const RcAction& action) {
  Partner robots[2];
  robots[0].address = flags.address;
  robots[1].address = flags.with;
  // Connects to both robots before the action begins, so that no robot does anything if one of the
  // two cannot be reached.
  for (Partner& robot : robots) {
    robot.connection =
        std::make_unique<remote::Connection>(remote::ParseAddress(robot.address), OptionsOf(flags));
  }
  std::thread second([&] { PerformOne(&robots[1], flags, action); });
  PerformOne(&robots[0], flags, action);
  second.join();
  int exit_code = kExitGood;
  for (const Partner& robot : robots) {
    if (robot.is_answer_lost) exit_code = kExitReaderGone;
  }
  for (const Partner& robot : robots) {
    if (robot.problem.empty()) continue;
    PrintPlain(stderr, "openr: {}\n", robot.problem);
    if (flags.json && !robot.refusal.is_null()) PrintPlain("{}\n", JsonText(robot.refusal));
    exit_code = kExitWrong;
  }
  return exit_code;
}

int FollowRobot(const RcFlags& flags) {
  if (flags.stream_us < kFollowVectorUs || flags.stream_us > kFollowPeriodMaxUs)
    throw std::runtime_error("--every is 32ms to 10s");
  PairOptions options;
  options.connection = OptionsOf(flags);
  options.period = static_cast<int>(flags.stream_us / kFollowVectorUs) * RC_FRAMES_PER_VECTOR;
  options.tracks[kFirst] = flags.track;
  RemotePair pair(remote::ParseAddress(flags.address), remote::ParseAddress(flags.with), options);
  PairControl control;
  control.SetSettings({.follow = Follow::kFirst, .follows_motions = true});
  const InterruptCounter interrupts;
  int statuses = 0;
  pair.Run(&control, [&](const PairStatus& status) {
    if (interrupts.count() > 0) return control.End();
    if (++statuses % kStatusesPerReport != 0) return;
    PrintFollowing(flags, pair.joints(), status);
    if (statuses / kStatusesPerReport == flags.count) control.End();
  });
  return kExitGood;
}

}  // namespace openr_host

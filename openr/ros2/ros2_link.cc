#include "openr/ros2/ros2_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/counted.h"
#include "openr/ros2/joint_command.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Number of frames (1 s) after which joint targets that could not be sent to the robot are dropped.
constexpr int kPatienceFrames = 125;
constexpr size_t kNamespaceMax = 64;  // largest length of a namespace, in characters
constexpr const char* kCommandTopic = "/joint_command";
constexpr const char* kInputTopic = "/input";

}  // namespace

std::string WrongNamespace(const std::string& name) {
  bool is_good = name.size() <= kNamespaceMax && name.find("__") == std::string::npos;
  bool at_start = true;  // true: the character `c` begins a word
  for (const char c : name) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
    const bool is_digit = c >= '0' && c <= '9';
    is_good = is_good && (is_letter || (!at_start && (is_digit || c == '/')));
    at_start = c == '/';
  }
  if (is_good && !at_start) return "";
  return fmt::format(
      "'{}' is no namespace of ROS 2: words of letters, digits and single _ that do not begin with "
      "a digit, with / between them, {} characters at most",
      name, kNamespaceMax);
}

Ros2Link::Ros2Link(Bus* bus, std::string space, SimulationOptions* options, Say say)
    : bus_(bus), space_(std::move(space)), say_(std::move(say)), clock_(bus, "clock") {
  robots_.resize(static_cast<size_t>(options->robots));
  for (size_t i = 0; i < robots_.size(); ++i) {
    robots_[i].space = robots_.size() == 1 ? space_ : space_ + std::to_string(i);
    robots_[i].problems = std::make_unique<Ros2Problems>(robots_[i].space, say_);
  }
  options->network_filter = [this, outer = options->network_filter](
                                int index, std::unique_ptr<Network> inner) {
    Robot& robot = robots_.at(static_cast<size_t>(index));
    const std::string topic = robot.space + kCommandTopic;
    auto client = std::make_unique<JointClient>(
        std::move(inner), [topic, problems = robot.problems.get()](const std::string& why) {
          problems->Add(fmt::format("{}: the robot refuses: {}", topic, why));
        });
    robot.client = client.get();
    std::unique_ptr<Network> result = std::move(client);
    return outer ? outer(index, std::move(result)) : std::move(result);
  };
}

void Ros2Link::Begin(Simulation* simulation) {
  simulation_ = simulation;
  for (size_t i = 0; i < robots_.size(); ++i) {
    Robot& robot = robots_[i];
    robot.robot = simulation->robots().at(i);
    robot.topics = std::make_unique<RobotTopics>(bus_, robot.space, robot.robot);
    robot.commands = std::make_unique<Ros2JointCommands>(bus_, robot.space + kCommandTopic);
    robot.inputs = std::make_unique<Ros2Texts>(bus_, robot.space + kInputTopic);
  }
  const std::string last = robots_.size() == 1 ? "" : " to /" + robots_.back().space;
  say_(fmt::format("ROS 2: topics of /{}{} in DDS domain {}", robots_.front().space, last,
                   bus_->domain()));
}

void Ros2Link::AfterFrame() {
  const int64_t now_us = simulation_->system().now_us();
  clock_.Publish(now_us);
  for (Robot& robot : robots_) {
    const std::string problem = robot.topics->Publish(now_us);
    if (!problem.empty()) robot.problems->Add(robot.space + "/image_raw: " + problem);
    ApplyCommands(&robot);
    ApplyInputs(&robot);
  }
}

void Ros2Link::ApplyCommands(Robot* robot) {
  const std::string topic = robot->space + kCommandTopic;
  if (robot->commands->HasIncompatibleWriter()) {
    robot->problems->Add(
        topic +
        ": a publisher does not match and is not heard; it has to be reliable and to speak "
        "XCDR1, which is the default of ROS 2");
  }
  // Calls IsWaiting() before SetTargets() stores newer joint targets, because frames_waiting must
  // count only targets that have waited since the last frame.
  const bool is_waiting = robot->client->IsWaiting();
  for (int i = 0; i < Ros2JointCommands::kWaitingMax; ++i) {
    const std::optional<Ros2JointCommand> command = robot->commands->Take();
    if (!command) break;
    std::map<int, JointTarget> targets;
    const std::string problem = ReadJointCommand(*command, robot->robot->model(), &targets);
    if (!problem.empty()) robot->problems->Add(fmt::format("{}: refused: {}", topic, problem));
    robot->client->SetTargets(targets);
  }
  robot->frames_waiting = is_waiting ? robot->frames_waiting + 1 : 0;
  if (robot->frames_waiting == kPatienceFrames) {
    robot->frames_waiting = 0;
    // Drops the joint targets, because the robot must not move later by an old command.
    robot->client->GiveUp();
    robot->problems->Add(fmt::format(
        "{}: the remote control of the robot has not taken a command for 1 s, it is given up; is "
        "RCServer on the stick and started, and has it less than eight clients?",
        topic));
  }
}

// Gives the robot the inputs (docs/inputs.md) that have come from ROS 2, in their order.  The
// inputs take effect at the present frame boundary.
void Ros2Link::ApplyInputs(Robot* robot) {
  const std::string topic = robot->space + kInputTopic;
  if (robot->inputs->HasIncompatibleWriter()) {
    robot->problems->Add(topic +
                         ": a publisher does not match and is not heard; it has to be "
                         "reliable, which is the default of ROS 2");
  }
  for (int i = 0; i < Ros2Texts::kWaitingMax; ++i) {
    const std::optional<std::string> line = robot->inputs->Take();
    if (!line) return;
    const std::string problem =
        simulation_->system().inputs().Add(robot->robot->parts().robot_index, *line);
    if (!problem.empty()) robot->problems->Add(fmt::format("{}: refused: {}", topic, problem));
  }
}

void Ros2Link::End() {
  for (const Robot& robot : robots_) robot.problems->PrintLeftOutCount();
}

void Ros2Problems::Add(const std::string& what) {
  if (said_.contains(what)) return;
  if (said_.size() == kMax) {
    ++unsaid_count_;
    return;
  }
  said_.insert(what);
  say_("ROS 2: " + what + " (said once)");
  if (said_.size() == kMax) say_(fmt::format("ROS 2: no more of this is said of /{}", robot_));
}

void Ros2Problems::PrintLeftOutCount() const {
  if (unsaid_count_ == 0) return;
  say_(fmt::format("ROS 2: /{}: {} not said", robot_,
                   Counted(static_cast<uint64_t>(unsaid_count_), "more problem") +
                       (unsaid_count_ == 1 ? " was" : " were")));
}

}  // namespace openr_host

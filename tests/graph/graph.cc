#include "tests/graph/graph.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <map>

namespace openr_host {
namespace {

constexpr double kDegree = 57.29577951308232;

SimulationOptions OptionsOf(const GraphOptions& graph, std::string* console) {
  SimulationOptions options;
  options.stick = graph.stick;
  options.body = graph.body;
  options.seed = graph.seed;
  options.host_network = false;
  options.console = [console](std::string_view text) { console->append(text); };
  return options;
}

}  // namespace

Graph::Graph(const GraphOptions& options)
    : simulation_(std::make_unique<Simulation>(OptionsOf(options, &console_))) {
  pilot_ = system().AddObject<Pilot>(0, "pilot");
  Pilot::Wire(&system());
  system().Boot();
}

std::vector<std::string> Graph::MoverStates() const {
  std::vector<std::string> states;
  const std::string key = "state: ";
  for (size_t at = console_.find(key); at != std::string::npos; at = console_.find(key, at)) {
    at += key.size();
    states.push_back(console_.substr(at, console_.find('\n', at) - at));
  }
  return states;
}

bool Graph::RunToStanding() {
  const Object* const mover = system().FindObject(0, "JointMover");
  if (mover == nullptr) return false;
  const auto accepts = [&] { return mover->state == "accepting-commands"; };
  if (!system().RunUntil(accepts, 20'000'000)) return false;
  system().RunFor(500'000);
  return true;
}

double Graph::JointDeg(const std::string& name) {
  const int joint = simulation_->model().FindJoint(name);
  return dog().body().state().joints.at(static_cast<size_t>(joint)).angle_rad * kDegree;
}

double Graph::RollDeg() {
  const Eigen::Matrix3d R = dog().body().state().X_WB.linear();
  return std::atan2(R(2, 1), R(2, 2)) * kDegree;
}

double Graph::PitchDeg() {
  const Eigen::Matrix3d R = dog().body().state().X_WB.linear();
  return std::asin(-R(2, 0)) * kDegree;
}

bool Graph::Standing() {
  StandingMonitor monitor(simulation_->model());
  for (int frame = 0; frame < 75; ++frame) {
    system().RunFor(kFrameUs);
    monitor.Sample(dog().body().state(), system().now_us());
  }
  return monitor.standing();
}

std::string Graph::Findings() {
  std::string text;
  for (const Finding& finding : system().findings().all()) {
    text += std::string(SeverityName(finding.severity)) + ": " + finding.object + ": " +
            finding.text + "\n";
  }
  return text;
}

void WhenStanding(const GraphOptions& options, const std::function<void(Graph&)>& test) {
  static std::map<std::string, std::unique_ptr<Graph>> standing;
  std::unique_ptr<Graph>& graph = standing[options.body + std::to_string(options.seed)];
  if (graph == nullptr) {
    graph = std::make_unique<Graph>(options);
    ASSERT_TRUE(graph->RunToStanding()) << graph->console() << graph->Findings();
  }
  std::fflush(nullptr);
  const pid_t child = fork();
  ASSERT_GE(child, 0) << "fork failed";
  if (child == 0) {
    test(*graph);
    std::fflush(nullptr);
    _exit(testing::Test::HasFailure() ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0)
      << "failed in its copy of the process; see above";
}

}  // namespace openr_host

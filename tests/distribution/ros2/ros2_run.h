// Runs `openr run --ros2` beside a plain DDS participant (tests/ros2_peer), which has the settings
// that docs/ros2.md recommends.
#pragma once

#include <gmock/gmock.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <string>

#include "tests/distribution/same_run.h"

namespace openr_host {

// A domain that no other test uses at the same time.  Each shard of tools/run_tests.py has 48
// domains, from 1, 121 and so on.  Not among them are 0 (most tests, and users of openr), 77
// (kill_rounds.py) and 101 to 112 (bench); the largest is 232.
inline std::string NewDomain() {
  constexpr int kFirst[] = {1, 121, 169, 49};
  constexpr int kCount[] = {48, 48, 48, 28};
  static int number = 0;
  const char* const index = std::getenv("GTEST_SHARD_INDEX");
  const size_t shard = index == nullptr ? 0 : static_cast<size_t>(std::atoi(index)) % 4;
  return std::to_string(kFirst[shard] + number++ % kCount[shard]);
}

// The settings of Cyclone DDS that docs/ros2.md shows first.
inline std::string DocumentedSettings() {
  std::ifstream page(OPENR_DOCS "/ros2.md");
  std::ostringstream text;
  text << page.rdbuf();
  const std::string end = "</CycloneDDS>";
  const size_t from = text.str().find("<CycloneDDS>");
  const size_t to = text.str().find(end, from);
  if (to == std::string::npos) return "";
  return text.str().substr(from, to - from + end.size());
}

class Ros2Peer {
 public:
  explicit Ros2Peer(std::string domain) : domain_(std::move(domain)) {
    setenv("CYCLONEDDS_URI", DocumentedSettings().c_str(), 1);
  }
  ~Ros2Peer() { unsetenv("CYCLONEDDS_URI"); }
  Ros2Peer(const Ros2Peer&) = delete;
  Ros2Peer& operator=(const Ros2Peer&) = delete;

  // Runs a command of the peer; returns its output, lines of JSON.
  std::vector<json> Do(const Words& words) const {
    const ProgramResult result = ProgramRun(Words{domain_} + words, ROS2_PEER).Finish();
    EXPECT_EQ(result.status, 0) << result.err;
    std::vector<json> answers;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);)
      answers.push_back(json::parse(line, nullptr, false));
    return answers;
  }
  std::vector<json> Read(const std::string& type, const std::string& topic, int count) const {
    return Do({"read", type, topic, std::to_string(count)});
  }
  json ReadOne(const std::string& type, const std::string& topic) const {
    const std::vector<json> samples = Read(type, topic, 1);
    return samples.empty() ? json() : samples[0];
  }
  double Position(const std::string& robot, const std::string& joint) const {
    const json state = ReadOne("sensor_msgs/JointState", "rt/" + robot + "/joint_states");
    for (size_t i = 0; i < state.value("name", json::array()).size(); ++i) {
      if (state["name"][i] == joint) return state["position"][i];
    }
    ADD_FAILURE() << "no joint " << joint;
    return 0;
  }

 private:
  const std::string domain_;
};

// A run that goes on until it is ended.
class Ros2Run {
 public:
  explicit Ros2Run(const Words& flags, const std::string& rate = "30")
      : domain_(NewDomain()),
        peer_(domain_),
        run_(Words{"run", "--no-panel", "--rc-port", "0", "--console", "/dev/null", "--rate", rate,
                   "--ros2", "--dds-domain", domain_} +
             flags) {
    EXPECT_TRUE(run_.WaitFor("in DDS domain " + domain_)) << run_.heard();
  }

  const Ros2Peer& peer() const { return peer_; }
  const std::string& domain() const { return domain_; }
  ProgramRun& program() { return run_; }

  // Waits until virtual time `time_us`.
  void WaitUntil(int64_t time_us) const {
    while (peer_.ReadOne("rosgraph_msgs/Clock", "rt/clock").value("stamp_us", time_us) < time_us) {
    }
  }
  // Waits until the dog stands.
  void WaitForStanding() const { WaitUntil(15'000'000); }

  // Ends the run at once; returns its output.
  const ProgramResult& End() {
    run_.Signal(SIGINT);
    run_.WaitFor("pause button");
    run_.Signal(SIGINT);
    return run_.Finish();
  }

 private:
  const std::string domain_;
  const Ros2Peer peer_;
  ProgramRun run_;
};

}  // namespace openr_host

// The whole graph in a test: the default stick, a body, a pilot that gives commands.
//
//   Graph graph({.body = "ideal"});
//   graph.RunToStanding();
//   graph.pilot().Move(joint, 0.5);
//
// Standing up takes about 13 s of virtual time.  WhenStanding() does it once per kind of
// body and gives every test a copy of that process (fork), so that a test begins with
// a standing dog and cannot disturb another.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "openr/simulation.h"
#include "openr/standing.h"
#include "tests/graph/pilot.h"

namespace openr_host {

struct GraphOptions {
  std::string body = "ode";
  uint64_t seed = 1;
  std::string stick = OPENR_STICK;
};

inline const GraphOptions kIdeal{.body = "ideal", .seed = 1, .stick = OPENR_STICK};

inline GraphOptions OnStick(const std::string& stick) {
  GraphOptions options;
  options.stick = stick;
  return options;
}

class Graph {
 public:
  explicit Graph(const GraphOptions& options = {});

  Simulation& simulation() { return *simulation_; }
  System& system() { return simulation_->system(); }
  VirtualRobot& dog() { return *simulation_->robots()[0]; }
  Pilot& pilot() { return *pilot_; }
  const std::string& console() const { return console_; }

  // States JointMover has said, in order.
  std::vector<std::string> MoverStates() const;

  // Until JointMover accepts commands, and half a second more.  False when it does not
  // within 20 s.
  bool RunToStanding();

  double JointDeg(const std::string& name);
  double RollDeg();
  double PitchDeg();  // right-handed: nose down is positive
  bool Standing();    // the rule of docs/cli.md, over the next 0.6 s
  std::string Findings();

 private:
  std::string console_;
  std::unique_ptr<Simulation> simulation_;
  Pilot* pilot_;
};

// Runs `test` in a copy of a process in which the dog stands.  A failed expectation in
// it fails the calling test.
void WhenStanding(const GraphOptions& options, const std::function<void(Graph&)>& test);

}  // namespace openr_host

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

#include <openr/testing.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/graph/pilot.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {

struct GraphOptions {
  std::string body = "ode";
  uint64_t seed = 1;
  std::string stick = OPENR_STICK;
  bool measure_stacks = false;
  std::string robot = "ers210";
  std::string world = "";
};

inline const GraphOptions kIdeal{.body = "ideal",
                                 .seed = 1,
                                 .stick = OPENR_STICK,
                                 .measure_stacks = false,
                                 .robot = "ers210",
                                 .world = ""};

inline GraphOptions OnStick(const std::string& stick) {
  GraphOptions options;
  options.stick = stick;
  return options;
}

class Graph : public openr::testing::Bench {
 public:
  explicit Graph(const GraphOptions& options = {});

  Pilot& pilot() { return *pilot_; }

  // States JointMover has said, in order.
  std::vector<std::string> MoverStates() const;

  // Until JointMover accepts commands, and half a second more.  False when it does not
  // within 20 s.
  bool RunToStanding();

 private:
  Pilot* pilot_;
};

// Runs `test` in a copy of a process in which the dog stands.  What fails in it fails the
// calling test.
void WhenStanding(const GraphOptions& options, const std::function<void(Graph&)>& test,
                  openr::testing::Place place = openr::testing::Place::Here());

}  // namespace openr_host

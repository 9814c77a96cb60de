// Dogs that stand, for the rows: runs with all objects of a dog, and bodies without objects.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "openr/simulation/simulation.h"
#include "virtualrobot/body/body.h"

namespace openr_host {

class OdeBody;
class OdeReference;

// Returns the options of a run with `robots` dogs, each in a world of its own.  `body` is the kind
// of their bodies: "ode" (with physics) or "ideal".
SimulationOptions OfDogs(const std::string& stick, const std::string& body, int robots);

// Boots, runs until all dogs have stood up, and then for a second more.
void StandUp(System* system);

// A run with all objects of one or more dogs that stand.
class Dogs {
 public:
  explicit Dogs(const SimulationOptions& options);
  void Run(int64_t frames);

 private:
  Simulation simulation_;
};

// The place, the angles and the commands of a dog with physics that stands.  Bodies without objects
// are made of them.
class StandingDog {
 public:
  explicit StandingDog(const std::string& stick);
  const RobotModel& model() const { return simulation_.model(); }
  const Eigen::Isometry3d& X_WB() const { return X_WB_; }
  const std::vector<double>& angles_rad() const { return angles_rad_; }
  // The commands that hold the joints at their set points.
  const std::vector<JointCommand>& commands() const { return commands_; }

  // Makes a body with physics, alone in its world, at the place of the dog and with its angles.
  std::unique_ptr<OdeBody> MakeBody() const;

 private:
  Simulation simulation_;
  Eigen::Isometry3d X_WB_;
  std::vector<double> angles_rad_;
  std::vector<JointCommand> commands_;
};

// Bodies with physics that stand, each in a world of its own.  No objects run, and no sensors are
// read.
class BareBodies {
 public:
  BareBodies(const std::string& stick, int count);
  ~BareBodies();
  void Run(int64_t frames);

 private:
  const StandingDog dog_;
  std::vector<std::unique_ptr<OdeBody>> bodies_;
};

// The same bodies as BareBodies, but moved by ODE's own exact solver.
class OdeWorlds {
 public:
  OdeWorlds(const std::string& stick, int count);
  ~OdeWorlds();
  void Run(int64_t frames);

 private:
  const StandingDog dog_;
  std::vector<std::unique_ptr<OdeReference>> worlds_;
};

}  // namespace openr_host

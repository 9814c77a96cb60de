// Rows that compare a run of the full graph, which is all objects of a dog, with its simulated body
// alone.  One operation is one frame of 8 ms.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <vector>

#include "bench/bench.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"
#include "virtualrobot/ode/ode_reference.h"

namespace openr_host {
namespace {

// Returns a run with a dog that has stood up and stands.
std::shared_ptr<Simulation> Standing(const std::string& stick, const std::string& body) {
  SimulationOptions options;
  options.stick = stick;
  options.body = body;
  options.host_network = false;
  options.console = [](std::string_view) {};
  auto simulation = std::make_shared<Simulation>(options);
  System& system = simulation->system();
  system.Boot();
  const Object* const mover = system.FindObject(0, "JointMover");
  if (mover == nullptr ||
      !system.RunUntil([&] { return mover->state == "accepting-commands"; }, 20'000'000)) {
    throw std::runtime_error("bench: the dog does not stand up");
  }
  system.RunFor(1'000'000);
  return simulation;
}

// The simulated body of a standing dog, which holds its set points.  No objects run, and no sensors
// are read.
class BareBody {
 public:
  explicit BareBody(const std::string& stick) : simulation_(Standing(stick, "ode")) {
    for (const JointDevice& joint : simulation_->robots()[0]->devices().joints) {
      const GainWords& g = joint.gains;
      commands_.push_back({joint.target_urad * 1e-6, true, {g[0], g[1], g[2], g[3], g[4], g[5]}});
    }
  }
  void Run(int64_t frames) {
    for (; frames > 0; --frames) body().Advance(commands_);
  }
  Body& body() { return simulation_->robots()[0]->body(); }
  const RobotModel& model() const { return simulation_->robots()[0]->model(); }
  const std::vector<JointCommand>& commands() const { return commands_; }

 private:
  std::shared_ptr<Simulation> simulation_;
  std::vector<JointCommand> commands_;
};

// The same body with the same set points as BareBody, but moved by ODE's own exact solver.
class ReferenceBody {
 public:
  explicit ReferenceBody(const std::string& stick) : bare_(stick) {
    const BodyState& state = bare_.body().state();
    std::vector<double> angles_rad;
    for (const JointState& joint : state.joints) angles_rad.push_back(joint.angle_rad);
    reference_ = std::make_unique<OdeReference>(bare_.model(), World(), state.X_WB, angles_rad);
  }
  void Run(int64_t frames) {
    for (; frames > 0; --frames) reference_->Advance(bare_.commands());
  }

 private:
  BareBody bare_;
  std::unique_ptr<OdeReference> reference_;
};

}  // namespace

std::vector<Row> GraphRows(const std::string& stick) {
  const auto bare = std::make_shared<std::unique_ptr<BareBody>>();
  const auto reference = std::make_shared<std::unique_ptr<ReferenceBody>>();
  const auto graph = std::make_shared<std::shared_ptr<Simulation>>();
  const auto ideal = std::make_shared<std::shared_ptr<Simulation>>();
  const auto run_graph = [stick](const auto& slot, const char* body, int64_t frames) {
    if (*slot == nullptr) *slot = Standing(stick, body);
    (*slot)->system().RunFor(frames * kFrameUs);
  };
  const auto run_bare = [=](int64_t frames) {
    if (*bare == nullptr) *bare = std::make_unique<BareBody>(stick);
    (*bare)->Run(frames);
  };
  return {
      {"body of a standing dog; a frame",
       "ns a frame",
       250,
       {{"ODE's exact solver",
         [=](int64_t frames) {
           if (*reference == nullptr) *reference = std::make_unique<ReferenceBody>(stick);
           (*reference)->Run(frames);
         }},
        {"bare ODE body", run_bare}},
       35.0 / 185},
      {"full graph, sensors, trace hash; a frame",
       "ns a frame",
       250,
       {{"bare ODE body", run_bare},
        {"full graph on it", [=](int64_t frames) { run_graph(graph, "ode", frames); }}},
       1 / 0.90},
      {"full graph on the ideal body; a frame (3,000 x real time is 2,667 ns)",
       "ns a frame",
       2500,
       {{"full graph", [=](int64_t frames) { run_graph(ideal, "ideal", frames); }}},
       0},
  };
}

}  // namespace openr_host

// A row for pictures of the camera: the rendered world compared with the test pattern.  A picture
// has the size of the camera's sensor and is not split into the layers that objects get.
#include <memory>
#include <stdexcept>

#include "bench/bench.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// A dog that stands on the field of 2004 and looks at the ball and a goal.
class Looker {
 public:
  Looker(const std::string& stick, const std::string& images) {
    SimulationOptions options;
    options.stick = stick;
    options.world = "field-2004.json";
    options.body = "ideal";
    options.images = images;
    options.host_network = false;
    options.console = [](std::string_view) {};
    simulation_ = std::make_unique<Simulation>(options);
    System& system = simulation_->system();
    system.Boot();
    const Object* const mover = system.FindObject(0, "JointMover");
    if (mover == nullptr ||
        !system.RunUntil([&] { return mover->state == "accepting-commands"; }, 20'000'000)) {
      throw std::runtime_error("bench: the dog does not stand up");
    }
  }
  void Run(int64_t images) {
    for (; images > 0; --images) {
      const std::string problem = simulation_->robots()[0]->CopyPicture(&picture_);
      if (!problem.empty()) throw std::runtime_error("bench: " + problem);
    }
  }

 private:
  std::unique_ptr<Simulation> simulation_;
  Picture picture_;
};

}  // namespace

std::vector<Row> CameraRows(const std::string& stick) {
  const auto variant = [stick](const char* name, const char* images) {
    const auto looker = std::make_shared<std::unique_ptr<Looker>>();
    return Variant{name, [=](int64_t count) {
                     if (*looker == nullptr) *looker = std::make_unique<Looker>(stick, images);
                     (*looker)->Run(count);
                   }};
  };
  return {{"camera image, field (the goal is 1,000,000 ns)",
           "ns an image",
           250,
           {variant("test pattern", "pattern"), variant("rendered world", "world")},
           0}};
}

}  // namespace openr_host

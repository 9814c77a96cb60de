// A row for pictures of the camera: the rendered world compared with the test pattern.  A picture
// has the size of the camera's sensor and is not split into the layers that objects get.
#include <memory>
#include <stdexcept>

#include "bench/bench.h"
#include "bench/dogs.h"

namespace openr_host {
namespace {

// A dog that stands on the field of 2004 and looks at the ball and a goal.
class Looker {
 public:
  Looker(const std::string& stick, const std::string& images)
      : simulation_(OnTheField(stick, images)) {
    StandUp(&simulation_.system());
  }
  void Run(int64_t images) {
    for (; images > 0; --images) {
      const std::string problem = simulation_.robots()[0]->CopyPicture(&picture_);
      if (!problem.empty()) throw std::runtime_error("bench: " + problem);
    }
  }

 private:
  static SimulationOptions OnTheField(const std::string& stick, const std::string& images) {
    SimulationOptions options = OfDogs(stick, "ideal", 1);
    options.world = "field-2004.json";
    options.images = images;
    return options;
  }

  Simulation simulation_;
  Picture picture_;
};

}  // namespace

std::vector<Row> CameraRows(const std::string& stick) {
  const auto variant = [stick](const char* name, const char* images) {
    return Lazily<Looker>(name, [=] { return std::make_unique<Looker>(stick, images); });
  };
  Row row{"camera image, field", "ns an image", 250};
  row.variants = {variant("test pattern", "pattern"), variant("rendered world", "world")};
  return {row};
}

}  // namespace openr_host

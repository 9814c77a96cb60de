// The fuzz target robot_model: models of robots (model/*.json).
#include "virtualrobot/model/robot_model.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <stdexcept>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {
namespace {

// Notes how many rows each table of an accepted model has, and its mass in powers of two.  So the
// fuzzer keeps many accepted models, and not mostly models that are refused for different reasons.
void NoteSizes(const RobotModel& model) {
  constexpr size_t kRowsMax = 64;
  const size_t rows[] = {model.bodies.size(),   model.joints.size(),    model.sensors.size(),
                         model.paws.size(),     model.leds.size(),      model.plungers.size(),
                         model.postures.size(), model.mtn_labels.size()};
  for (size_t i = 0; i < std::size(rows); ++i)
    ReachFuzzState(i * kRowsMax + std::min(rows[i], kRowsMax - 1));
  const double grams = std::clamp(model.TotalMassKg() * 1000, 0.0, 1e9);
  ReachFuzzState(std::size(rows) * kRowsMax + std::bit_width(static_cast<uint64_t>(grams)));
}

}  // namespace

bool fuzz::robot_model(std::string_view bytes) {
  try {
    const RobotModel model = ParseRobotModel(std::string(bytes), "model.json");
    model.SensorsNamed("head");
    NoteSizes(model);
    return model.TotalMassKg() > 3;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace openr_host

// The fuzz target robot_model: models of robots (model/*.json).
#include "virtualrobot/model/robot_model.h"

#include <stdexcept>

#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {

bool fuzz::robot_model(std::string_view bytes) {
  try {
    const RobotModel model = ParseRobotModel(std::string(bytes), "model.json");
    model.SensorsNamed("head");
    return model.TotalMassKg() > 3;
  } catch (const std::runtime_error&) {
    return false;
  }
}

}  // namespace openr_host

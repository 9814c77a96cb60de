#include "openr/explore/fault_line.h"

#include <fmt/format.h>

#include "runtime/base/rng.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

constexpr const char* kSensorFaults[] = {"stuck", "noisy", "dead"};
constexpr const char* kFaults[] = {"stuck", "noisy", "dead", "jammed", "weak", "unpowered"};

}  // namespace

std::string FaultLine(const RobotModel& model, int64_t number) {
  Rng rng(static_cast<uint64_t>(number), "explore/fault line");
  const Sensor& sensor = model.sensors[rng.NextBelow(model.sensors.size())];
  const bool is_joint = sensor.joint >= 0;
  const std::string& name =
      is_joint ? model.joints[static_cast<size_t>(sensor.joint)].name : sensor.short_name;
  const std::string fault = is_joint ? kFaults[rng.NextBelow(std::size(kFaults))]
                                     : kSensorFaults[rng.NextBelow(std::size(kSensorFaults))];
  const uint64_t percent = 1 + rng.NextBelow(50);
  const std::string amount =
      fault == "weak" || fault == "noisy" ? fmt::format(" {}%", percent) : "";
  return fmt::format("break {} {}{} for {}ms", name, fault, amount, 100 * (1 + rng.NextBelow(50)));
}

}  // namespace openr_host

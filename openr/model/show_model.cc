#include "openr/model/show_model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <vector>

#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

// Formats for the rows of the tables that `openr model show` prints.  The last column has no width,
// because no other column follows it.
constexpr char kJointRow[] = "  {:<11} {:>7} {:>15} {:>15} {:>10} {:>10}  {}\n";
constexpr char kSensorRow[] = "  {:<15} {:>7} {:>23} {:<12}  {}\n";
constexpr char kPartRow[] = "  {:<27} {:<14} {}\n";

std::string DegreeRange(const Range& range) {
  return fmt::format("{:.1f} to {:.1f}", Degrees(range.min), Degrees(range.max));
}

// Returns the colour of a light.  If a light of the ERS-7's face has another colour in mode B, the
// second mode of the face lights, returns both colours, such as "red or blue".
std::string ColourOf(const Led& led) {
  if (led.colour_b.empty() || led.colour_b == led.colour) return led.colour;
  return fmt::format("{} or {}", led.colour, led.colour_b);
}

// Returns the unit of the values that OPEN-R reports for sensors of this kind; "" for plain
// numbers.
std::string OpenrUnit(SensorKind kind) {
  const std::string unit = SiUnitOf(kind);
  return unit.empty() ? "" : "10^-6 " + unit;
}

std::string JointTable(const RobotModel& model) {
  std::string text = fmt::format("joints: {}\n", model.joints.size());
  text += fmt::format(kJointRow, "name", "element", "degrees", "stops", "degrees/s", "torque N m",
                      "CPC locator");
  for (const JointModel& joint : model.joints) {
    const std::string torque =
        joint.stall_torque_nm > 0 ? fmt::format("{:.2f}", joint.stall_torque_nm) : "-";
    text +=
        fmt::format(kJointRow, joint.name, joint.sensor, DegreeRange(joint.soft_rad),
                    DegreeRange(joint.hard_rad),
                    fmt::format("{:.1f}", Degrees(joint.speed_rad_s.max)), torque, joint.locator);
  }
  return text;
}

std::string SensorTable(const RobotModel& model) {
  std::string rows;
  size_t count = 0;
  for (size_t i = 0; i < model.sensors.size(); ++i) {
    const Sensor& sensor = model.sensors[i];
    if (sensor.kind == SensorKind::kJoint) continue;
    ++count;
    const std::string range =
        sensor.has_range ? fmt::format("{} to {}", sensor.min, sensor.max) : "-";
    rows += fmt::format(kSensorRow, sensor.short_name, i, range, OpenrUnit(sensor.kind),
                        sensor.locator);
  }
  return fmt::format("sensors besides the joints: {}\n", count) +
         fmt::format(kSensorRow, "name", "element", "values", "unit", "CPC locator") + rows;
}

std::string OtherParts(const RobotModel& model) {
  std::string text = fmt::format("lights: {}\n", model.leds.size());
  for (const Led& led : model.leds)
    text += fmt::format(kPartRow, led.name, ColourOf(led), led.locator);
  text += fmt::format("ears: {}\n", model.plungers.size());
  for (const Plunger& ear : model.plungers)
    text += fmt::format(kPartRow, ear.name, fmt::format("{} ms", ear.settle_ms), ear.locator);
  text += "camera, speaker, microphone\n";
  const Camera& camera = model.camera;
  if (!camera.locator.empty()) {
    text += fmt::format(kPartRow, fmt::format("camera, {:g} images/s", camera.frames_per_s),
                        fmt::format("{}x{}", camera.width_px, camera.height_px), camera.locator);
  }
  if (!model.speaker_locator.empty())
    text += fmt::format(kPartRow, "speaker", "", model.speaker_locator);
  if (!model.microphone_locator.empty())
    text += fmt::format(kPartRow, "microphone", "", model.microphone_locator);
  return text;
}

}  // namespace

std::string ShowModel(const RobotModel& model) {
  std::vector<std::string> postures;
  for (const Posture& posture : model.postures) postures.push_back(posture.name);
  return fmt::format("{}, {:.0f} g, design {}\n\n{}\n{}\n{}postures: {}\n", model.name,
                     model.TotalMassKg() * 1000, model.design, JointTable(model),
                     SensorTable(model), OtherParts(model), fmt::join(postures, ", "));
}

}  // namespace openr_host

#include "virtualrobot/power/energy.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/hasher.h"
#include "virtualrobot/dynamics/servo.h"

namespace openr_host {
namespace {

// Share of a motor's power that the gears pass on to the joint.
constexpr double kGearShare = 0.6;
// Current, in mA, of a robot whose motors do nothing, for its computer, camera and radio.
constexpr double kElectronicsMa = 1000;
// Weight of a new frame in the mean of the robot's current.  With this weight the mean has a time
// constant of 100 ms.
constexpr double kMeanShare = 0.08;
// Rise of the body's temperature, in kelvin per watt of heat from the motors, if the heat stays the
// same for a long time; and the time constant of this rise.
constexpr double kBodyPerW_k = 2.5, kBodyTime_s = 600;
// If the battery gives r times the usual current kUsualMa for a long time, and r is above 1, the
// battery's temperature rises by kBatteryUsual_k * (r^2 - 1) kelvin.  kBatteryTime_s is the time
// constant of this rise.
constexpr double kBatteryUsual_k = 5, kBatteryTime_s = 1200;
// Further rise of the battery's temperature, in kelvin, if the battery charges for a long time.
constexpr double kChargingBattery_k = 6;

}  // namespace

Energy::Energy(const RobotModel& model) {
  const ServoSettings settings;
  for (const JointModel& joint : model.joints) {
    Motor motor;
    motor.no_load_rad_s = settings.no_load_speed_ratio * joint.speed_rad_s.max;
    motor.stall_ma = 1000 * joint.stall_torque_nm * motor.no_load_rad_s / (kGearShare * kSupplyV);
    motors_.push_back(motor);
  }
}

void Energy::NoteMotors(const BodyState& state, const Devices& devices) {
  current_ma_ = kElectronicsMa;
  for (size_t j = 0; j < motors_.size(); ++j) {
    const JointState& joint = state.joints[j];
    if (joint.drive == 0) continue;
    const JointDisturbance* const disturbance = devices.DisturbanceOf(static_cast<int>(j));
    const double strength = disturbance == nullptr ? 1 : disturbance->strength;
    const double duty = std::clamp(joint.drive / kDriveFull, -1.0, 1.0);
    // Current in the motor, as a share of its stall current; the voltage that the turning motor
    // produces reduces the current.
    const double share = strength * (duty - joint.speed_rad_s / motors_[j].no_load_rad_s);
    // Counts no negative current, because a motor that is turned by its load gives nothing back to
    // the battery.
    current_ma_ += std::max(0.0, duty * share) * motors_[j].stall_ma;
    motor_heat_w_ += share * share * motors_[j].stall_ma * kSupplyV / 1000;
  }
}

void Energy::NoteFrame(const Body& body, const Devices& devices, bool charging, bool is_on) {
  current_ma_ = is_on ? kUsualMa : 0;
  motor_heat_w_ = 0;
  if (is_on && body.IsPhysical()) NoteMotors(body.state(), devices);
  current_ma_ += extra_ma_;
  mean_ma_ += kMeanShare * (current_ma_ - mean_ma_);
  // The heat of a battery grows with the square of its current.  A battery that gives kUsualMa or
  // less does not warm up, so that a robot without load keeps its temperature exactly.
  const double usual = mean_ma_ / kUsualMa;
  double battery_k = std::max(0.0, kBatteryUsual_k * (usual * usual - 1));
  if (charging) battery_k += kChargingBattery_k;
  const auto warm = [](Temperature* temperature, double end_k, double time_s) {
    if (temperature->kept_c) return;
    temperature->above_rest_k += (end_k - temperature->above_rest_k) * (kFrame_s / time_s);
  };
  warm(&temperatures_[static_cast<size_t>(HeatedPart::kBody)], kBodyPerW_k * motor_heat_w_,
       kBodyTime_s);
  warm(&temperatures_[static_cast<size_t>(HeatedPart::kBattery)], battery_k, kBatteryTime_s);
}

int Energy::Celsius(HeatedPart part) const {
  return kRestC +
         static_cast<int>(std::lround(temperatures_[static_cast<size_t>(part)].above_rest_k));
}

void Energy::Keep(HeatedPart part, std::optional<int> celsius) {
  Temperature& temperature = temperatures_[static_cast<size_t>(part)];
  temperature.kept_c = celsius;
  if (celsius) temperature.above_rest_k = *celsius - kRestC;
}

// Adds only values that differ from the values at boot.  A robot without physics always draws the
// usual current and does not warm up, so nothing is added: its state hash is the same as without
// the simulation of energy.
void Energy::HashState(Hasher* hasher) const {
  if (mean_ma_ != kUsualMa) hasher->Add(mean_ma_);
  for (const HeatedPart part : {HeatedPart::kBody, HeatedPart::kBattery}) {
    const Temperature& temperature = temperatures_[static_cast<size_t>(part)];
    if (temperature.above_rest_k == 0 && !temperature.kept_c) continue;
    hasher->Add(part);
    hasher->Add(temperature.above_rest_k);
    hasher->Add(temperature.kept_c.has_value());
  }
  if (extra_ma_ != 0) hasher->Add(extra_ma_);
}

}  // namespace openr_host

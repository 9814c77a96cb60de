#include "virtualrobot/dynamics/servo.h"

#include <algorithm>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

// Returns the exact factor gain * 2^(shift - 16).  A shift above 32 counts as 32, because with this
// shift a gain demands the full drive already.
double Effective(uint16_t gain, uint16_t shift) {
  double value = gain;
  for (int s = shift; s < 16; ++s) value *= 0.5;
  for (int s = 16; s < std::min<int>(shift, 32); ++s) value *= 2;
  return value;
}

}  // namespace

Servo::Servo(const JointModel& joint, const ServoSettings& settings)
    : counts_per_rad_(kAdSteps / (joint.hard_rad.max - joint.hard_rad.min)),
      stall_nm_(joint.stall_torque_nm),
      motor_slope_nm_s_(joint.stall_torque_nm /
                        (settings.no_load_speed_ratio * joint.speed_rad_s.max)),
      hard_rad_(joint.hard_rad),
      settings_(settings) {
  ASSERT(joint.stall_torque_nm > 0, "{}: {} N m", joint.name, joint.stall_torque_nm);
  ASSERT(joint.hard_rad.max > joint.hard_rad.min, "{}: no room between the stops", joint.name);
  ASSERT(joint.speed_rad_s.max > 0, "{}: no planned speed", joint.name);
}

void Servo::BeginFrame(const JointCommand& command, double angle_rad) {
  disturbance_ = command.disturbance;
  if (!command.enabled) {
    enabled_ = false;
    integral_ = 0;
    return;
  }
  // The D part acts on the change of the set point.  A servo that was off has no earlier set point,
  // so the change counts as 0.
  const double last_rad = enabled_ ? target_rad_ : command.target_rad;
  enabled_ = true;
  target_rad_ = command.target_rad;
  target_speed_rad_s_ = (target_rad_ - last_rad) / kFrame_s;
  // Converts gains only when they change, because conversions take time.
  if (!(gains_ == command.gains)) {
    gains_ = command.gains;
    p_ = Effective(gains_.p, gains_.p_shift) * counts_per_rad_;
    i_ = Effective(gains_.i, gains_.i_shift) * counts_per_rad_;
    d_ = Effective(gains_.d, gains_.d_shift) * counts_per_rad_ * kFrame_s;
  }
  integral_ =
      std::clamp(integral_ + i_ * (target_rad_ - Measured(angle_rad)), -kDriveFull, kDriveFull);
}

double Servo::Drive(double angle_rad, double speed_rad_s) const {
  if (!enabled_) return 0;
  const double seen_rad_s = is_blind() ? 0 : speed_rad_s;
  return p_ * (target_rad_ - Measured(angle_rad)) + integral_ +
         d_ * (target_speed_rad_s_ - seen_rad_s);
}

TorqueLine Servo::Step(double angle_rad, double speed_rad_s, double step_s) const {
  const bool is_driven = enabled_ && strength() > 0;
  TorqueLine line = is_driven ? MotorLine(angle_rad, speed_rad_s, step_s) : LimpLine(speed_rad_s);
  const double beyond_rad = angle_rad - std::clamp(angle_rad, hard_rad_.min, hard_rad_.max);
  if (beyond_rad != 0) {
    const double stiffness_nm = settings_.stop_stiffness_per_rad * stall_nm_;
    line.zero_speed_nm -= stiffness_nm * beyond_rad;
    line.slope_nm_s += stiffness_nm * step_s + settings_.stop_damping_s_per_rad * stall_nm_;
  }
  if (disturbance_ != nullptr) AddDisturbance(angle_rad, step_s, &line);
  return line;
}

TorqueLine Servo::MotorLine(double angle_rad, double speed_rad_s, double step_s) const {
  const double stall_nm = strength() * stall_nm_;
  const double slope_nm_s = strength() * motor_slope_nm_s_;
  const double drive = Drive(angle_rad, speed_rad_s);
  if (drive > kDriveFull) return {stall_nm, slope_nm_s};
  if (drive < -kDriveFull) return {-stall_nm, slope_nm_s};
  // Computes the P and D parts of the drive for the joint's angle and speed at the end of the step,
  // not at its beginning.  So high gains on a light part stay stable with any length of the step.
  // The angle at the end is angle_rad + step_s * v, where v is the speed at the end.
  const double nm_per_count = stall_nm / kDriveFull;
  if (is_blind()) return {nm_per_count * drive, slope_nm_s};
  return {nm_per_count * (drive + d_ * speed_rad_s),
          slope_nm_s + nm_per_count * (d_ + p_ * step_s)};
}

// Adds the torque of a person's hand that turns the joint, and the torque that holds a jammed
// joint.  Both torques act like springs and are computed for the angle at the end of the step.
void Servo::AddDisturbance(double angle_rad, double step_s, TorqueLine* line) const {
  if (disturbance_->hand_rad) {
    const double stiffness_nm = settings_.hand_stiffness_nm_per_rad;
    line->zero_speed_nm += std::clamp(stiffness_nm * (*disturbance_->hand_rad - angle_rad),
                                      -settings_.hand_torque_nm, settings_.hand_torque_nm);
    line->slope_nm_s += stiffness_nm * step_s;
  }
  if (disturbance_->jammed_rad) {
    const double stiffness_nm = settings_.jam_stiffness_per_rad * stall_nm_;
    line->zero_speed_nm += stiffness_nm * (*disturbance_->jammed_rad - angle_rad);
    line->slope_nm_s += stiffness_nm * step_s;
  }
}

// Returns the torque of a limp joint: dry friction.  Below the speed limp_creep_rad_s the friction
// is viscous, because a force that jumps at speed 0 would make the joint tremble.
TorqueLine Servo::LimpLine(double speed_rad_s) const {
  const double speed =
      std::max(speed_rad_s < 0 ? -speed_rad_s : speed_rad_s, settings_.limp_creep_rad_s);
  return {0, settings_.limp_friction * stall_nm_ / speed};
}

void Servo::HashState(Hasher* hasher) const {
  hasher->Add(enabled_);
  hasher->Add(target_rad_);
  hasher->Add(target_speed_rad_s_);
  hasher->Add(integral_);
  for (const uint16_t word :
       {gains_.p, gains_.i, gains_.d, gains_.p_shift, gains_.i_shift, gains_.d_shift}) {
    hasher->Add(word);
  }
}

}  // namespace openr_host

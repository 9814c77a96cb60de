// The position servo and the motor of one joint, without the mechanics that they move.
//
// The controller works on A/D counts, as the robot's does, and asks for a drive in PWM counts.  The
// motor turns the drive into torque along a straight torque-speed line.  A step returns that line,
// and physics (ode/) solves it together with the body, because an explicit torque with so much
// damping would make the light links unstable.
//
// docs/body.md gives the source or the reason of every number here.
#pragma once

#include "virtualrobot/body.h"

namespace openr_host {

inline constexpr double kDriveFull = 255;  // PWM counts that reach the motor (BBS 1735)
inline constexpr double kAdSteps = 1023;   // 10-bit A/D over the mechanical range (inferred)

struct ServoSettings {
  double no_load_speed_ratio = 2.0;     // no-load speed over the model's largest planned speed
  double limp_friction = 0.02;          // dry friction without drive, over the stall torque
  double limp_creep_rad_s = 0.02;       // below this speed dry friction acts as a viscous one
  double stop_stiffness_per_rad = 100;  // mechanical stop: torque per rad, over the stall torque
  double stop_damping_s_per_rad = 0.5;  // damping of the stop, over the stall torque
};

// Torque on the joint as a function of its speed v at the end of the step:
// zero_speed_nm - slope_nm_s * v.
struct TorqueLine {
  double zero_speed_nm = 0;
  double slope_nm_s = 0;  // N m s / rad, > 0
};

class Servo {
 public:
  // REQUIRES: the joint has torque, room between its stops and a planned speed (each > 0).
  Servo(const JointModel& joint, const ServoSettings& settings);

  // Takes the command of the next frame.  Called once per frame, before the steps of the frame.
  void BeginFrame(const JointCommand& command, double angle_rad);

  // Torque of motor, friction and stops on the joint during the next step of `step_s` seconds.
  TorqueLine Step(double angle_rad, double speed_rad_s, double step_s) const;

  // Drive asked for at the given state, in PWM counts, not clamped; 0 when limp.
  double Drive(double angle_rad, double speed_rad_s) const;

  void HashState(Hasher* hasher) const;

 private:
  TorqueLine MotorLine(double angle_rad, double speed_rad_s, double step_s) const;
  TorqueLine LimpLine(double speed_rad_s) const;

  // Constants of the joint.
  double counts_per_rad_;
  double stall_nm_;
  double motor_slope_nm_s_;  // stall torque over no-load speed
  Range hard_rad_;
  ServoSettings settings_;

  // The command of the running frame, and the integral over all frames.
  bool enabled_ = false;
  PidGains gains_;
  double target_rad_ = 0;
  double target_speed_rad_s_ = 0;
  double p_ = 0;         // PWM counts per rad
  double i_ = 0;         // PWM counts per rad and frame, which is the servo's tick
  double d_ = 0;         // PWM counts per rad/s
  double integral_ = 0;  // PWM counts
};

}  // namespace openr_host

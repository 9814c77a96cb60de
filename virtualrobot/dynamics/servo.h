// The position servo and the motor of one joint, without the mechanics that they move.
//
// The servo works like the robot's own: its control law reads counts of the A/D converter and
// demands a drive in PWM counts.  The motor turns the drive into torque along a straight
// torque-speed line.  The slope of this line damps the joint strongly.  If a step used the torque
// at the speed before the step, the light parts of the robot would become unstable.  So Step()
// returns the torque as a function of the speed, and JointTree finds the torque together with the
// motion of the body.
//
// A joint is limp when its servo is off.  docs/body.md gives the source or the reason of every
// number here.
#pragma once

#include "virtualrobot/body/body.h"

namespace openr_host {

inline constexpr double kDriveFull = 255;  // maximum drive, in PWM counts (BBS 1735)
inline constexpr double kAdSteps = 1023;   // A/D counts between the two stops of a joint (inferred)

struct ServoSettings {
  double no_load_speed_ratio = 2.0;  // no-load speed, divided by the joint's highest planned speed
  double limp_friction = 0.01;       // dry friction of a limp joint, divided by the stall torque
  double limp_creep_rad_s = 0.02;    // below this speed, dry friction acts like viscous friction
  double stop_stiffness_per_rad = 100;  // stiffness of a joint's stop, divided by the stall torque
  double stop_damping_s_per_rad = 0.5;  // damping of a joint's stop, divided by the stall torque
  double jam_stiffness_per_rad = 2000;  // stiffness of a jammed joint, divided by the stall torque
  double hand_torque_nm = 2;            // highest torque of a hand that turns a joint
  double hand_stiffness_nm_per_rad = 50;
};

// The torque on the joint as a function of its speed v at the end of the step: zero_speed_nm -
// slope_nm_s * v.
struct TorqueLine {
  double zero_speed_nm = 0;
  double slope_nm_s = 0;  // slope of the torque line, in N m s / rad; > 0
};

class Servo {
 public:
  // Makes the servo of `joint`.  REQUIRES: the joint's stall torque, the distance between its stops
  // and its highest planned speed are > 0.
  Servo(const JointModel& joint, const ServoSettings& settings);

  // Sets the command for the next frame of 8 ms; `angle_rad` is the present angle of the joint.
  // Called once per frame, before the steps of the frame.  `command.disturbance` must exist until
  // the last call of Step() and Drive() for this frame.
  void BeginFrame(const JointCommand& command, double angle_rad);

  // Returns the torque of motor, friction and stops on the joint, as a function of the speed,
  // during the next step of `step_s` seconds.
  TorqueLine Step(double angle_rad, double speed_rad_s, double step_s) const;

  // Returns the drive, in PWM counts, that the control law demands at this angle and speed, before
  // it is limited to +-kDriveFull; 0 when the joint is limp.
  double Drive(double angle_rad, double speed_rad_s) const;

  void HashState(Hasher* hasher) const;

 private:
  TorqueLine MotorLine(double angle_rad, double speed_rad_s, double step_s) const;
  TorqueLine LimpLine(double speed_rad_s) const;
  void AddDisturbance(double angle_rad, double step_s, TorqueLine* line) const;
  double strength() const { return disturbance_ == nullptr ? 1 : disturbance_->strength; }
  // Returns whether the servo does not see how its joint moves, because the joint's sensor is stuck
  // or dead.
  bool is_blind() const { return disturbance_ != nullptr && disturbance_->sensed_rad.has_value(); }
  double Measured(double angle_rad) const {
    return disturbance_ == nullptr ? angle_rad : disturbance_->Measured(angle_rad);
  }

  // The next members do not change after the constructor.  Their values come from the joint and the
  // settings.
  double counts_per_rad_;
  double stall_nm_;
  double motor_slope_nm_s_;  // stall torque divided by no-load speed
  Range hard_rad_;
  ServoSettings settings_;

  // The next members hold the command of the present frame and what follows from the command.  Only
  // integral_, the integral of the control law, goes on from frame to frame.
  bool enabled_ = false;
  PidGains gains_;
  double target_rad_ = 0;
  double target_speed_rad_s_ = 0;
  double p_ = 0;  // factor of the P part, in PWM counts per rad
  // Factor of the I part of the servo's control law, in PWM counts per rad and frame, because the
  // servo integrates once a frame.
  double i_ = 0;
  double d_ = 0;         // factor of the D part, in PWM counts per rad/s
  double integral_ = 0;  // integral of the control law, in PWM counts
  const JointDisturbance* disturbance_ = nullptr;
};

}  // namespace openr_host

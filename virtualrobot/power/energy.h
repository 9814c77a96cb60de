// The current that a robot draws from its battery, and the heat of its motors and its battery.
//
// Each motor is a direct-current motor with pulse-width modulation: its voltage is on for the share
// drive / 255 of the time.  The current of a motor at rest is its stall current times this share,
// and the battery gives this current only for this share of the time.  So on average the battery
// gives the stall current times the square of the share.  Body and battery warm up with the power
// that is lost in motors and battery, and cool down to 30 degrees Celsius, each with its own time
// constant. docs/calibration.md has the reason of every number.  A body without physics computes no
// drives, so such a robot draws kUsualMa and stays at 30 degrees.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "virtualrobot/body/body.h"
#include "virtualrobot/devices/devices.h"

namespace openr_host {

class Hasher;

// The parts of the robot whose temperature is simulated.
enum class HeatedPart { kBody, kBattery };

class Energy {
 public:
  static constexpr int kRestC = 30;      // temperature of a robot that was not in use
  static constexpr int kUsualMa = 1300;  // current of a robot in use: empties the battery in 90 min
  static constexpr double kSupplyV = 7.4;

  explicit Energy(const RobotModel& model);

  // Computes current and heat of a frame of 8 ms, after the body has moved.  A robot that is off
  // draws no current.
  void NoteFrame(const Body& body, const Devices& devices, bool charging, bool is_on);

  // Returns the current that the robot drew from the battery in the newest frame, in mA.
  int current_ma() const { return static_cast<int>(current_ma_); }
  // Returns the mean over about 100 ms of the current that the robot draws, in mA.
  double mean_ma() const { return mean_ma_; }
  // Returns the power that the motors turned into heat in the newest frame, in W.
  double motor_heat_w() const { return motor_heat_w_; }
  // Returns a temperature as its sensor reads it: whole degrees Celsius.
  int Celsius(HeatedPart part) const;

  // Keeps `part` at the temperature `celsius`.  If `celsius` is nullopt, lets the part warm up
  // and cool down again, from its present temperature.
  void Keep(HeatedPart part, std::optional<int> celsius);
  // Sets an additional current that the battery gives, beside the current of the robot itself.  The
  // fault "draw" (faults.h) uses this function.
  void SetExtraMa(int ma) { extra_ma_ = ma; }

  void HashState(Hasher* hasher) const;

 private:
  struct Motor {
    double stall_ma = 0;       // current at full drive and speed 0
    double no_load_rad_s = 0;  // speed at full drive without load
  };
  struct Temperature {
    double above_rest_k = 0;
    std::optional<int> kept_c;
  };

  void NoteMotors(const BodyState& state, const Devices& devices);

  std::vector<Motor> motors_;  // an element for each joint
  double current_ma_ = kUsualMa, mean_ma_ = kUsualMa, motor_heat_w_ = 0;
  int extra_ma_ = 0;
  std::array<Temperature, 2> temperatures_;  // an element for each HeatedPart: body, battery
};

}  // namespace openr_host

// Power: the motor power, battery, clock and pause button of one robot.  Sends messages about
// changes to the objects that observe the robot's power status.
#pragma once

#include <OPENR/OPENRAPI.h>

#include <cstdint>
#include <vector>

#include "virtualrobot/power/battery.h"

namespace openr_host {

class Hasher;
class System;

class Power {
 public:
  explicit Power(System* system, Battery battery = {});

  bool motor_power() const { return motor_power_; }
  void SetMotorPower(bool on);

  bool pause() const { return pause_; }

  // Presses the pause button.  Sets the status bit of the button and cuts motor power, as the
  // robot's hardware does (field-notes.md, 7.12).
  void PressPause();

  // Sets the remaining capacity, 0 to 100 percent of a full battery.  A battery that drains goes on
  // draining from this capacity.
  void SetCapacity(int percent);

  // Puts the robot on its charging station, or takes it away.  On the station the battery gains 1 %
  // every kChargeUs.
  void SetCharging(bool on);
  bool charging() const { return charging_; }

  OPowerStatus Status() const;

  bool is_battery_low() const;  // whether the status bit orsbBATTERY_CAPACITY_LOW is set
  int remaining_percent() const { return RemainingCapacity(); }

  // Makes Power send a message to `entry` at each change of the power status that `filter` asks
  // for.  Replaces an earlier filter of `entry`.
  void Observe(const OPowerStatus& filter, const OServiceEntry& entry);
  // Ends the messages to `entry` about the power status.  Returns false when `entry` does not
  // observe the power status.
  bool Unobserve(const OServiceEntry& entry);

  // The load of the battery in a frame of 8 ms.
  struct Load {
    // Current that the robot draws from the battery, without the charging current.
    int current_ma = 1300;
    int battery_c = 30;  // temperature of the battery
    bool over_current = false, over_temperature = false;
    bool operator==(const Load&) const = default;
  };
  // Sets the load of a frame of 8 ms.  Counts the charge that this load draws from the battery,
  // unless the robot is on its charging station.  Called once a frame.
  void SetLoad(const Load& load);

  // Sends messages about values that change without a call of a setter, such as the battery's
  // capacity, which falls with time.  Called once a frame (8 ms).
  void Update();

  // Switches the robot off; its boot timer boots it later.  Removes all observers of the power
  // status.  Battery, clock and volume switch stay as they are.
  void SwitchOff();

  void SetTimeDifference(sbyte hours);
  sbyte time_difference() const { return time_difference_; }
  void SetVolume(byte volume);
  byte volume() const { return volume_; }
  void SetClock(int64_t seconds_since_2000);
  int64_t Clock() const;

  OBootCondition boot_condition{obcbPAUSE_SW};  // the reason why the robot was switched on
  OBootCondition next_boot;  // the condition for the next boot, stored by Shutdown()

  void HashState(Hasher* hasher) const;

 private:
  struct Watcher {
    OPowerStatus filter;
    OServiceEntry entry;
  };

  word RemainingCapacity() const;
  void NotifyChange();

  System* const system_;
  // Time in which the battery gains 1 % on the charging station: a full charge takes two hours.
  // The number is our choice.
  static constexpr int64_t kChargeUs = 72'000'000;

  Battery battery_;  // the battery as it was at the time capacity_since_us_
  int64_t capacity_since_us_ = 0;
  // Charge drawn from the battery since the capacity was last set (capacity_since_us_), minus the
  // charge that the usual current draws in this time.
  int64_t extra_ma_us_ = 0;
  Load load_;
  bool charging_ = false;
  bool motor_power_ = false;
  bool pause_ = false;
  sbyte time_difference_ = 0;
  byte volume_ = 3;
  int64_t clock_offset_s_ = 0;  // time of the robot's clock minus virtual time, in s
  OPowerStatus last_;           // the newest status of which the observers were notified
  std::vector<Watcher> watchers_;
};

}  // namespace openr_host

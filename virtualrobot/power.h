// Power, battery, clock and pause button of one robot, and who watches them.
#pragma once

#include <OPENR/OPENRAPI.h>

#include <cstdint>
#include <vector>

#include "virtualrobot/battery.h"

namespace openr_host {

class Hasher;
class System;

class Power {
 public:
  explicit Power(System* system, Battery battery = {});

  bool motor_power() const { return motor_power_; }
  void SetMotorPower(bool on);

  bool pause() const { return pause_; }

  // The pause button: sets the bit; the hardware cuts motor power (field notes, 7.12).
  void PressPause();

  OPowerStatus Status() const;

  bool is_battery_low() const;  // as orsbBATTERY_CAPACITY_LOW says
  int remaining_percent() const { return RemainingCapacity(); }

  void Observe(const OPowerStatus& filter, const OServiceEntry& entry);
  // False when nobody observes with that entry.
  bool Unobserve(const OServiceEntry& entry);

  // Once a frame: what changes with time.
  void Update();

  void SetTimeDifference(sbyte hours);
  sbyte time_difference() const { return time_difference_; }
  void SetVolume(byte volume);
  byte volume() const { return volume_; }
  void SetClock(int64_t seconds_since_2000);
  int64_t Clock() const;

  OBootCondition boot_condition{obcbPAUSE_SW};  // why the robot runs
  OBootCondition next_boot;                     // stored by Shutdown()

  void HashState(Hasher* hasher) const;

 private:
  struct Watcher {
    OPowerStatus filter;
    OServiceEntry entry;
  };

  word RemainingCapacity() const;
  void NotifyChange();

  System* const system_;
  const Battery battery_;
  bool motor_power_ = false;
  bool pause_ = false;
  sbyte time_difference_ = 0;
  byte volume_ = 3;
  int64_t clock_offset_s_ = 0;  // RTC minus virtual time
  OPowerStatus last_;           // as the watchers know it
  std::vector<Watcher> watchers_;
};

}  // namespace openr_host

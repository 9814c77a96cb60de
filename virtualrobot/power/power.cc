#include "virtualrobot/power/power.h"

#include <OPENR/OPENRMessages.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"
#include "virtualrobot/power/energy.h"

namespace openr_host {
namespace {

constexpr int kZeroCelsius = 2731;       // 0 degrees Celsius in units of 0.1 K
constexpr word kFullCapacityMah = 2000;  // capacity of a full battery; our choice
constexpr word kVoltageMv = 7400;        // voltage of two lithium cells; our choice
constexpr int kChargingMa = 1000;        // charging current on the charging station; our choice
constexpr int kCurrentMaxMa = 32767;     // largest current that OPowerStatus can hold

// Returns whether the observer that has given `filter` asks to be notified of the change from
// `before` to `now`.
bool Asks(const OPowerStatus& filter, const OPowerStatus& before, const OPowerStatus& now) {
  if (((before.robotStatus ^ now.robotStatus) & filter.robotStatus) != 0) return true;
  if (((before.batteryStatus ^ now.batteryStatus) & filter.batteryStatus) != 0) return true;
  const auto becomes = [](auto wanted, auto every, auto never, auto old_value, auto new_value) {
    return old_value != new_value && wanted != never && (wanted == every || wanted == new_value);
  };
  return becomes(filter.remainingCapacity, opsoREMAINING_CAPACITY_NOTIFY_EVERY_CHANGE,
                 opsoREMAINING_CAPACITY_NOT_NOTIFY, before.remainingCapacity,
                 now.remainingCapacity) ||
         becomes(filter.temperature, opsoTEMPERATURE_NOTIFY_EVERY_CHANGE,
                 opsoTEMPERATURE_NOT_NOTIFY, before.temperature, now.temperature) ||
         becomes(filter.timeDif, opsoTIME_DIF_NOTIFY_EVERY_CHANGE, opsoTIME_DIF_NOT_NOTIFY,
                 before.timeDif, now.timeDif) ||
         becomes(filter.volume, opsoVOLUME_NOTIFY_EVERY_CHANGE, opsoVOLUME_NOT_NOTIFY,
                 before.volume, now.volume);
}

}  // namespace

Power::Power(System* system, Battery battery) : system_(system), battery_(battery) {
  last_ = Status();
}

word Power::RemainingCapacity() const {
  const int64_t time_us = system_->now_us() - capacity_since_us_;
  if (!charging_) {
    // Converts the charge that was drawn from the battery to the time in which the usual current
    // draws this charge, because PercentAt() computes the capacity from this time.
    const int64_t drained_us = time_us + extra_ma_us_ / Energy::kUsualMa;
    return static_cast<word>(battery_.PercentAt(std::max<int64_t>(drained_us, 0)));
  }
  return static_cast<word>(std::min<int64_t>(battery_.percent + time_us / kChargeUs, 100));
}

bool Power::is_battery_low() const { return RemainingCapacity() < kLowCapacityPercent; }

OPowerStatus Power::Status() const {
  const word remaining = RemainingCapacity();
  longword robot = orsbBATTERY_CONNECTED | orsbOPEN_R_POWER_GOOD | orsbPLUNGER;
  if (motor_power_) robot |= orsbMOTOR_POWER;
  if (pause_) robot |= orsbPAUSE;
  if (is_battery_low()) robot |= orsbBATTERY_CAPACITY_LOW;
  word battery = obsbINITIALIZED;
  if (charging_) {
    const bool is_full = remaining == 100;
    robot |= orsbSTATION_CONNECTED | (is_full ? orsbBATTERY_CAPACITY_FULL : orsbBATTERY_CHARGING);
    if (is_full) battery |= obsbFULLY_CHARGED;
  } else {
    battery |= obsbDISCHARGING;
  }
  if (load_.over_current) robot |= orsbBATTERY_OVER_CURRENT;
  if (load_.over_temperature) {
    robot |= charging_ ? orsbBATTERY_OVER_TEMP_CHARGING : orsbBATTERY_OVER_TEMP_DISCHARGING;
    battery |= obsbOVER_TEMP_ALARM;
  }
  const auto temperature = static_cast<word>(kZeroCelsius + 10 * load_.battery_c);
  // The current is negative while the battery discharges.  No document gives the sign; it is
  // inferred.
  const int current_ma = charging_ ? kChargingMa : -std::min(load_.current_ma, kCurrentMaxMa);
  return OPowerStatus(robot, battery, remaining, temperature, kFullCapacityMah, kVoltageMv,
                      static_cast<sword>(current_ma), time_difference_, volume_);
}

void Power::SetMotorPower(bool on) {
  // Does not switch motor power on again if the pause button has cut it, because on the robot motor
  // power then stays off.
  if (pause_ && on) return;
  motor_power_ = on;
  NotifyChange();
}

void Power::PressPause() {
  pause_ = true;
  motor_power_ = false;
  NotifyChange();
}

void Power::SetCapacity(int percent) {
  ASSERT(percent >= 0 && percent <= 100, "{} %", percent);
  battery_.percent = percent;
  capacity_since_us_ = system_->now_us();
  extra_ma_us_ = 0;
  NotifyChange();
}

void Power::SetCharging(bool on) {
  // Stores the present capacity together with the present time, because from now on the capacity
  // changes at another speed, and RemainingCapacity() counts from the stored time.
  SetCapacity(RemainingCapacity());
  charging_ = on;
  NotifyChange();
}

void Power::SwitchOff() {
  watchers_.clear();
  motor_power_ = pause_ = false;
  boot_condition = OBootCondition(obcbBOOT_TIMER);
  next_boot = OBootCondition();
  last_ = Status();
}

void Power::SetTimeDifference(sbyte hours) {
  time_difference_ = hours;
  NotifyChange();
}

void Power::SetVolume(byte volume) {
  volume_ = volume;
  NotifyChange();
}

void Power::Observe(const OPowerStatus& filter, const OServiceEntry& entry) {
  Unobserve(entry);
  watchers_.push_back({filter, entry});
}

bool Power::Unobserve(const OServiceEntry& entry) {
  return std::erase_if(watchers_, [&](const Watcher& watcher) { return watcher.entry == entry; }) >
         0;
}

void Power::SetLoad(const Load& load) {
  load_ = load;
  if (!charging_) extra_ma_us_ += int64_t{load.current_ma - Energy::kUsualMa} * system_->frame_us();
}

void Power::Update() {
  const OPowerStatus now = Status();
  if (now.remainingCapacity != last_.remainingCapacity || now.temperature != last_.temperature ||
      now.robotStatus != last_.robotStatus || now.batteryStatus != last_.batteryStatus)
    NotifyChange();
}

void Power::NotifyChange() {
  const OPowerStatus now = Status();
  const OPowerStatus before = last_;
  last_ = now;
  for (const Watcher& watcher : watchers_) {
    if (!Asks(watcher.filter, before, now)) continue;
    OwnedMessage message =
        system_->NewMessage(ObjectIdOf(watcher.entry.GetOID()), watcher.entry.GetSelector());
    // Clears all bytes, also the padding, because the hash of the message includes the padding.
    std::memset(message->payload, 0, sizeof(OPowerStatusMessage));
    auto& payload = *reinterpret_cast<OPowerStatusMessage*>(message->payload);
    payload.msgType = omsgPOWER_STATUS;
    payload.powerStatus.robotStatus = now.robotStatus;
    payload.powerStatus.batteryStatus = now.batteryStatus;
    payload.powerStatus.remainingCapacity = now.remainingCapacity;
    payload.powerStatus.temperature = now.temperature;
    payload.powerStatus.fullyChargedCapacity = now.fullyChargedCapacity;
    payload.powerStatus.voltage = now.voltage;
    payload.powerStatus.current = now.current;
    payload.powerStatus.timeDif = now.timeDif;
    payload.powerStatus.volume = now.volume;
    message->size = sizeof(OPowerStatusMessage);
    system_->Post(std::move(message));
  }
}

void Power::SetClock(int64_t seconds_since_2000) {
  clock_offset_s_ = seconds_since_2000 - system_->now_us() / 1'000'000;
}

int64_t Power::Clock() const { return clock_offset_s_ + system_->now_us() / 1'000'000; }

void Power::HashState(Hasher* hasher) const {
  hasher->Add(motor_power_);
  hasher->Add(pause_);
  hasher->Add(time_difference_);
  hasher->Add(volume_);
  hasher->Add(clock_offset_s_);
  hasher->Add(static_cast<uint64_t>(watchers_.size()));
  if (extra_ma_us_ != 0) hasher->Add(extra_ma_us_);
  // Leaves the battery out of the hash until an input changes the battery.  Until then, the
  // capacity follows from the capacity at boot, the virtual time and extra_ma_us_.  Of these,
  // extra_ma_us_ is in the hash already.
  if (capacity_since_us_ == 0 && !charging_) return;
  hasher->Add(battery_.percent);
  hasher->Add(capacity_since_us_);
  hasher->Add(charging_);
}

}  // namespace openr_host

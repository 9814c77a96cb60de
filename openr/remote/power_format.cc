#include "openr/remote/power_format.h"

#include <nlohmann/json.hpp>

namespace openr::remote {
namespace {

// Bits of the robot status, from docs/remote-control.md.
constexpr uint32_t kMotorPower = 0x2;
constexpr uint32_t kStationConnected = 0x10;

}  // namespace

bool HasMotorPower(const RcPower& power) { return (power.robotStatus & kMotorPower) != 0; }

bool IsOnStation(const RcPower& power) { return (power.robotStatus & kStationConnected) != 0; }

nlohmann::ordered_json PowerJson(const RcPower& power) {
  return {{"motor_power", HasMotorPower(power)},       {"on_station", IsOnStation(power)},
          {"robot_status", power.robotStatus},         {"battery_status", power.batteryStatus},
          {"capacity_percent", power.capacity},        {"full_capacity_mah", power.fullCapacity},
          {"voltage_v", power.voltage / 1000.0},       {"current_a", power.current / 1000.0},
          {"temperature_c", power.temperature / 100.0}};
}

}  // namespace openr::remote

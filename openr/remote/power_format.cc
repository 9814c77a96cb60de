#include "openr/remote/power_format.h"

#include <OPENR/OPower.h>

#include <nlohmann/json.hpp>

namespace openr_host {

nlohmann::ordered_json PowerJson(const RcPower& power) {
  return {{"motor_power", (power.robotStatus & orsbMOTOR_POWER) != 0},
          {"on_station", (power.robotStatus & orsbSTATION_CONNECTED) != 0},
          {"robot_status", power.robotStatus},
          {"battery_status", power.batteryStatus},
          {"capacity_percent", power.capacity},
          {"full_capacity_mah", power.fullCapacity},
          {"voltage_v", power.voltage / 1000.0},
          {"current_a", power.current / 1000.0},
          {"temperature_c", power.temperature / 100.0}};
}

}  // namespace openr_host

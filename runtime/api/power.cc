// The functions of OPowerStatus (the state of robot and battery) and of OBootCondition (what makes
// the robot boot again after OPENR::Shutdown()).
#include <OPENR/OPower.h>
#include <OPENR/OSyslog.h>
#include <fmt/format.h>

#include "runtime/api/power_text.h"

namespace {

// A bit of OPowerStatus::robotStatus or batteryStatus, and the name of the bit's constant for the
// text of PowerDetails().
struct NamedBit {
  longword bit;
  const char* name;
};

constexpr NamedBit kRobotBits[] = {
    {orsbPAUSE, "orsbPAUSE"},
    {orsbMOTOR_POWER, "orsbMOTOR_POWER"},
    {orsbVIBRATION_DETECT, "orsbVIBRATION_DETECT"},
    {orsbEX_PORT_CONNECTED, "orsbEX_PORT_CONNECTED"},
    {orsbSTATION_CONNECTED, "orsbSTATION_CONNECTED"},
    {orsbEX_POWER_CONNECTED, "orsbEX_POWER_CONNECTED"},
    {orsbBATTERY_CONNECTED, "orsbBATTERY_CONNECTED"},
    {orsbBATTERY_CHARGING, "orsbBATTERY_CHARGING"},
    {orsbBATTERY_CAPACITY_FULL, "orsbBATTERY_CAPACITY_FULL"},
    {orsbBATTERY_CAPACITY_LOW, "orsbBATTERY_CAPACITY_LOW"},
    {orsbBATTERY_OVER_CURRENT, "orsbBATTERY_OVER_CURRENT"},
    {orsbBATTERY_OVER_TEMP_DISCHARGING, "orsbBATTERY_OVER_TEMP_DISCHARGING"},
    {orsbBATTERY_OVER_TEMP_CHARGING, "orsbBATTERY_OVER_TEMP_CHARGING"},
    {orsbBATTERY_ERROR_OF_CHARGING, "orsbBATTERY_ERROR_OF_CHARGING"},
    {orsbERROR_OF_PLUNGER, "orsbERROR_OF_PLUNGER"},
    {orsbOPEN_R_POWER_GOOD, "orsbOPEN_R_POWER_GOOD"},
    {orsbERROR_OF_FAN, "orsbERROR_OF_FAN"},
    {orsbDATA_STREAM_FROM_STATION, "orsbDATA_STREAM_FROM_STATION"},
    {orsbREGISTER_UPDATED_BY_STATION, "orsbREGISTER_UPDATED_BY_STATION"},
    {orsbRTC_ERROR, "orsbRTC_ERROR"},
    {orsbRTC_OVERFLOW, "orsbRTC_OVERFLOW"},
    {orsbRTC_RESET, "orsbRTC_RESET"},
    {orsbRTC_SET, "orsbRTC_SET"},
    {orsbSPECIAL_MODE, "orsbSPECIAL_MODE"},
    {orsbBMN_DEBUG_MODE, "orsbBMN_DEBUG_MODE"},
    {orsbCHARGER_STATUS, "orsbCHARGER_STATUS"},
    {orsbPLUNGER, "orsbPLUNGER"},
    {orsbSUSPENDED, "orsbSUSPENDED"},
    {orsbSPECIAL_DATA_READ_REQ, "orsbSPECIAL_DATA_READ_REQ"},
};

constexpr NamedBit kBatteryBits[] = {
    {obsbFULLY_DISCHARGED, "obsbFULLY_DISCHARGED"},
    {obsbFULLY_CHARGED, "obsbFULLY_CHARGED"},
    {obsbDISCHARGING, "obsbDISCHARGING"},
    {obsbINITIALIZED, "obsbINITIALIZED"},
    {obsbREMAINING_TIME_ALARM, "obsbREMAINING_TIME_ALARM"},
    {obsbREMAINING_CAPACITY_ALARM, "obsbREMAINING_CAPACITY_ALARM"},
    {obsbRESERVED0, "obsbRESERVED0"},
    {obsbTERMINATED_DISCHARGING_ALARM, "obsbTERMINATED_DISCHARGING_ALARM"},
    {obsbOVER_TEMP_ALARM, "obsbOVER_TEMP_ALARM"},
    {obsbRESERVED1, "obsbRESERVED1"},
    {obsbTERMINATED_CHARGING_ALARM, "obsbTERMINATED_CHARGING_ALARM"},
    {obsbOVER_CHARGED_ALARM, "obsbOVER_CHARGED_ALARM"},
};

template <size_t N>
void AppendNames(longword bits, const NamedBit (&names)[N], std::vector<std::string>* lines) {
  for (const NamedBit& named : names) {
    if (bits & named.bit) lines->push_back(named.name);
  }
}

// Converts a temperature in units of 0.1 kelvin to degrees Celsius; 0 degrees are 273.15 kelvin.
double Celsius(word temperature) { return (int{temperature} - 2731.5) / 10; }

// Returns the text for a time zone, given as the hours by which local time is ahead of UTC.  The
// value 0x7f, otimeTIME_DIF_UNDEF, means that the zone is unknown.
std::string Zone(sbyte time_dif) {
  return time_dif == 0x7f ? "zone unknown" : fmt::format("UTC{:+}", int{time_dif});
}

}  // namespace

namespace openr_host {

std::string PowerSummary(const OPowerStatus& s) {
  return fmt::format(
      "robot 0x{:08x}, battery 0x{:04x}, {} %, {:.1f} C, {} mAh, {} mV, {} mA, {}, "
      "volume {}",
      s.robotStatus, s.batteryStatus, s.remainingCapacity, Celsius(s.temperature),
      s.fullyChargedCapacity, s.voltage, s.current, Zone(s.timeDif), s.volume);
}

std::vector<std::string> PowerDetails(const OPowerStatus& s) {
  std::vector<std::string> lines;
  AppendNames(s.robotStatus, kRobotBits, &lines);
  AppendNames(s.batteryStatus, kBatteryBits, &lines);
  lines.push_back(fmt::format("battery error code {}", s.batteryStatus & obsbERROR_CODE_MASK));
  lines.push_back(fmt::format("remaining capacity {} %", s.remainingCapacity));
  lines.push_back(fmt::format("temperature {:.1f} C", Celsius(s.temperature)));
  lines.push_back(fmt::format("fully charged capacity {} mAh", s.fullyChargedCapacity));
  lines.push_back(fmt::format("voltage {} mV", s.voltage));
  lines.push_back(fmt::format("current {} mA", s.current));
  lines.push_back(fmt::format("time difference {}", Zone(s.timeDif)));
  lines.push_back(fmt::format("volume {}", s.volume));
  return lines;
}

}  // namespace openr_host

OPowerStatus::OPowerStatus() : OPowerStatus(0, 0, 0, 0, 0, 0, 0, 0, 0) {}

OPowerStatus::OPowerStatus(longword robotStat, word batteryStat, word remaining, word temp,
                           word fullyCharged, word volt, sword cur, sbyte timeDifference, byte vol)
    : robotStatus(robotStat),
      batteryStatus(batteryStat),
      remainingCapacity(remaining),
      temperature(temp),
      fullyChargedCapacity(fullyCharged),
      voltage(volt),
      current(cur),
      timeDif(timeDifference),
      volume(vol) {}

void OPowerStatus::Set(longword rs, word bs, word rc, word tmp, sbyte td, byte vol) {
  robotStatus = rs;
  batteryStatus = bs;
  remainingCapacity = rc;
  temperature = tmp;
  timeDif = td;
  volume = vol;
}

void OPowerStatus::Print() const { osysprint("%s\n", openr_host::PowerSummary(*this).c_str()); }

void OPowerStatus::PrintDetail() const {
  for (const std::string& line : openr_host::PowerDetails(*this)) osysprint("%s\n", line.c_str());
}

OBootCondition::OBootCondition() : OBootCondition(0) {}
OBootCondition::OBootCondition(word bits) : OBootCondition(bits, 0, obcbttRELATIVE) {}
OBootCondition::OBootCondition(word bits, time_t time, longword timeType)
    : OBootCondition(bits, time, timeType, 0) {}
OBootCondition::OBootCondition(word bits, time_t time, longword timeType, byte vibration)
    : bitmap(bits), bootTime(time), bootTimeType(timeType), vibrationLevel(vibration) {}

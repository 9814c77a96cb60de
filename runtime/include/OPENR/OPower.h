// Types for motor power, battery status and the conditions for booting.
#ifndef OPENR_OPOWER_H_INCLUDED
#define OPENR_OPOWER_H_INCLUDED

#include <OPENR/OPENR.h>
#include <OPENR/OTime.h>
#include <OPENR/power_constants.h>
#include <time.h>

// The argument of OPENR::SetMotorPower(): whether the motors of the robot have power.
typedef bool OPower;
const OPower opowerOFF = false;
const OPower opowerON = true;

// The status of power and battery at one moment, 20 bytes.  OPENR::ObservePowerStatus() also takes
// an OPowerStatus, but reads its fields as a filter: they select the changes that the function
// reports (power_constants.h).
class OPowerStatus {
 public:
  longword robotStatus;       // bits orsb... (power_constants.h)
  word batteryStatus;         // bits obsb...; the low four bits hold an error code obsec...
  word remainingCapacity;     // in %, 0..100
  word temperature;           // temperature of the battery in 0.1 K
  word fullyChargedCapacity;  // in mAh
  word voltage;               // in mV
  sword current;              // in mA; negative while discharging (inferred)
  sbyte timeDif;              // hours by which local time is ahead of UTC
  byte volume;                // position of the volume switch, 0..3

  OPowerStatus();  // sets all fields to 0
  OPowerStatus(longword robotStat, word batteryStat, word remaining, word temp, word fullyCharged,
               word volt, sword cur, sbyte timeDifference, byte vol);

  // Sets the six fields of this OPowerStatus that OPENR::ObservePowerStatus() can observe; the
  // other three keep their values.
  void Set(longword rs, word bs, word rc, word tmp, sbyte td, byte vol);

  // Print the status on the console.  Print() prints one line.  PrintDetail() prints a line for
  // each bit that is set and for each measured value, such as the voltage.
  void Print() const;
  void PrintDetail() const;
};

// The conditions under which the robot boots after OPENR::Shutdown(), or the conditions that have
// caused its last boot.
//
// An OBootCondition has 16 bytes on the robot, and more on a host with a 64-bit time_t.  The larger
// size does no harm, because an OBootCondition is passed by reference only.
class OBootCondition {
 public:
  word bitmap;            // bits obcb... (power_constants.h)
  time_t bootTime;        // in s; used only with the bit obcbBOOT_TIMER
  longword bootTimeType;  // obcbttRELATIVE or obcbttABSOLUTE
  byte vibrationLevel;    // used with obcbVIBRATION_DETECTED

  OBootCondition();  // sets no condition, so nothing boots the robot
  OBootCondition(word bits);
  OBootCondition(word bits, time_t time, longword timeType);
  OBootCondition(word bits, time_t time, longword timeType, byte vibration);
};

#endif  // OPENR_OPOWER_H_INCLUDED

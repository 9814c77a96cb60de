// Motor power, battery, and what may wake the robot.
#ifndef OPENR_OPOWER_H_INCLUDED
#define OPENR_OPOWER_H_INCLUDED

#include <OPENR/OPENR.h>
#include <OPENR/OTime.h>
#include <OPENR/power_constants.h>
#include <time.h>

// Argument of OPENR::SetMotorPower().
typedef bool OPower;
const OPower opowerOFF = false;
const OPower opowerON = true;

// A snapshot of power and battery, 20 bytes.  As the first argument of
// OPENR::ObservePowerStatus() it is a filter instead; power_constants.h says how.
class OPowerStatus {
 public:
  longword robotStatus;       // orsb... bits
  word batteryStatus;         // obsb... bits; the low four are an obsec... code
  word remainingCapacity;     // %, 0..100
  word temperature;           // of the battery, 0.1 K
  word fullyChargedCapacity;  // mAh
  word voltage;               // mV
  sword current;              // mA; that negative means discharging is inferred
  sbyte timeDif;              // hours from UTC
  byte volume;                // 0..3

  OPowerStatus();  // all zero
  OPowerStatus(longword robotStat, word batteryStat, word remaining, word temp, word fullyCharged,
               word volt, sword cur, sbyte timeDifference, byte vol);

  // The six fields that can be observed; the other three keep their values.
  void Set(longword rs, word bs, word rc, word tmp, sbyte td, byte vol);

  // On the console: one line, or one line per bit that is set and per quantity.
  void Print() const;
  void PrintDetail() const;
};

// What may boot the robot after OPENR::Shutdown(), or what did boot it.
//
// 16 bytes on the robot, more where time_t has 64 bits: it is passed by reference only.
class OBootCondition {
 public:
  word bitmap;            // obcb... bits
  time_t bootTime;        // s, for obcbBOOT_TIMER
  longword bootTimeType;  // obcbttRELATIVE or obcbttABSOLUTE
  byte vibrationLevel;    // for obcbVIBRATION_DETECTED

  OBootCondition();  // nothing boots the robot
  OBootCondition(word bits);
  OBootCondition(word bits, time_t time, longword timeType);
  OBootCondition(word bits, time_t time, longword timeType, byte vibration);
};

#endif  // OPENR_OPOWER_H_INCLUDED

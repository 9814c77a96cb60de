// A moment of the robot's clock, with the time zone in which it is shown.
#ifndef OPENR_OTIME_H_INCLUDED
#define OPENR_OTIME_H_INCLUDED

#include <OPENR/OStatus.h>
#include <Types.h>
#include <time.h>

const sbyte otimeTIME_DIF_UNDEF = 0x7f;  // the zone is unknown, so local time is UTC
const int otimeSTART_YEAR = 2000;

// The clock is in seconds since 2000-01-01 00:00:00 UTC.  The time difference is the number of
// hours by which local time is ahead of UTC, -12..12 or otimeTIME_DIF_UNDEF.  Local time is clock +
// 3600 * difference (inferred).
class OTime {
 public:
  OTime();  // sets the clock to 0 and the time difference to undefined
  // A `timeDif` outside of -12..12 (hours by which local time is ahead of UTC) becomes
  // otimeTIME_DIF_UNDEF.
  OTime(time_t clock, sbyte timeDif);

  // Returns oINVALID_ARG and changes nothing if `timeDif` is not valid.  Valid are -12..12 (hours
  // by which local time is ahead of UTC) and otimeTIME_DIF_UNDEF.
  OStatus Set(time_t clock, sbyte timeDif);
  OStatus SetClock(time_t clock);
  OStatus SetLocalTime(time_t localTime);  // sets the clock; keeps the time difference
  OStatus SetTimeDif(sbyte timeDif);       // keeps the clock

  time_t GetClock() const { return clock_; }
  time_t GetLocalTime() const;
  sbyte GetTimeDif() const { return timeDif_; }

  // Compare only the clocks; the time difference is ignored.
  bool operator<(const OTime& other) const { return clock_ < other.clock_; }
  bool operator<=(const OTime& other) const { return clock_ <= other.clock_; }
  bool operator>(const OTime& other) const { return clock_ > other.clock_; }
  bool operator>=(const OTime& other) const { return clock_ >= other.clock_; }
  bool operator==(const OTime& other) const { return clock_ == other.clock_; }

 private:
  time_t clock_;
  sbyte timeDif_;
};

#endif  // OPENR_OTIME_H_INCLUDED

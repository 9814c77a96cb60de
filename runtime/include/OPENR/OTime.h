// A moment of the robot's clock, with the time zone it is to be shown in.
#ifndef OPENR_OTIME_H_INCLUDED
#define OPENR_OTIME_H_INCLUDED

#include <OPENR/OStatus.h>
#include <Types.h>
#include <time.h>

const sbyte otimeTIME_DIF_UNDEF = 0x7f;  // zone unknown: local time is shown as UTC
const int otimeSTART_YEAR = 2000;

// Clock: seconds since 2000-01-01 00:00:00 UTC.  Time difference: hours that local time
// is ahead of UTC, -12..12 or otimeTIME_DIF_UNDEF.  Local time: clock + 3600 * difference
// (inferred).
class OTime {
 public:
  OTime();  // clock 0, difference undefined
  // A difference outside the range counts as undefined.
  OTime(time_t clock, sbyte timeDif);

  // oINVALID_ARG for a time difference outside the range; then nothing changes.
  OStatus Set(time_t clock, sbyte timeDif);
  OStatus SetClock(time_t clock);
  OStatus SetLocalTime(time_t localTime);  // keeps the time difference
  OStatus SetTimeDif(sbyte timeDif);       // keeps the clock

  time_t GetClock() const { return clock_; }
  time_t GetLocalTime() const;
  sbyte GetTimeDif() const { return timeDif_; }

  // Order of the moments; the time difference plays no part.
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

// The functions of OTime, the clock with its time zone, and of SystemTime, the time that
// GetSystemTime() returns.
#include <OPENR/OTime.h>
#include <SystemTime.h>

#include <cstdint>

namespace {

constexpr int kSecondsPerHour = 3600;
constexpr uint32_t kMicrosecondsPerSecond = 1000000;

// Returns whether `dif` is a valid difference between local time and UTC: the hours by which local
// time is ahead, or the value for an unknown difference.
bool IsTimeDif(sbyte dif) { return dif == otimeTIME_DIF_UNDEF || (dif >= -12 && dif <= 12); }

// Returns the difference between local time and UTC in seconds.  With an unknown difference, local
// time is UTC.
time_t SecondsOf(sbyte dif) { return dif == otimeTIME_DIF_UNDEF ? 0 : dif * kSecondsPerHour; }

}  // namespace

OTime::OTime() : clock_(0), timeDif_(otimeTIME_DIF_UNDEF) {}

OTime::OTime(time_t clock, sbyte timeDif)
    : clock_(clock), timeDif_(IsTimeDif(timeDif) ? timeDif : otimeTIME_DIF_UNDEF) {}

OStatus OTime::Set(time_t clock, sbyte timeDif) {
  if (!IsTimeDif(timeDif)) return oINVALID_ARG;
  clock_ = clock;
  timeDif_ = timeDif;
  return oSUCCESS;
}

OStatus OTime::SetClock(time_t clock) {
  clock_ = clock;
  return oSUCCESS;
}

OStatus OTime::SetLocalTime(time_t localTime) {
  clock_ = localTime - SecondsOf(timeDif_);
  return oSUCCESS;
}

OStatus OTime::SetTimeDif(sbyte timeDif) { return Set(clock_, timeDif); }

time_t OTime::GetLocalTime() const { return clock_ + SecondsOf(timeDif_); }

bool operator<(const SystemTime& left, const SystemTime& right) {
  if (left.seconds != right.seconds) return left.seconds < right.seconds;
  return left.useconds < right.useconds;
}

SystemTime operator+(const SystemTime& left, const SystemTime& right) {
  const uint32_t useconds = left.useconds + right.useconds;
  return SystemTime(left.seconds + right.seconds + useconds / kMicrosecondsPerSecond,
                    useconds % kMicrosecondsPerSecond);
}

SystemTime operator-(const SystemTime& left, const SystemTime& right) {
  const bool borrow = left.useconds < right.useconds;
  return SystemTime(left.seconds - right.seconds - (borrow ? 1 : 0),
                    left.useconds + (borrow ? kMicrosecondsPerSecond : 0) - right.useconds);
}

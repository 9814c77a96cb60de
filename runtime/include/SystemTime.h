// The system's clock: seconds and microseconds since boot, never going back.
//
// GetSystemTime() (MCOOP.h) fills one.  On the host this is virtual time.
#ifndef OPENR_SYSTEMTIME_H_INCLUDED
#define OPENR_SYSTEMTIME_H_INCLUDED

#include <Types.h>

// A SystemTime as plain data, for structures that C reads as well.
struct structSystemTime {
  longword seconds;
  longword useconds;  // 0..999999
};

struct SystemTime : public structSystemTime {
  SystemTime() { Set(0, 0); }
  SystemTime(longword sec, longword usec) { Set(sec, usec); }

  // An invalid time has 0xffffffff in both fields.
  bool IsValid() const { return seconds != 0xffffffff || useconds != 0xffffffff; }
  void MakeInvalid() { Set(0xffffffff, 0xffffffff); }

 private:
  void Set(longword sec, longword usec) {
    seconds = sec;
    useconds = usec;
  }
};

// Both operands must be valid.  The results have useconds below 1000000; seconds wrap at
// 2^32, so `later - earlier` is right and `earlier - later` is a very large time.
bool operator<(const SystemTime& left, const SystemTime& right);
SystemTime operator+(const SystemTime& left, const SystemTime& right);
SystemTime operator-(const SystemTime& left, const SystemTime& right);

#endif  // OPENR_SYSTEMTIME_H_INCLUDED

// A time of the system's clock: seconds and microseconds since boot.  The clock never goes back.
//
// GetSystemTime() (MCOOP.h) returns a SystemTime.  On the host it is virtual time.
#ifndef OPENR_SYSTEMTIME_H_INCLUDED
#define OPENR_SYSTEMTIME_H_INCLUDED

#include <Types.h>

// A SystemTime as plain data, for structures that C code reads too.
struct structSystemTime {
  longword seconds;
  longword useconds;  // 0..999999
};

struct SystemTime : public structSystemTime {
  SystemTime() { Set(0, 0); }
  SystemTime(longword sec, longword usec) { Set(sec, usec); }

  // A time is invalid if both fields are 0xffffffff.
  bool IsValid() const { return seconds != 0xffffffff || useconds != 0xffffffff; }
  void MakeInvalid() { Set(0xffffffff, 0xffffffff); }

 private:
  void Set(longword sec, longword usec) {
    seconds = sec;
    useconds = usec;
  }
};

// Compare, add and subtract valid times.  Results have useconds below 1000000.  Seconds wrap at
// 2^32, so `later - earlier` is right, but `earlier - later` is a very large time.
bool operator<(const SystemTime& left, const SystemTime& right);
SystemTime operator+(const SystemTime& left, const SystemTime& right);
SystemTime operator-(const SystemTime& left, const SystemTime& right);

#endif  // OPENR_SYSTEMTIME_H_INCLUDED

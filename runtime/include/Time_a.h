// Spans of time in milliseconds, for timeouts and timed messages.
//
// The SDK also declares two conversions to and from SystemTime.  They are left out, because no
// library of the SDK defines them, so no program can use them.
#ifndef OPENR_TIME_A_H_INCLUDED
#define OPENR_TIME_A_H_INCLUDED

#include <Types.h>

struct RelativeTime {
  longword sec;
  longword msec;

  RelativeTime() : sec(0), msec(0) {}
  RelativeTime(longword s) : sec(s), msec(0) {}
  RelativeTime(longword s, longword ms) : sec(s), msec(ms) {}
};

// Compares field by field: 1 s is not equal to 0 s and 1000 ms.
inline bool operator==(const RelativeTime& left, const RelativeTime& right) {
  return left.sec == right.sec && left.msec == right.msec;
}

// The form in which the system itself stores a span of time.  Unlike a RelativeTime it can be
// longer than 136 years.
struct InternalTime {
  int day;
  longword sec;
  int msec;
};

#endif  // OPENR_TIME_A_H_INCLUDED

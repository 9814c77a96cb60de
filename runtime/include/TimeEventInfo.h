// The time at which a message of SetTimeEvent() is due: the part that all time events share.
#ifndef OPENR_TIMEEVENTINFO_H_INCLUDED
#define OPENR_TIMEEVENTINFO_H_INCLUDED

#include <Time_a.h>
#include <Types.h>

struct TimeEventInfo {
  enum EventType { Periodic, NonPeriodic };

  // The answer to a first time that lies in the past already: start at once, or an error.
  enum EventAttr { ExceedStartImmediate = 0, ExceedStartError = 0x10000 };

  RelativeTime relativeTime;  // from now to the first message
  RelativeTime periodicTime;  // between messages; zero: there is only the first
};

#endif  // OPENR_TIMEEVENTINFO_H_INCLUDED

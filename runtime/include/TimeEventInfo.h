// The base class of all times for SetTimeEvent(), which requests messages that come later.
#ifndef OPENR_TIMEEVENTINFO_H_INCLUDED
#define OPENR_TIMEEVENTINFO_H_INCLUDED

#include <Time_a.h>
#include <Types.h>

struct TimeEventInfo {
  enum EventType { Periodic, NonPeriodic };

  // Values that say how SetTimeEvent() acts if the time of the first message is past already: it
  // sends the message at once, or returns an error.
  enum EventAttr { ExceedStartImmediate = 0, ExceedStartError = 0x10000 };

  RelativeTime relativeTime;  // time from now to the first message
  RelativeTime periodicTime;  // time between messages; zero: only the first message is sent
};

#endif  // OPENR_TIMEEVENTINFO_H_INCLUDED

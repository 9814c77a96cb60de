// TimeEventInfoWithRelativeTime, by which a program tells SetTimeEvent() when its messages are due.
// EventID.h has the id for cancelling these messages.
#ifndef OPENR_TIMEEVENT_H_INCLUDED
#define OPENR_TIMEEVENT_H_INCLUDED

#include <EventID.h>
#include <TimeEventInfo.h>
#include <Time_a.h>
#include <Types.h>

// The only kind of time event; programs pass it to SetTimeEvent() as a TimeEventInfo*.
struct TimeEventInfoWithRelativeTime : public TimeEventInfo {
  bool isRelativeTime;  // always true
  EventType eventType;
  longword eventAttr;  // an EventAttr

  TimeEventInfoWithRelativeTime() { Set(RelativeTime()); }
  TimeEventInfoWithRelativeTime(RelativeTime first, RelativeTime period = 0,
                                longword attr = ExceedStartImmediate) {
    Set(first, period, attr);
  }
  TimeEventInfoWithRelativeTime(EventType type, RelativeTime time) { Set(type, time); }

  // Requests a message after `first`, then a message after each `period`.  With period 0, requests
  // only the first message.
  void Set(RelativeTime first, RelativeTime period = 0, longword attr = ExceedStartImmediate) {
    isRelativeTime = true;
    eventType = period == RelativeTime() ? NonPeriodic : Periodic;
    eventAttr = attr;
    relativeTime = first;
    periodicTime = period;
  }

  // Requests one message after `time`; if `type` is Periodic, requests a message each time that
  // `time` has passed.
  void Set(EventType type, RelativeTime time) {
    Set(time, type == Periodic ? time : RelativeTime());
    eventType = type;
  }
};

#endif  // OPENR_TIMEEVENT_H_INCLUDED

// The time at which a message of SetTimeEvent() is due.  The name under which it can be cancelled
// is in EventID.h.
#ifndef OPENR_TIMEEVENT_H_INCLUDED
#define OPENR_TIMEEVENT_H_INCLUDED

#include <EventID.h>
#include <TimeEventInfo.h>
#include <Time_a.h>
#include <Types.h>

// The one kind of time event there is; SetTimeEvent() takes it as a TimeEventInfo*.
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

  // First message after `first`, then one every `period`; period 0 means one message.
  void Set(RelativeTime first, RelativeTime period = 0, longword attr = ExceedStartImmediate) {
    isRelativeTime = true;
    eventType = period == RelativeTime() ? NonPeriodic : Periodic;
    eventAttr = attr;
    relativeTime = first;
    periodicTime = period;
  }

  // One message after `time`, or one every `time`.
  void Set(EventType type, RelativeTime time) {
    Set(time, type == Periodic ? time : RelativeTime());
    eventType = type;
  }
};

#endif  // OPENR_TIMEEVENT_H_INCLUDED

// When a message of SetTimeEvent() is due, and the name under which it can be cancelled.
#ifndef OPENR_TIMEEVENT_H_INCLUDED
#define OPENR_TIMEEVENT_H_INCLUDED

#include <Time_a.h>
#include <Types.h>

struct EventID {
  longword value;
};
const longword EventID_UNDEF = 0;

struct TimeEventInfo {
  enum EventType { Periodic, NonPeriodic };

  // What happens when the first time lies in the past already.
  enum EventAttr { ExceedStartImmediate = 0, ExceedStartError = 0x10000 };

  RelativeTime relativeTime;  // from now to the first message
  RelativeTime periodicTime;  // between messages; zero: there is only the first
};

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

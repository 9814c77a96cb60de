// The id with which CancelEvent() cancels a message that was requested with SetTimeEvent() or
// SetReplyEvent().
#ifndef OPENR_EVENTID_H_INCLUDED
#define OPENR_EVENTID_H_INCLUDED

#include <Types.h>

const longword EventID_UNDEF = 0;

class EventID {
 public:
  longword value;

  EventID() : value(EventID_UNDEF) {}
  EventID(longword number) : value(number) {}

  void SetValue(longword number) { value = number; }
  longword GetValue() const { return value; }

  bool IsValid() const { return value != EventID_UNDEF; }
  void MakeInvalid() { value = EventID_UNDEF; }

  bool operator==(const EventID& other) const { return value == other.value; }
  bool operator!=(const EventID& other) const { return value != other.value; }
};

#endif  // OPENR_EVENTID_H_INCLUDED

// The runtime's state of a subject (OSubject) and of an observer (OObserver).
//
// The state lies on the host's heap, not on the object's.  Only handlers of the object change it.
#pragma once

#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>
#include <OPENR/ObjcommMessages.h>

#include <list>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class Hasher;
class Object;
class System;

// Operations on regions that only the runtime may do.
struct RegionAccess {
  // Makes a region of the observer for the region `source` that it has received, with one
  // reference.
  static RCRegion* Receive(RCRegion* source, MemoryRegionID id, offset_t offset, size_t size);
  // Deletes a region that Receive() has made.
  static void GiveBack(RCRegion* received);
  static RCRegion* SourceOf(const RCRegion* received) { return received->source_; }
};

// Returns whether the library sent the message that `object` handles, with a payload of this
// `kind`.  If an object sent bytes of its own to the entry of a subject or observer, adds an error
// finding and returns false: such bytes must not be read as a notification or a ready.
bool IsRunningMessage(const Object& object, PayloadKind kind);

// The type of a deassert that the runtime itself sends because an observer is lost.
constexpr OMessageType kDeassertOfLost = 0x10000;

// Sends `subject` a deassert in the name of the observer at entry `selector` of `object`.  Also
// gives back `regions`, which the subject had sent to this observer, at most MAX_NUM_DATA.
void SendDeassert(Object* object, uint32_t selector, const SubjectID& subject,
                  const std::vector<RCRegion*>& regions);
// Refuses the notification `message` to `object`, which will not be delivered: calls SendDeassert()
// with the regions of `message`.
void RefuseNotification(Object* object, const Message& message);

// A subject's record of one observer.
struct ObserverLink {
  ObserverID observer;
  std::string name;  // the name of the observer's object, for messages to the user
  size_t skip = 0;
  size_t min = 1;
  size_t max = 1;

  // The observer's readiness.  1: ready.  0: not asserted yet, or data were sent since. -1:
  // deasserted.  Two asserts in a row count as one, as on the robot.
  int ready = 0;
  size_t skipped = 0;  // notifications skipped since the last kept notification

  std::vector<RCRegion*> fresh;  // regions set since the last notify, at most MAX_NUM_DATA
  struct Unit {
    int data;  // number of regions in `pending` that belong to this notification
  };
  std::vector<RCRegion*> pending;  // regions that were notified but not sent yet, oldest first
  std::vector<Unit> units;         // notifications whose regions are in `pending`, oldest first
  int64_t waiting_since_us = -1;   // virtual time of the oldest pending unit
  uint64_t sent = 0;               // messages sent
  int64_t sent_us = 0;             // virtual time of the last message
  uint64_t replaced = 0;           // number of units dropped because newer units replaced them
  bool is_lost = false;            // the observer is lost, and the runtime has deasserted for it
  bool told_deasserted = false;    // a finding about a notify after a deassert has been added
};

struct SubjectState {
  SubjectState(System* the_system, Object* the_object) : system(the_system), object(the_object) {}

  // Returns the link to the observer `id`, or null if that observer is not connected.
  ObserverLink* Find(const ObserverID& id);

  // Adds `region`, with one reference, to the data of the next notify.
  OStatus SetData(ObserverLink* link, RCRegion* region);
  // Makes the data set so far a pending unit, and sends it if the observer is ready.
  OStatus Notify(ObserverLink* link);
  // Sends pending units if the observer is ready and has at least `min` of them.
  void Flush(ObserverLink* link);
  // Releases all data that have not been sent.
  void Clear(ObserverLink* link);
  // Drops the oldest pending unit and releases its regions.  REQUIRES: a unit is pending.
  void DropOldestUnit(ObserverLink* link);

  void HashState(Hasher* hasher) const;

  System* const system;
  Object* const object;
  SubjectID id;
  std::string service;  // full name, for messages to the user
  size_t buffer_size = MAX_NUM_DATA + 1;
  size_t unit_size = 1;
  std::vector<std::unique_ptr<ObserverLink>> links;
  std::list<OObserverInfo> infos;  // the observers of `links`, as the SDK shows them
};

struct ObserverState {
  ObserverState(System* the_system, Object* the_object) : system(the_system), object(the_object) {}

  // Sends `command` to `subject`, together with the regions of `subject` that this object no longer
  // uses.
  OStatus SendReady(const SubjectID& subject, ObjcommCommand command);
  // Counts the readies in `asserted`.  Adds a finding if an observer asserts again and again
  // without a notification.
  void CountReady(const SubjectID& subject, ObjcommCommand command);

  System* const system;
  Object* const object;
  ObserverID id;
  std::string service;
  size_t skip = 0;
  size_t min = 1;
  size_t max = 1;
  std::list<OSubjectInfo> subjects;
  // Regions received from one subject that have not been given back, oldest first.
  struct Held {
    SubjectID subject;
    std::vector<RCRegion*> regions;
  };
  std::vector<Held> held;
  // The number of readies asserted to one subject since the last notification from any subject.
  // Notifications of other subjects reset the number too, because a program that calls
  // AssertReady() without argument, once per notification, asserts to all subjects each time.
  struct Asserted {
    SubjectID subject;
    int times;
  };
  std::vector<Asserted> asserted;
};

}  // namespace openr_host

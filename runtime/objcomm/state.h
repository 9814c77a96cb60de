// What the runtime keeps for an OSubject and an OObserver.
//
// Belongs to the System's side of the object, on the host's heap, and is touched
// only from handlers of that object.
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

// What the library inside the runtime may do to a region.
struct RegionAccess {
  // The observer's own view of a region received from `source`, count 1.
  static RCRegion* Receive(RCRegion* source, MemoryRegionID id, offset_t offset, size_t size);
  // Ends that view.
  static void GiveBack(RCRegion* received);
  static RCRegion* SourceOf(const RCRegion* received) { return received->source_; }
};

// Whether the message being handled is one of the library's, of this kind.  An object that sends
// bytes of its own to such an entry has no regions in them; that is an error finding.
bool IsRunningMessage(const Object& object, PayloadKind kind);

// Type of a deassert that comes from the runtime, for an observer that is gone.
constexpr OMessageType kDeassertOfLost = 0x10000;

// Tells `subject` that the observer of `object` with entry `selector` is not ready, and gives it
// back what it had sent there, at most MAX_NUM_DATA regions.
void SendDeassert(Object* object, uint32_t selector, const SubjectID& subject,
                  const std::vector<RCRegion*>& regions);
// The same for a notification on its way that nobody will hear.
void RefuseNotification(Object* object, const Message& message);

// One observer of one subject.
struct ObserverLink {
  ObserverID observer;
  std::string name;  // of its object, for messages to people
  size_t skip = 0;
  size_t min = 1;
  size_t max = 1;

  // 1 ready, 0 not said or data sent since, -1 not ready.  A flag, not a counter.
  int ready = 0;
  size_t skipped = 0;  // notifications left out since the last one kept

  std::vector<RCRegion*> fresh;  // set since the last notify, at most MAX_NUM_DATA
  struct Unit {
    int data;  // how many of `pending` it has
  };
  std::vector<RCRegion*> pending;  // notified, not sent; oldest first
  std::vector<Unit> units;         // of pending, oldest first
  int64_t waiting_since_us = -1;   // virtual time of the oldest pending unit
  uint64_t sent = 0;               // events
  int64_t sent_us = 0;             // virtual time of the last one
  uint64_t replaced = 0;           // units dropped for newer ones
  bool is_lost = false;            // it did not deassert itself: it is gone
  bool told_deasserted = false;    // a notify to it while it had deasserted was reported
};

struct SubjectState {
  SubjectState(System* the_system, Object* the_object) : system(the_system), object(the_object) {}

  ObserverLink* Find(const ObserverID& id);

  OStatus SetData(ObserverLink* link, RCRegion* region);
  OStatus Notify(ObserverLink* link);
  // Sends what is pending if the observer is ready and enough has been collected.
  void Flush(ObserverLink* link);
  void Clear(ObserverLink* link);
  void DropOldestUnit(ObserverLink* link);

  void HashState(Hasher* hasher) const;

  System* const system;
  Object* const object;
  SubjectID id;
  std::string service;  // full name, for messages to people
  size_t buffer_size = MAX_NUM_DATA + 1;
  size_t unit_size = 1;
  std::vector<std::unique_ptr<ObserverLink>> links;
  std::list<OObserverInfo> infos;  // the same, as the SDK shows them
};

struct ObserverState {
  ObserverState(System* the_system, Object* the_object) : system(the_system), object(the_object) {}

  OStatus SendReady(const SubjectID& subject, ObjcommCommand command);
  // Counts in `asserted`; far too many are a finding.
  void CountReady(const SubjectID& subject, ObjcommCommand command);

  System* const system;
  Object* const object;
  ObserverID id;
  std::string service;
  size_t skip = 0;
  size_t min = 1;
  size_t max = 1;
  std::list<OSubjectInfo> subjects;
  // Regions received and not given back, per subject, oldest first.
  struct Held {
    SubjectID subject;
    std::vector<RCRegion*> regions;
  };
  std::vector<Held> held;
  // Readies asserted to a subject since the last notification of any subject, not only of that
  // one: AssertReady() without argument, once per notification, asserts to all of them.
  struct Asserted {
    SubjectID subject;
    int times;
  };
  std::vector<Asserted> asserted;
};

}  // namespace openr_host

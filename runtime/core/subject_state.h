// SubjectState: the runtime's record of a subject (OSubject, the sending end of connections).
//
// The record lies on the host's heap, so it takes no memory of the object's heap.  Only handlers of
// the object change the record.
#pragma once

#include <OPENR/OSubject.h>
#include <OPENR/ObjcommMessages.h>

#include <cstddef>
#include <cstdint>
#include <list>
#include <string>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/core/message.h"
#include "runtime/core/object.h"
#include "runtime/core/region_access.h"

namespace openr_host {

class Hasher;
class System;

// The regions of one notification, at most MAX_NUM_DATA, oldest first.  The list holds its elements
// itself; a std::vector would allocate memory for them, one more cache line to read for each
// notification.
class RegionList {
 public:
  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  RCRegion* const* begin() const { return regions_; }
  RCRegion* const* end() const { return regions_ + size_; }

  // Adds `region` as the newest region of the list, which holds the regions of one notification.
  // REQUIRES: size() < MAX_NUM_DATA.
  void Append(RCRegion* region) {
    ASSERT(size_ < MAX_NUM_DATA);
    regions_[size_++] = region;
  }
  // Removes the oldest region of the list and returns the region.  REQUIRES: !empty().
  RCRegion* TakeFirst();
  void Clear() { size_ = 0; }

 private:
  size_t size_ = 0;
  RCRegion* regions_[MAX_NUM_DATA];  // only the first size_ elements have values
};

// A subject's record of one observer.  The members up to `fresh`, which every notification reads,
// come first, so that they lie on few cache lines.
struct ObserverLink {
  size_t skip = 0;
  size_t min = 1;
  size_t max = 1;
  // Number of notifications skipped since the last notification that was kept, because the observer
  // wants to get only one of `skip` + 1 notifications (OObserver::SetSkip()).
  size_t skipped = 0;
  // Virtual time since which a notification waits for the observer's ready; -1 if no notification
  // waits.
  int64_t waiting_since_us = -1;
  uint64_t sent = 0;             // number of messages that were sent to the observer
  int64_t sent_us = 0;           // virtual time of the newest message to the observer
  bool is_lost = false;          // true: the observer is lost, so the runtime has deasserted ready
  bool told_deasserted = false;  // whether ReportDeasserted() has added its finding

  ObserverID observer;
  ObjectId target = kNoObject;  // the object that has the observer
  // Whether the observer is ready for the next notification.  1: it has asserted ready, once or
  // several times; -1: it has deasserted ready; 0: it has done neither since the last data were
  // sent to it.
  int ready = 0;
  struct Unit {
    int data;  // number of regions in `pending` that belong to this notification
  };
  std::vector<Unit> units;  // notifications whose regions are in `pending`, oldest first
  RegionList fresh;         // the regions that SetData() has added since the last Notify()

  std::vector<RCRegion*> pending;  // regions of notifications that were not sent yet, oldest first
  // Number of notifications that were dropped because newer notifications replaced them.
  uint64_t replaced = 0;
  std::string name;  // the name of the observer's object, for messages to the user
};

// The runtime's record of a subject.  The members that every ready and notification reads come
// first, so that they lie on few cache lines.
struct SubjectState {
  SubjectState(System* the_system, Object* the_object) : system(the_system), object(the_object) {}

  // Returns this subject's record of the observer `id`, or null if that observer is not connected.
  ObserverLink* Find(const ObserverID& id) {
    for (ObserverLink& link : links) {
      if (link.observer == id) return &link;
    }
    return nullptr;
  }

  // Takes a reference to `region` and adds the region to the data of the next notification.  If the
  // next notification then has more than MAX_NUM_DATA regions, drops its oldest region and returns
  // oFATAL, as on the robot.
  OStatus SetData(ObserverLink* link, RCRegion* region) {
    RegionAccess::AddReference(region);
    const bool has_room = link->fresh.size() < MAX_NUM_DATA;
    if (!has_room) [[unlikely]]
      DropOldestData(link);
    link->fresh.Append(region);
    return has_room ? oSUCCESS : oFATAL;
  }
  void DropOldestData(ObserverLink* link);
  // Makes one notification (a pending unit) of the data that were set since the last notification,
  // and sends it if the observer is ready.
  OStatus Notify(ObserverLink* link);
  // Posts one message for `unit_count` notifications of this subject.  The `data_count` regions at
  // `data` are the data of all these notifications.  Returns false if the message is refused, for
  // example because the queue of the observer's object is full.
  bool Send(ObserverLink* link, RCRegion* const* data, size_t data_count, size_t unit_count);
  // Sends pending notifications if the observer is ready and at least ObserverLink::min
  // notifications are pending.  The observer sets this number with SetBufCtrlParam().
  void Flush(ObserverLink* link) {
    if (link->ready > 0 && !link->units.empty() && link->units.size() >= link->min)
      SendPending(link);
  }
  void SendPending(ObserverLink* link);
  // Drops all data that were not sent to the observer yet: the data of pending notifications, and
  // the data set for the next notification.  Gives up the references to the regions of these data.
  // Called when the program clears the buffer and when the connection ends.
  void Clear(ObserverLink* link);
  // Makes the notifications in `notify`, which Send() has sent to the observer of `link`, pending
  // again, because the message was refused (HandleLateRefusal()).
  void TakeBack(ObserverLink* link, const ONotifyMessage& notify);
  // Drops the oldest pending notification, the first element of ObserverLink::units, and gives up
  // the references to its regions.  REQUIRES: a notification is pending.
  void DropOldestUnit(ObserverLink* link);

  void HashState(Hasher* hasher) const;

  System* const system;
  Object* const object;
  SubjectID id;
  std::vector<ObserverLink> links;
  std::string service;  // full name of the subject's service, for messages to the user
  size_t buffer_size = MAX_NUM_DATA + 1;
  size_t unit_size = 1;
  // The connected observers, in the form that OSubject::begin() returns.
  std::list<OObserverInfo> infos;
};

}  // namespace openr_host

// SubjectState and ObserverState: the runtime's record of each subject (OSubject, the sending end
// of connections) and of each observer (OObserver, the receiving end).
//
// The records lie on the host's heap and not on the object's heap, so they do not count as memory
// of the robot.  Only handlers of the object change them.
#pragma once

#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>
#include <OPENR/ObjcommMessages.h>

#include <functional>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/message.h"
#include "runtime/core/object.h"

namespace openr_host {

class Hasher;
class System;

// Operations on RCRegions (references to shared memory) that the runtime may do and objects may
// not.
struct RegionAccess {
  // Returns the part of a notification that describes `region`: its id, and the offset and size of
  // its data.
  static TransferedData Describe(RCRegion* region) {
    return {region, region->id_, region->offset_, region->size_};
  }
  // Makes an RCRegion for an observer of `system`, with one reference.  `data` is the part of the
  // notification that describes the subject's RCRegion.  Both RCRegions refer to the same memory,
  // unless the observer gets a read-only copy (guard_pages.h).
  static RCRegion* Receive(System* system, const TransferedData& data);
  // Deletes `received`, an RCRegion that Receive() has made for an observer of `system`.
  static void GiveBack(System* system, RCRegion* received);
  // Visits the pool from which this thread takes the memory of its RCRegions, so that the search
  // for leaks knows what the pool contains.  Calls `memory` for each piece of memory that belongs
  // to the pool, and `used` for every RCRegion of the pool that was made and has not been deleted.
  static void VisitPool(const std::function<void(const void* begin, size_t bytes)>& memory,
                        const std::function<void(const RCRegion* region)>& used);
  // Completes a new RCRegion that was made from a region id without its address or without its
  // size: sets the missing values from the RegionTable.
  static void Complete(RCRegion* region);
  // The next two functions do what the functions of RCRegion with these names do.  They are inline,
  // because they run for every notification.
  static void AddReference(RCRegion* region) { ++region->count_; }
  static void RemoveReference(RCRegion* region) {
    if (region->count_ > 1) [[likely]]
      --region->count_;
    else
      region->RemoveReference();
  }
  static RCRegion* SourceOf(const RCRegion* received) { return received->source_; }

 private:
  static void UseReadOnlyCopy(RCRegion* region);
};

// Adds an error finding: an entry of a subject or observer of `object` has received bytes that are
// neither a notification nor a ready.
void ReportForeignBytes(const Object& object);

// Returns whether the message that `object` handles is of this `kind` (a notification or a ready),
// and so was sent by an OSubject or OObserver.  If an object has sent other bytes to the entry of a
// subject or observer, adds an error finding and returns false.  Such bytes must not be read as a
// notification or a ready.
inline bool IsRunningMessage(const Object& object, PayloadKind kind) {
  // Returns true if `object` handles no message now, because there is no message whose kind can be
  // wrong.  This occurs only if a test calls the function of the entry directly.
  if (object.running() == nullptr || object.running()->kind == kind) [[likely]]
    return true;
  ReportForeignBytes(object);
  return false;
}

// The message type of a deassert that the runtime sends in place of an observer that cannot
// receive, because the observer's process has ended or its object is being replaced.  No message
// type of the SDK has this value.
constexpr OMessageType kDeassertOfLost = 0x10000;

// The message type of the connect message that an observer gets if the process of the subject is
// lost.  The observer then sends nothing to the subject, and only records that the subject is
// missing (ObserverState::missing).  No message type of the SDK has this value.
constexpr OMessageType kConnectToLost = 0x10001;

// Sends `subject` a deassert, which says that the observer at entry `selector` of `object` is not
// ready.  The deassert also gives back `regions`, at most MAX_NUM_DATA, which the subject had sent
// to this observer.
void SendDeassert(Object* object, uint32_t selector, const SubjectID& subject,
                  const std::vector<RCRegion*>& regions);
// Handles a notification to `object` that will not be delivered.  Gives the regions of `message`
// back to the subject with SendDeassert(), so that the subject can use them again.
void RefuseNotification(Object* object, const Message& message);
// Handles `message`, a notification or a ready of `sender` that was refused when it left the outbox
// of `sender` (cpu.h).  The function that has sent `message` has already returned success.  The
// data of a notification become pending again, as if Send() had failed.  If the subject is in a
// worker process or no longer has the observer, its regions are given back instead.  The command of
// a ready is lost, but the regions in the ready are given back.
void HandleLateRefusal(Object* sender, const Message& message);

// The regions of one notification, at most MAX_NUM_DATA, oldest first.  Unlike a std::vector the
// list needs no memory of its own, which would be one more cache line to read for each
// notification.
class RegionList {
 public:
  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  RCRegion* const* begin() const { return regions_; }
  RCRegion* const* end() const { return regions_ + size_; }

  // Adds `region` as the newest region of the list, which holds the regions of one notification.
  // REQUIRES: size() < MAX_NUM_DATA.
  void Append(RCRegion* region) { regions_[size_++] = region; }
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
  bool is_lost = false;          // whether the runtime sent the last deassert (kDeassertOfLost)
  bool told_deasserted = false;  // whether ReportDeasserted() has added its finding

  ObserverID observer;
  ObjectId target = kNoObject;  // the object of `observer`
  // Whether the observer is ready for the next notification: 1 if the observer has asserted ready;
  // -1 if it has deasserted ready; 0 if it has done neither since the last data were sent to it.
  // Two asserts in a row count as one, as on the robot.
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
  std::list<OObserverInfo> infos;  // the observers of `links`, as OSubject::begin() shows them
};

// The runtime's record of an observer.  The members that every ready and notification reads come
// first, so that they lie on few cache lines.
struct ObserverState {
  ObserverState(System* the_system, Object* the_object) : system(the_system), object(the_object) {}

  // Sends `command`, ready or not ready, to `subject`.  The message also gives back the regions of
  // `subject` that this object no longer uses.
  OStatus SendReady(const SubjectID& subject, ObjcommCommand command);
  // Prints, as the robot does, that a ready could not be posted because of `error`.  Returns
  // oSEND_FAIL, the result of SendReady() in this case.
  OStatus ReportRefusedReady(sError error);
  System* const system;
  Object* const object;
  ObserverID id;
  // The observer's record of one subject.
  struct Held {
    SubjectID subject;
    ObjectId target = kNoObject;  // the object of `subject`
    // The regions that this observer has received from the subject and has not given back yet,
    // oldest first.
    std::vector<RCRegion*> regions;
    // The number of times that the observer has asserted ready to the subject without a deassert,
    // and without a notification from any subject, in between.  A large number becomes a finding
    // (ReportRepeatedReady()).  Notifications of other subjects count too, because many programs
    // call AssertReady() without argument after each notification, which asserts ready to all
    // subjects.
    int asserted = 0;
  };
  std::vector<Held> held;
  std::list<OSubjectInfo> subjects;  // the connected subjects, as the SDK shows them
  // The name of a connected subject: the full name of its service.
  struct Name {
    SubjectID subject;
    std::string service;
  };
  std::vector<Name> names;
  // A subject that is not connected now, but will be: its process is lost, or its object is being
  // replaced.
  struct Missing {
    std::string service;
    // The last command (ready or not ready) that the program has given for all subjects while this
    // subject was missing; objcommCMD_UNDEF if the program has given none.  As soon as the subject
    // is connected, the observer sends this command, because the program does not know that the
    // subject was missing and so does not repeat the command.
    ObjcommCommand command = objcommCMD_UNDEF;
  };
  std::vector<Missing> missing;  // mostly empty
  std::string service;
  size_t skip = 0;
  size_t min = 1;
  size_t max = 1;

  // Returns this observer's record of `subject`.  Makes the record if it does not exist yet.
  Held& HeldOf(const SubjectID& subject) {
    for (Held& entry : held) {
      if (entry.subject == subject) [[likely]]
        return entry;
    }
    return AddHeld(subject);
  }
  Held& AddHeld(const SubjectID& subject);
  // Sends `command`, ready or not ready, to all subjects.  Subjects whose process is lost or whose
  // object is being replaced (ObserverState::missing) get the command when they are connected
  // again.
  OStatus SendReadyToAll(ObjcommCommand command);
  // Records that this observer is connected with `subject`, which has registered `subject_service`.
  // Sends the command that the observer has given while this subject was missing.
  void AddSubject(const SubjectID& subject, const std::string& subject_service);
  // Removes from `subjects` and `names` each subject for which `ends` returns true, because this
  // observer is no longer connected with the subject.
  void RemoveSubjects(const std::function<bool(const SubjectID&)>& ends);
  // Records that the subject of `subject_service` is missing: its process is lost, or its object is
  // being replaced.
  void MissSubject(const std::string& subject_service);
  // Adds a finding: this observer repeats its ready to a subject without a notification in between.
  void ReportRepeatedReady(const Held& held);
};

}  // namespace openr_host

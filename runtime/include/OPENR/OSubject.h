// OSubject: the sending end of connections.
//
// Ready is a flag per connection.  NotifyObservers() sends all data set since
// the last call to every ready observer as one event and clears its flag; for
// an observer that is not ready the newest `max` notifications wait (1 unless
// the observer asked for more) and go out with its next ready, before the
// user's Ready function runs.  (measured.md, section 1)
#ifndef OPENR_OSUBJECT_H_INCLUDED
#define OPENR_OSUBJECT_H_INCLUDED

#include <OPENR/OMemoryLocator.h>
#include <OPENR/OObserverInfo.h>
#include <OPENR/OPENREvent.h>
#include <OPENR/OShmPtr.h>
#include <OPENR/ObjcommEvent.h>
#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>

namespace openr_host {
struct SubjectState;
}

class OSubject {
 public:
  OSubject();
  ~OSubject();

  // In DoInit: the entry that receives READY messages; it becomes the ID.
  OStatus SetReadyEntry(const OServiceEntry& entry);
  const SubjectID& GetID() const;

  // In DoInit: entries kept per observer (14 by default) and SetData() calls
  // per unit of transmission (1).  Refused once a connection exists.
  OStatus SetBufferSize(size_t size);
  size_t GetBufferSize() const;
  OStatus SetNotifyUnitSize(size_t size);
  size_t GetNotifyUnitSize() const;

  // Appends data for every observer (or one).  The first form copies; the
  // others share, adding one reference per observer.  The 14th datum since
  // the last notify drops the oldest and returns oFATAL (28).
  OStatus SetData(const void* buf, size_t size);
  OStatus SetData(RCRegion* region);
  OStatus SetData(const OShmPtrBase& ptr);
  OStatus SetData(const OObserverInfo& info, const void* buf, size_t size);
  OStatus SetData(const OObserverInfo& info, RCRegion* region);
  OStatus SetData(const OObserverInfo& info, const OShmPtrBase& ptr);
  OStatus SetData(const ObserverID& id, const void* buf, size_t size);
  OStatus SetData(const ObserverID& id, RCRegion* region);
  OStatus SetData(const ObserverID& id, const OShmPtrBase& ptr);

  // Old forms for memory that the program itself made: share it from its start, or from the
  // locator's offset to the end of the region.  oINVALID_ARG when there is no such memory.
  OStatus SetData(MemoryRegionID region, size_t size);
  OStatus SetData(const OMemoryLocator& locator);
  OStatus SetData(const ObserverID& id, MemoryRegionID region, u_int size);
  OStatus SetData(const ObserverID& id, const OMemoryLocator& locator);

  OStatus NotifyObservers();
  OStatus NotifyObserver(const OObserverInfo& info);
  OStatus NotifyObserver(const ObserverID& id);

  // Entries still free (the least over all observers); 0 for an unknown id.
  size_t RemainBuffer() const;
  size_t RemainBuffer(const OObserverInfo& info) const;
  size_t RemainBuffer(const ObserverID& id) const;

  OStatus ClearBuffer();
  OStatus ClearBuffer(const OObserverInfo& info);
  OStatus ClearBuffer(const ObserverID& id);

  // Called by the stub.
  OStatus ControlHandler(const OControlMessage& msg, OStatus status = oSUCCESS);
  OStatus ControlHandler(const OControlMessage* msg, OStatus status = oSUCCESS) {
    return ControlHandler(*msg, status);
  }
  OStatus ReadyHandler(const OReadyMessage& msg);
  OStatus ReadyHandler(const OReadyMessage* msg) { return ReadyHandler(*msg); }

  int NumberOfObservers() const;
  ObserverConstIterator begin() const;
  ObserverConstIterator end() const;
  ObserverConstIterator FindObserver(const ObserverID& id) const;  // end() if absent

  // How many observers are ready; IsAllReady: the same, but 0 while any
  // observer has not said whether it is.
  int IsAllReady() const;
  int IsAnyReady() const;
  int IsReady() const { return IsAnyReady(); }
  int IsReady(const ObserverID& id) const;
  int IsReady(const OObserverInfo& info) const { return IsReady(info.GetObserverID()); }

  // > 0 ready, 0 unknown or already sent, < 0 deasserted; 0 for an unknown id.
  int ReadyStatus(const ObserverID& id) const;
  int ReadyStatus(const OObserverInfo& info) const { return ReadyStatus(info.GetObserverID()); }

 private:
  OSubject(const OSubject&);
  OSubject& operator=(const OSubject&);

  openr_host::SubjectState* state_;  // belongs to the runtime
};

#endif  // OPENR_OSUBJECT_H_INCLUDED

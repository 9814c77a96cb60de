// OSubject, the sending end of connections.
//
// Each connection has a ready flag.  NotifyObservers() makes one notification of all data that were
// set since the last call.  If an observer is ready, the subject sends the notification and clears
// the ready flag of the connection to this observer.  If an observer is not ready, only the newest
// notification waits, or more of the newest notifications if the observer has called
// OObserver::SetBufCtrlParam().  When the observer's next ready arrives, the subject sends the
// waiting notifications; then the program's Ready function runs (measured.md, section 1).
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

  // Sets the entry that receives the readies of observers (OReadyMessage).  This entry becomes the
  // id of the subject.  Called in DoInit.
  OStatus SetReadyEntry(const OServiceEntry& entry);
  const SubjectID& GetID() const;

  // Set the buffer size for each observer (by default 14), and the number of SetData() calls in one
  // unit (by default 1).  On the host, the buffer size changes only the results of RemainBuffer(),
  // and the number of calls in a unit changes nothing.  Called in DoInit; SetNotifyUnitSize() fails
  // once a connection exists.
  OStatus SetBufferSize(size_t size);
  size_t GetBufferSize() const;
  OStatus SetNotifyUnitSize(size_t size);
  size_t GetNotifyUnitSize() const;

  // Append data to the next notification for every observer, or for one observer.  The functions
  // with `buf` copy the data; the other functions share the data and add one reference for each
  // observer.  A notification holds at most 13 data items.  If it has 13 items already, SetData()
  // drops the oldest item, adds the new item and returns oFATAL (28).
  OStatus SetData(const void* buf, size_t size);
  OStatus SetData(RCRegion* region);
  OStatus SetData(const OShmPtrBase& ptr);
  OStatus SetData(const OObserverInfo& info, const void* buf, size_t size);
  OStatus SetData(const OObserverInfo& info, RCRegion* region);
  OStatus SetData(const OObserverInfo& info, const OShmPtrBase& ptr);
  OStatus SetData(const ObserverID& id, const void* buf, size_t size);
  OStatus SetData(const ObserverID& id, RCRegion* region);
  OStatus SetData(const ObserverID& id, const OShmPtrBase& ptr);

  // Old forms of SetData() for shared memory that the program itself has made.  They share the
  // first `size` bytes of `region`, or the bytes from the offset in `locator` to the end of its
  // region.  They return oINVALID_ARG if the region does not exist or does not have these bytes.
  OStatus SetData(MemoryRegionID region, size_t size);
  OStatus SetData(const OMemoryLocator& locator);
  OStatus SetData(const ObserverID& id, MemoryRegionID region, u_int size);
  OStatus SetData(const ObserverID& id, const OMemoryLocator& locator);

  OStatus NotifyObservers();
  OStatus NotifyObserver(const OObserverInfo& info);
  OStatus NotifyObserver(const ObserverID& id);

  // Return the number of SetData() calls whose data still fit into the buffer for an observer;
  // without an argument, the smallest such number of all observers.  Return 0 for an unknown id.
  size_t RemainBuffer() const;
  size_t RemainBuffer(const OObserverInfo& info) const;
  size_t RemainBuffer(const ObserverID& id) const;

  OStatus ClearBuffer();
  OStatus ClearBuffer(const OObserverInfo& info);
  OStatus ClearBuffer(const ObserverID& id);

  // Called by the stub, the generated code of the object, when messages of observers arrive.
  OStatus ControlHandler(const OControlMessage& msg, OStatus status = oSUCCESS);
  OStatus ControlHandler(const OControlMessage* msg, OStatus status = oSUCCESS) {
    return ControlHandler(*msg, status);
  }
  OStatus ReadyHandler(const OReadyMessage& msg);
  OStatus ReadyHandler(const OReadyMessage* msg) { return ReadyHandler(*msg); }

  int NumberOfObservers() const;
  ObserverConstIterator begin() const;
  ObserverConstIterator end() const;
  // Finds an observer of this subject by its id; returns end() if the id is unknown.
  ObserverConstIterator FindObserver(const ObserverID& id) const;

  // IsReady() of one observer returns 1 if this observer is ready, else 0.  IsReady() without an
  // argument and IsAnyReady() return the number of observers that are ready.  IsAllReady() returns
  // the same number, but 0 while ReadyStatus() of any observer is 0.
  int IsAllReady() const;
  int IsAnyReady() const;
  int IsReady() const { return IsAnyReady(); }
  int IsReady(const ObserverID& id) const;
  int IsReady(const OObserverInfo& info) const { return IsReady(info.GetObserverID()); }

  // Returns > 0 if the observer is ready, < 0 if it has deasserted ready.  Returns 0 if the id is
  // unknown, or if the observer has neither asserted nor deasserted ready since it was connected or
  // since the last data were sent to it.
  int ReadyStatus(const ObserverID& id) const;
  int ReadyStatus(const OObserverInfo& info) const { return ReadyStatus(info.GetObserverID()); }

 private:
  OSubject(const OSubject&);
  OSubject& operator=(const OSubject&);

  openr_host::SubjectState* state_;  // owned by the runtime
};

#endif  // OPENR_OSUBJECT_H_INCLUDED

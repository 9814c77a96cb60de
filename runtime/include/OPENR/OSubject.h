// OSubject, the sending end of connections.
//
// Each connection has a ready flag.  NotifyObservers() sends all data that were set since the last
// call, as one event, to every observer that is ready, and clears the flag of its connection.  For
// an observer that is not ready, the newest notifications wait: 1, or more if the observer has
// asked for that.  They are sent when the observer's next ready arrives, before the program's Ready
// function runs.  (measured.md, section 1)
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

  // Set the size of the buffer for each observer (by default 14; it holds the data of size - 1
  // SetData() calls), and the number of SetData() calls that are sent as one unit (by default 1).
  // Called in DoInit; SetNotifyUnitSize() fails once a connection exists.
  OStatus SetBufferSize(size_t size);
  size_t GetBufferSize() const;
  OStatus SetNotifyUnitSize(size_t size);
  size_t GetNotifyUnitSize() const;

  // Append data for every observer, or for one observer.  The functions with `buf` copy the data;
  // the other functions share the data and add one reference for each observer.  The 14th datum
  // since the last notification drops the oldest datum, and the status is oFATAL (28).
  OStatus SetData(const void* buf, size_t size);
  OStatus SetData(RCRegion* region);
  OStatus SetData(const OShmPtrBase& ptr);
  OStatus SetData(const OObserverInfo& info, const void* buf, size_t size);
  OStatus SetData(const OObserverInfo& info, RCRegion* region);
  OStatus SetData(const OObserverInfo& info, const OShmPtrBase& ptr);
  OStatus SetData(const ObserverID& id, const void* buf, size_t size);
  OStatus SetData(const ObserverID& id, RCRegion* region);
  OStatus SetData(const ObserverID& id, const OShmPtrBase& ptr);

  // Old forms of SetData() for memory that the program itself made.  They share the memory from its
  // start, or from the locator's offset to the end of the region.  They return oINVALID_ARG if
  // there is no such memory.
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

  // Return the number of observers of this subject that are ready.  IsAllReady() returns 0 while
  // ReadyStatus() of any observer is 0.
  int IsAllReady() const;
  int IsAnyReady() const;
  int IsReady() const { return IsAnyReady(); }
  int IsReady(const ObserverID& id) const;
  int IsReady(const OObserverInfo& info) const { return IsReady(info.GetObserverID()); }

  // Returns > 0 if the observer is ready, < 0 if it has deasserted ready.  Returns 0 if the
  // observer has not asserted ready since the last data were sent to it, or not at all, or if the
  // id is unknown.
  int ReadyStatus(const ObserverID& id) const;
  int ReadyStatus(const OObserverInfo& info) const { return ReadyStatus(info.GetObserverID()); }

 private:
  OSubject(const OSubject&);
  OSubject& operator=(const OSubject&);

  openr_host::SubjectState* state_;  // owned by the runtime
};

#endif  // OPENR_OSUBJECT_H_INCLUDED

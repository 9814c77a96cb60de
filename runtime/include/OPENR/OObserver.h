// OObserver: the receiving end of connections.
#ifndef OPENR_OOBSERVER_H_INCLUDED
#define OPENR_OOBSERVER_H_INCLUDED

#include <OPENR/DataManager.h>
#include <OPENR/MemoryMapAgent.h>
#include <OPENR/OPENREvent.h>
#include <OPENR/OSubjectInfo.h>
#include <OPENR/ObjcommEvent.h>
#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>

namespace openr_host {
struct ObserverState;
}

class OObserver {
 public:
  OObserver();
  ~OObserver();

  // In DoInit: the entry that receives NOTIFY messages; it becomes the ID.
  OStatus SetNotifyEntry(const OServiceEntry& entry);
  const ObserverID& GetID() const;
  const ObserverID& GetObserverID() const { return GetID(); }

  // In DoInit: how each subject buffers for this observer.  Of skip + 1
  // notifications one is kept; nothing is sent before `least` are collected;
  // at most `most` wait for a ready, the newest win.  Defaults 0, 1, 1.
  void SetSkip(size_t skip);
  void SetBufCtrlParam(size_t skip, size_t least, size_t most);

  // To all connected subjects, or to one.  Every region received from the
  // subject that has no reference of the user's own goes back with it.
  OStatus AssertReady();
  OStatus AssertReady(const SubjectID& id);
  OStatus AssertReady(const OSubjectInfo& info) { return AssertReady(info.GetSubjectID()); }
  OStatus DeassertReady();
  OStatus DeassertReady(const SubjectID& id);
  OStatus DeassertReady(const OSubjectInfo& info) { return DeassertReady(info.GetSubjectID()); }

  SubjectConstIterator begin() const;
  SubjectConstIterator end() const;
  int NumberOfSubjects() const;
  SubjectID FindSender(RCRegion* region) const;  // invalid if not received here

  // Called by the stub.
  OStatus ConnectHandler(const OConnectMessage& msg, OStatus status = oSUCCESS);
  OStatus ConnectHandler(const OConnectMessage* msg, OStatus status = oSUCCESS) {
    return ConnectHandler(*msg, status);
  }
  OStatus NotifyHandler(const ONotifyMessage& msg, ONotifyEvent* event);
  OStatus NotifyHandler(const ONotifyMessage* msg, ONotifyEvent* event) {
    return NotifyHandler(*msg, event);
  }

 private:
  OObserver(const OObserver&);
  OObserver& operator=(const OObserver&);

  openr_host::ObserverState* state_;  // belongs to the runtime
};

#endif  // OPENR_OOBSERVER_H_INCLUDED

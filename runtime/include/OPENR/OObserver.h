// OObserver, the receiving end of connections.
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

  // Sets the entry that receives NOTIFY messages; it becomes the id.  Called in DoInit.
  OStatus SetNotifyEntry(const OServiceEntry& entry);
  const ObserverID& GetID() const;
  const ObserverID& GetObserverID() const { return GetID(); }

  // Set how each subject buffers for this observer; called in DoInit.  Of skip + 1 notifications
  // one is kept.  Nothing is sent before `least` of them are collected.  At most `most` wait for a
  // ready; older ones are dropped.  The defaults are 0, 1, 1.
  void SetSkip(size_t skip);
  void SetBufCtrlParam(size_t skip, size_t least, size_t most);

  // Send a ready (assert) or its withdrawal (deassert) to all connected subjects, or to one.  It
  // gives back every region received from the subject to which the program holds no reference.
  OStatus AssertReady();
  OStatus AssertReady(const SubjectID& id);
  OStatus AssertReady(const OSubjectInfo& info) { return AssertReady(info.GetSubjectID()); }
  OStatus DeassertReady();
  OStatus DeassertReady(const SubjectID& id);
  OStatus DeassertReady(const OSubjectInfo& info) { return DeassertReady(info.GetSubjectID()); }

  SubjectConstIterator begin() const;
  SubjectConstIterator end() const;
  int NumberOfSubjects() const;
  SubjectID FindSender(RCRegion* region) const;  // invalid unless this observer holds it

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

  openr_host::ObserverState* state_;  // owned by the runtime
};

#endif  // OPENR_OOBSERVER_H_INCLUDED

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

  // Sets the entry that receives notifications (ONotifyMessage).  This entry becomes the id of the
  // observer.  Called in DoInit.
  OStatus SetNotifyEntry(const OServiceEntry& entry);
  const ObserverID& GetID() const;
  const ObserverID& GetObserverID() const { return GetID(); }

  // Set how each connected subject buffers notifications for this observer; called in DoInit.  The
  // subject keeps one of every skip + 1 notifications and drops the others.  The subject sends
  // nothing before it has kept `least` notifications.  If more than `most` kept notifications wait
  // for a ready, the oldest is dropped.  The defaults are skip 0, least 1 and most 1.
  void SetSkip(size_t skip);
  void SetBufCtrlParam(size_t skip, size_t least, size_t most);

  // Send a ready (assert) or its withdrawal (deassert) to all connected subjects, or to one
  // subject.  The message also gives back the regions that came from the subject, except regions to
  // which the program holds a reference.
  OStatus AssertReady();
  OStatus AssertReady(const SubjectID& id);
  OStatus AssertReady(const OSubjectInfo& info) { return AssertReady(info.GetSubjectID()); }
  OStatus DeassertReady();
  OStatus DeassertReady(const SubjectID& id);
  OStatus DeassertReady(const OSubjectInfo& info) { return DeassertReady(info.GetSubjectID()); }

  SubjectConstIterator begin() const;
  SubjectConstIterator end() const;
  int NumberOfSubjects() const;
  // Returns the subject that has sent `region`, or an invalid id if this observer does not hold the
  // region.
  SubjectID FindSender(RCRegion* region) const;

  // Called by the stub, the generated code of the object, when messages of the object manager or of
  // subjects arrive.
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

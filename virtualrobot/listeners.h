// Streams of the robot go to observers that want them: one that deasserted its ready gets
// nothing, and nothing waits for it, until it asserts again (robot.md, 5.4).
#pragma once

#include <OPENR/OSubject.h>

namespace openr_host {

inline bool HasListener(const OSubject& subject) {
  for (auto observer = subject.begin(); observer != subject.end(); ++observer) {
    if (subject.ReadyStatus(observer->GetObserverID()) >= 0) return true;
  }
  return false;
}

inline void SendToListeners(OSubject* subject, RCRegion* vector) {
  for (auto observer = subject->begin(); observer != subject->end(); ++observer) {
    if (subject->ReadyStatus(observer->GetObserverID()) < 0) continue;
    subject->SetData(observer->GetObserverID(), vector);
    subject->NotifyObserver(observer->GetObserverID());
  }
}

}  // namespace openr_host

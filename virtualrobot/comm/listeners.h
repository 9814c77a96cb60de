// Sends the robot's streams (sensor values, images, sound) to their observers, which are the
// receiving ends of connections.
//
// An observer that has withdrawn its ready receives nothing until it asserts ready again, and no
// vector is kept for it (robot.md, 5.4).
#pragma once

#include <OPENR/OSubject.h>

namespace openr_host {

// Returns whether any observer of `subject` accepts vectors now.
inline bool HasListener(const OSubject& subject) {
  for (auto observer = subject.begin(); observer != subject.end(); ++observer) {
    if (subject.ReadyStatus(observer->GetObserverID()) >= 0) return true;
  }
  return false;
}

// Sends `vector` to all observers of `subject` that accept vectors now.
inline void SendToListeners(OSubject* subject, RCRegion* vector) {
  for (auto observer = subject->begin(); observer != subject->end(); ++observer) {
    if (subject->ReadyStatus(observer->GetObserverID()) < 0) continue;
    subject->SetData(observer->GetObserverID(), vector);
    subject->NotifyObserver(observer->GetObserverID());
  }
}

}  // namespace openr_host

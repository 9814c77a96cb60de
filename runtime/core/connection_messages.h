// Handles messages between subjects (OSubject, the sending end of connections) and observers
// (OObserver, the receiving end) that neither end handles itself.  These are messages with wrong
// bytes, refused messages, and messages that the runtime sends in place of an observer.
#pragma once

#include <OPENR/ObjcommMessages.h>

#include <cstdint>
#include <vector>

#include "runtime/core/message.h"
#include "runtime/core/object.h"

namespace openr_host {

// Adds an error finding: an entry of a subject or observer of `object` has received bytes that are
// neither a notification nor a ready.
void ReportForeignBytes(const Object& object);

// Returns whether the message that `object` handles is of this `kind` (a notification or a ready),
// and so was sent by an OSubject or OObserver.  If an object has sent other bytes to the entry of a
// subject or observer, adds an error finding and returns false.  The caller must not read these
// bytes as a notification or a ready.
inline bool IsRunningMessage(const Object& object, PayloadKind kind) {
  // If `object` handles no message now, returns true, because no message has a wrong kind.  This
  // occurs only if a test calls the function of the entry directly.
  if (object.running() == nullptr || object.running()->kind == kind) [[likely]]
    return true;
  ReportForeignBytes(object);
  return false;
}

// The message type of a deassert that the runtime sends in the name of an observer that no longer
// receives, because its process has ended or its object is being replaced.  No message type of the
// SDK has this value.
constexpr OMessageType kDeassertOfLost = 0x10000;

// The message type of the connect message that an observer gets in place of an ordinary one if the
// process of the subject is lost.  The observer then sends nothing to the subject, and only records
// that the subject is missing (ObserverState::missing).  No message type of the SDK has this value.
constexpr OMessageType kConnectToLost = 0x10001;

// Sends `subject` a deassert, which says that the observer at entry `selector` of `object` is not
// ready.  The deassert also gives back `regions`, at most MAX_NUM_DATA, which the subject had sent
// to this observer.
void SendDeassert(Object* object, uint32_t selector, const SubjectID& subject,
                  const std::vector<RCRegion*>& regions);
// Handles a notification to `object` that will not be delivered.  Gives the regions of `message`
// back to the subject with SendDeassert(), so that the subject can use them again.
void RefuseNotification(Object* object, const Message& message);
// Handles `message`, a notification or a ready that was refused when it left the outbox of its
// `sender` (cpu.h).  The function that has sent `message` has already returned success.
//
// Makes the data of a notification pending again, as if Send() had failed.  If that is not possible
// (TakenBack), gives the regions of the notification back to the subject.  Drops the command of a
// ready, but gives back the regions in the ready.
void HandleLateRefusal(Object* sender, const Message& message);

}  // namespace openr_host

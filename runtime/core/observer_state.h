// ObserverState: the runtime's record of an observer (OObserver, the receiving end of connections).
//
// The record lies on the host's heap and not on the object's heap, so it takes no memory of the
// robot.  Only handlers of the object change it.
#pragma once

#include <OPENR/OObserver.h>
#include <OPENR/ObjcommMessages.h>

#include <cstddef>
#include <functional>
#include <list>
#include <string>
#include <vector>

#include "runtime/core/message.h"
#include "runtime/core/object.h"

namespace openr_host {

class System;

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
    ObjectId target = kNoObject;  // the object that has `subject`, to which ready messages go
    // The regions that this observer has received from the subject and has not given back yet,
    // oldest first.
    std::vector<RCRegion*> regions;
    // Number of readies that the observer has asserted to the subject without a deassert or a
    // notification in between.  A large number becomes a finding (ReportRepeatedReady()).
    // Notifications of all subjects set the number to 0, not only those of this subject, because
    // many programs call AssertReady() without argument after each notification, which asserts
    // ready to all subjects.
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
    // subject was missing; objcommCMD_UNDEF if it has given none.  The program does not know that
    // the subject was missing, and so does not repeat the command.  So the observer sends the
    // command as soon as the subject is connected.
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

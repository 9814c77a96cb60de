// CodeObject: the base class of objects that are C++ classes of this program and are not loaded
// from files.  Such objects are parts of the robot, probes of tests and load generators.
//
// A CodeObject sends and receives messages like an object from a file (an image).  Only the table
// of entries, the functions that are called for messages, is different: an image has a table in its
// file, a CodeObject makes the table itself.
//
//   class Blinker : public CodeObject {
//    public:
//     Blinker() {
//       blink_ = AddSubject("Blinker.Blink.OCommandVectorData.S",
//                           [this](const OReadyEvent& event) { Ready(event); });
//     }
//   };
//   system.AddObject<Blinker>(dog, "blinker");
#pragma once

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/object.h"

namespace openr_host {

class CodeObject : public OObject {
 public:
  CodeObject();
  ~CodeObject() override;

  // Adds to the hash all state of this object that can change what happens later in the run; see
  // Object::HashState().
  virtual void HashState(Hasher*) const {}

  Object& host() const { return *host_; }
  System& system() const { return *host_->system; }

 protected:
  using Ready = std::function<void(const OReadyEvent&)>;
  using Notify = std::function<void(const ONotifyEvent&)>;
  using Extra = std::function<void(void* message)>;

  // Add a subject (sending end of connections) or an observer (receiving end) and register it as
  // `service`, a full name such as "Blinker.Blink.OCommandVectorData.S".  `ready` or `notify` is
  // called for each ready or notification and may be empty.  This CodeObject owns the returned
  // subject or observer.  REQUIRES: called in the constructor.
  OSubject* AddSubject(const std::string& service, Ready ready = {});
  OObserver* AddObserver(const std::string& service, Notify notify = {});

  // Adds an entry that calls `extra` with the bytes of each message that it receives.  Returns the
  // entry's selector, the number that senders must give.
  Selector AddExtra(const std::string& name, Extra extra);

 private:
  friend class CodeHost;
  using EntryFunction = std::function<void(void*)>;

  Object* const host_;
  std::vector<EntryFunction> entries_;  // entry functions; the index is selector - oentryBASE
  std::vector<std::unique_ptr<OSubject>> own_subjects_;
  std::vector<std::unique_ptr<OObserver>> own_observers_;
};

// The Object that runs a CodeObject: calls its functions when messages arrive.
class CodeHost : public Object {
 public:
  using Object::Object;
  ~CodeHost() override;

  bool HasEntry(uint32_t selector) const override;
  bool Dispatch(uint32_t selector, void* payload) override;
  void HashState(Hasher* hasher) const override;

  std::unique_ptr<CodeObject> code;
};

}  // namespace openr_host

// Objects built in code: parts of the robot, test probes, load generators.
//
// They use the same subjects, observers and messages as objects from images.  Only the entry table
// differs: an image gets its table from its stub, a CodeObject makes its own.
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

  // Adds the state that decides the future; see Object::HashState().
  virtual void HashState(Hasher*) const {}

  Object& host() const { return *host_; }
  System& system() const { return *host_->system; }

 protected:
  using Ready = std::function<void(const OReadyEvent&)>;
  using Notify = std::function<void(const ONotifyEvent&)>;
  using Extra = std::function<void(void* message)>;

  // Add a subject or an observer and register it as `service`, a full name of four parts.  `ready`
  // or `notify` is called for each ready or notification and may be empty.  This object owns the
  // returned subject or observer.  REQUIRES: called in the constructor.
  OSubject* AddSubject(const std::string& service, Ready ready = {});
  OObserver* AddObserver(const std::string& service, Notify notify = {});

  // Adds an entry that accepts any message, and returns its selector.
  Selector AddExtra(const std::string& name, Extra extra);

 private:
  friend class CodeHost;
  using EntryFunction = std::function<void(void*)>;

  Object* const host_;
  std::vector<EntryFunction> entries_;  // entry functions; the index is selector - oentryBASE
  std::vector<std::unique_ptr<OSubject>> own_subjects_;
  std::vector<std::unique_ptr<OObserver>> own_observers_;
};

// The runtime's Object for a CodeObject.
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

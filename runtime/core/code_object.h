// CodeObject: the base class of objects that are C++ classes of this program and are not loaded
// from files.  They are parts of the robot, probes of tests, or load generators.
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

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/object.h"

namespace openr_host {

// An entry of a CodeObject, which handles the messages to one selector.  The classes derived from
// CodeEntry store the function that the CodeObject has given for the entry.  So a message reaches
// this function by one virtual call.
class CodeEntry {
 public:
  virtual ~CodeEntry() = default;
  virtual void Handle(void* message) = 0;

  // The record of the subject or of the observer that handles the messages of this entry; null if
  // the entry has no subject, or no observer.  PrefetchDeliveries() loads this record into the
  // cache.
  const SubjectState* subject_state = nullptr;
  const ObserverState* observer_state = nullptr;
};

class CodeObject : public OObject {
 public:
  CodeObject();
  ~CodeObject() override;

  // Adds to the state hash all state of this object that can change what happens later in the run;
  // see Object::HashState().
  virtual void HashState(Hasher*) const {}

  Object& host() const { return *host_; }
  System& system() const { return *host_->system; }

 protected:
  // A function object that ignores the message.  Used for entries whose messages the object need
  // not handle.
  struct IgnoreMessage {
    template <typename T>
    void operator()(const T&) const {}
  };

  // Adds a subject (the sending end of connections) and registers it as `service`, a full name such
  // as "Blinker.Blink.OCommandVectorData.S".  `ready(const OReadyEvent&)` is called for each ready
  // that the subject gets.  This CodeObject owns the returned subject.  REQUIRES: called in the
  // constructor.
  template <typename Ready = IgnoreMessage>
  OSubject* AddSubject(const std::string& service, Ready ready = {});
  // Adds an observer (the receiving end of connections) and registers it as `service`.
  // `notify(const ONotifyEvent&)` is called for each notification.  This CodeObject owns the
  // returned observer.  REQUIRES: called in the constructor.
  template <typename Notify = IgnoreMessage>
  OObserver* AddObserver(const std::string& service, Notify notify = {});

  // Adds an entry that calls extra(void* message) with the bytes of each message that it receives.
  // Returns the entry's selector, the number that senders must give.
  template <typename Extra = IgnoreMessage>
  Selector AddExtra(const std::string& name, Extra extra) {
    return AddEntry(name, std::make_unique<ExtraEntry<Extra>>(std::move(extra)));
  }

 private:
  friend class CodeHost;

  template <typename Extra>
  class ExtraEntry final : public CodeEntry {
   public:
    explicit ExtraEntry(Extra extra) : extra_(std::move(extra)) {}
    void Handle(void* message) override { extra_(message); }

   private:
    Extra extra_;
  };

  // The entry of a subject.  Passes each ready message to `subject`, a member of this class, then
  // calls `ready_`, the function that the object has given to AddSubject().
  template <typename Ready>
  class ReadyEntry final : public CodeEntry {
   public:
    ReadyEntry(int index, Ready ready) : index_(index), ready_(std::move(ready)) {}
    void Handle(void* message) override {
      const auto& ready = *static_cast<OReadyMessage*>(message);
      subject.ReadyHandler(ready);
      ready_(OReadyEvent(index_, ready.observerID, ready.command));
    }
    OSubject subject;

   private:
    const int index_;
    Ready ready_;
  };

  // The entry of an observer.  Passes each notification to `observer`, a member of this class, then
  // calls `notify_`, the function that the object has given to AddObserver().
  template <typename Notify>
  class NotifyEntry final : public CodeEntry {
   public:
    NotifyEntry(int index, Notify notify) : index_(index), notify_(std::move(notify)) {}
    void Handle(void* message) override {
      ONotifyEvent event;
      event.SetIndex(index_);
      observer.NotifyHandler(*static_cast<ONotifyMessage*>(message), &event);
      notify_(event);
    }
    OObserver observer;

   private:
    const int index_;
    Notify notify_;
  };

  Selector AddEntry(const std::string& name, std::unique_ptr<CodeEntry> entry);
  // Adds the two entries of a subject: an entry for control events, by which observers are added
  // and removed, and `entry` for readies.
  void AddSubjectEntries(const std::string& service, OSubject* subject,
                         std::unique_ptr<CodeEntry> entry);
  // Adds the two entries of an observer: an entry for connect events, by which the observer is
  // connected to a subject, and `entry` for notifications.
  void AddObserverEntries(const std::string& service, OObserver* observer,
                          std::unique_ptr<CodeEntry> entry);

  Object* const host_;
  // Index of an entry: its selector minus oentryBASE.
  std::vector<std::unique_ptr<CodeEntry>> entries_;
  int subject_count_ = 0;
  int observer_count_ = 0;
};

template <typename Ready>
OSubject* CodeObject::AddSubject(const std::string& service, Ready ready) {
  auto entry = std::make_unique<ReadyEntry<Ready>>(subject_count_++, std::move(ready));
  OSubject* const subject = &entry->subject;
  AddSubjectEntries(service, subject, std::move(entry));
  return subject;
}

template <typename Notify>
OObserver* CodeObject::AddObserver(const std::string& service, Notify notify) {
  auto entry = std::make_unique<NotifyEntry<Notify>>(observer_count_++, std::move(notify));
  OObserver* const observer = &entry->observer;
  AddObserverEntries(service, observer, std::move(entry));
  return observer;
}

// The Object that runs a CodeObject: calls the function of the CodeObject's entry when a message
// arrives.
class CodeHost final : public Object {
 public:
  using Object::Object;
  ~CodeHost() override;

  bool HasEntry(uint32_t selector) const override;
  bool Dispatch(uint32_t selector, void* payload) override;
  void HashState(Hasher* hasher) const override;

  // Sets the CodeObject that this object runs.  Called after the constructor of the CodeObject,
  // because this function counts the entries that the constructor adds.
  void SetCode(std::unique_ptr<CodeObject> made);

  std::unique_ptr<CodeObject> code;

 private:
  void CallSystemEntry(uint32_t selector, void* payload);
};

// Returns the entry of a CodeObject that `object` runs; null if `object` is no CodeHost or its code
// has no entry `selector`.
inline CodeEntry* FindCodeEntry(const Object& object, uint32_t selector) {
  if (object.code_entries() == nullptr || selector < oentryBASE || selector >= object.entry_count())
    return nullptr;
  return object.code_entries()[selector - oentryBASE].get();
}

}  // namespace openr_host

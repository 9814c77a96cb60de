// Object: what a System knows about one OPEN-R object, which is a program of the robot.
#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/core/delivery_state.h"
#include "runtime/core/early_work.h"
#include "runtime/core/entry_names.h"
#include "runtime/core/library_state.h"
#include "runtime/core/message.h"
#include "runtime/core/number_faults.h"
#include "runtime/core/object_memory.h"
#include "runtime/core/object_statistics.h"
#include "runtime/core/processor_state.h"
#include "runtime/core/reply_boxes.h"
#include "runtime/core/wait_state.h"

class RCRegion;

namespace openr_host {

class CodeEntry;
class Hasher;
class System;
struct ObserverState;
struct SubjectState;

// Values of an object's .ocf file, the file with its name, priority and memory sizes.
struct ObjectLimits {
  int priority = 128;        // 0 to 255; the upper four bits are the priority class
  uint32_t stack_bytes = 0;  // size of the object's stack; 0 if it is not known
  uint32_t heap_bytes = 0;   // step by which the object's heap grows on the robot
};

// The largest number of entries that an object can have on the robot.
constexpr uint32_t kSelectorMax = 64;

// An observer that is ready for a subject of another object.
struct StandingReady {
  uint32_t ready_selector;  // selector of the subject's entry for readies
  ObjectId observer;
  uint32_t notify_selector;  // selector of the observer's entry for notifications

  auto operator<=>(const StandingReady&) const = default;
};

// The result of Object::TakeBack().
enum class TakenBack {
  kPending,     // the data of the notification wait again in the subject
  kNoObserver,  // the subject is not connected with the observer any more
  kNoSubject,   // the subject's process is lost or runs freely
};

// The memory for the reply when an object calls an entry of its own directly and not by a message.
// An object does this to connect one of its subjects with one of its observers, or to disconnect
// them.
struct SelfReply {
  void* data;
  size_t size;
  uint32_t selector;  // the entry that is called
};

// The files of the stick that the code of one image has open.
class OpenFiles {
 public:
  struct File {
    std::string path;  // path of the open file on the host
    bool writes = false;
    std::string name = {};  // path of the file on the stick, as the object has given it
    bool has_lost = false;  // whether there is a finding about a failed write
  };

  void CloseAll();

  // The keys are addresses, which differ from run to run, so nothing may depend on the order of
  // `streams`, the files that code of the image has opened with fopen().
  std::map<std::FILE*, File> streams;
  std::map<int, File> descriptors;
  // The standard input of the object; null until the object reads from the console.
  std::FILE* terminal = nullptr;
};

class Object {
 public:
  Object(System* system, ObjectId id, int robot, bool is_image = false);
  virtual ~Object();
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  // Calls entry `selector` with `payload`, the address of the message's bytes.  Returns false if
  // the object has no such entry.
  virtual bool Dispatch(uint32_t selector, void* payload) = 0;

  // Adds to the state hash all state of the object that can change what happens later in the run,
  // except regions, queues and ready flags, which System::state_hash() adds.  Images add nothing:
  // their memory is never hashed, because it may hold addresses.
  virtual void HashState(Hasher*) const {}

  // Returns the name of entry `selector` for traces and messages: "DoStart", "Mover (Notify)".
  std::string EntryName(uint32_t selector) const { return entry_names_.TextOf(selector); }
  const EntryNames& entry_names() const { return entry_names_; }
  EntryNames& entry_names() { return entry_names_; }

  // Returns the observers that are ready for the subjects of this object.  If this object is
  // replaced, their readies are sent again to its successor.
  virtual std::vector<StandingReady> StandingReadies() const;

  // Returns the number of notifications that wait in the subjects of this object, because their
  // observers are not ready.
  uint64_t CountPending() const;

  // Gives a region back to the subject of this object that has sent it, because the observer cannot
  // give it back with a ready.  Does nothing if this object is being replaced (is_leaving()),
  // because its regions end with it.
  virtual void ReturnRegion(RCRegion* region);

  // Makes the data of `message` pending again in the subject of this object that has sent them.
  // `message` is a notification that was refused after NotifyObservers() had returned success.
  virtual TakenBack TakeBack(const Message& message);

  // Counts `message`, a message to this object that will not be delivered.  If it is a
  // notification, gives its regions back to the subject.
  virtual void HandleUndelivered(const Message& message);

  // Puts the messages that the object could not handle yet back at the front of the queue, because
  // they are older than all messages due now.
  void ReturnHeld();

  // Returns whether a given address lies in the code of the image from which the object was loaded.
  // Always false for an object that was not loaded from a file.
  virtual bool HasCode(const void*) const { return false; }

  // Returns whether the object has an entry `selector`.
  virtual bool HasEntry(uint32_t selector) const = 0;

  // Gives entry `selector` of this object a name for traces: the name of a service, followed by
  // `kind`, which is "Ready" or "Notify".  Returns the full name of the service.  REQUIRES: the
  // Control or Connect entry of the service runs now, because this function finds the service by
  // the running entry.
  std::string NameService(uint32_t selector, const char* kind);

  // ---- Parts of the object

  // The subjects and observers of the object, which owns them.  Both lists only grow.  AddSubject()
  // and AddObserver() return the address of the new element.
  const std::vector<std::unique_ptr<SubjectState>>& subjects() const { return subjects_; }
  const std::vector<std::unique_ptr<ObserverState>>& observers() const { return observers_; }
  SubjectState* AddSubject(std::unique_ptr<SubjectState> subject);
  ObserverState* AddObserver(std::unique_ptr<ObserverState> observer);

  OpenFiles& files() { return files_; }

  const ReplyBoxes& boxes() const { return boxes_; }
  ReplyBoxes& boxes() { return boxes_; }

  const WaitState& wait() const { return wait_; }
  WaitState& wait() { return wait_; }

  const ProcessorState& processor() const { return processor_; }
  ProcessorState& processor() { return processor_; }

  const ObjectStatistics& statistics() const { return statistics_; }
  ObjectStatistics& statistics() { return statistics_; }

  const ObjectMemory& memory() const { return memory_; }
  ObjectMemory& memory() { return memory_; }

  const NumberFaults& number_faults() const { return number_faults_; }
  NumberFaults& number_faults() { return number_faults_; }

  // Returns the next number of the object's own rand().  Every object has a generator of its own,
  // so its numbers do not depend on how often other objects call rand().  All generators start with
  // seed 1, like the generator of the C library.
  int NextRandom();
  void SeedRandom(uint32_t seed) { random_state_ = seed; }
  LibraryState& library_state() { return library_state_; }

  // ---- The delivery of messages

  // Returns whether the object was loaded from a file (an image).
  bool is_image() const { return is_image_; }

  const ObjectLimits& limits() const { return limits_; }
  void set_limits(const ObjectLimits& limits) { limits_ = limits; }
  void set_priority(int priority) { limits_.priority = priority; }

  // The reasons why a message may not be passed to the handler at once.
  const DeliveryState& delivery() const { return delivery_; }
  DeliveryState& delivery() { return delivery_; }
  // Returns whether the delivery of a message needs only a call of its handler (PlainFlag).
  bool is_plain() const { return static_cast<bool>(is_plain_); }

  // Returns the class of the messages that the object posts.  The order of delivery compares the
  // classes of messages first, then the priorities of their receivers.
  MessageClass post_class() const { return post_class_; }
  void set_post_class(MessageClass post_class) { post_class_ = post_class; }

  // Returns the number of messages to the object, except replies, that are not delivered yet.
  int waiting() const { return waiting_; }
  int waiting_max() const { return waiting_max_; }  // the highest value of waiting() so far
  int queue_max() const { return queue_max_; }      // the limit of waiting()
  void set_queue_max(int messages) { queue_max_ = messages; }
  bool IsQueueFull() const { return waiting_ >= queue_max_; }
  // Counts one more message (not a reply) that the object will receive.
  void NoteQueued() { waiting_max_ = std::max(waiting_max_, ++waiting_); }
  // Counts messages that wait no longer, because they are delivered now or will never be.
  // REQUIRES: NoteQueued() has counted them.
  void NoteTaken(int count = 1) {
    waiting_ -= count;
    ASSERT(waiting_ >= 0, "{} has fewer waiting messages than were taken", name);
  }

  // Returns the number of messages delivered to the object.
  uint64_t message_count() const { return message_count_; }
  void NoteDelivered() {
    ++message_count_;
    passed_us_ = 0;
  }

  // The object has all entries from 0 to entry_count() - 1.  For a larger selector, HasEntry() must
  // be called to find out whether the object has the entry.
  uint32_t entry_count() const { return entry_count_; }
  // Returns the entries of a CodeHost (code_object.h): the entry with selector oentryBASE + i is
  // code_entries()[i].  Null for other objects.
  const std::unique_ptr<CodeEntry>* code_entries() const { return code_entries_; }
  void set_code_entries(const std::unique_ptr<CodeEntry>* entries) { code_entries_ = entries; }

  // Returns the address of the cache line that has all members that the delivery of every message
  // reads.
  const void* delivery_line() const { return &entry_count_; }

  // ---- The handler that runs

  // Returns the message being handled; null if no handler runs.
  Message* running() const { return running_.get(); }
  // Makes the object handle `message`, which it owns from now on.  REQUIRES: no handler runs.
  void BeginHandler(Message* message) {
    ASSERT(running_ == nullptr, "{} runs one handler at a time", name);
    running_.reset(message);
  }
  void EndHandler() { running_.reset(); }

  // Returns the time that has passed in this handler.  Each call of GetSystemTime() adds 1 us, so
  // that a loop that waits for a certain time ends.  Each call of Wait() (MCOOP.h) adds the time of
  // the wait.
  uint64_t passed_us() const { return passed_us_; }
  // Returns how often the handler has called GetSystemTime().
  uint64_t time_calls() const { return passed_us_ - waited_us_; }
  // Adds 1 us for a call of GetSystemTime() to the time that has passed in this handler.
  // NoteWait() adds the time of a call of Wait().
  void NoteTimeCall() { PassTime(1, 0); }
  void NoteWait(uint64_t us) { PassTime(us, us); }

  // Returns the memory for the reply when the object calls an entry of its own directly; null at
  // all other times.
  const SelfReply* self_reply() const { return self_reply_; }
  void set_self_reply(SelfReply* reply) { self_reply_ = reply; }

  // ---- The life of the object

  // Returns whether the object is a part of the robot and not of the application.
  bool is_system() const { return is_system_; }
  void set_system(bool is_system) { is_system_ = is_system; }

  // Returns whether the worker process with the code of the object was lost while the run goes on.
  // No handler of the object runs then until ObjectTable::PostReplacement() replaces the object.
  // The loss is already a finding, so the failures that follow from the loss are not reported.
  bool is_lost() const { return is_lost_; }
  void set_lost(bool is_lost) { is_lost_ = is_lost; }

  // Returns whether this object only stands for an object whose robot was switched off, and so has
  // no code.  When the robot boots, the object with the same path (or with the same name, if it has
  // no path) gets this id again.
  bool is_absent() const { return is_absent_; }

  // Returns whether another object is about to replace this object.
  bool is_leaving() const { return is_leaving_; }
  // Records that another object is about to replace this object.  REQUIRES: called once.
  void BeginReplacement();

  // Returns the number of objects that had this id before this object.  When the number changes,
  // traces know that the names of the entries may have changed.
  int predecessors() const { return predecessors_; }
  // Copies the statistics of the object `old`, which this object replaces, because the report
  // counts both objects as one.  Gives the next reply box a higher number than all reply boxes of
  // `old` have.  REQUIRES: `old` has the same id; called once.
  void Succeed(const Object& old);

  // Keeps what the constructors of this image did while the image was loaded to replace an object
  // with the same id (early_work.h).  REQUIRES: !has_early_work().
  void KeepEarlyWork(EarlyWork work);
  // Returns whether KeepEarlyWork() has kept something that TakeEarlyWork() has not returned yet.
  bool has_early_work() const { return has_early_work_; }
  EarlyWork TakeEarlyWork();
  // Adds `service` at entry `selector` to the early work.  Returns false if the early work has this
  // service already.  REQUIRES: has_early_work().
  bool KeepEarlyService(const std::string& service, uint32_t selector);

  System* const system;
  const ObjectId id;
  const int robot;
  std::string name;  // OBJECT_NAME of the .ocf file, unique per robot
  std::string path;  // /MS/... of an image; empty for objects built in code

 protected:
  void set_absent() { is_absent_ = true; }
  // Sets the number of the object's first entries without a gap; see entry_count().
  void set_entry_count(uint32_t count) { entry_count_ = count; }

 private:
  // The size of a line of the processor's cache.
  static constexpr size_t kLineBytes = 64;

  void PassTime(uint64_t us, uint64_t wait_us) {
    if (passed_us_ == 0) waited_us_ = 0;
    passed_us_ += us;
    waited_us_ += wait_us;
  }

  OpenFiles files_;
  ReplyBoxes boxes_;
  WaitState wait_;
  ProcessorState processor_;
  ObjectMemory memory_;  // must outlive the members below, which may use its heap
  std::vector<std::unique_ptr<SubjectState>> subjects_;
  std::vector<std::unique_ptr<ObserverState>> observers_;
  bool is_system_ = false;
  bool is_leaving_ = false;
  bool is_lost_ = false;
  bool is_absent_ = false;
  int predecessors_ = 0;
  bool has_early_work_ = false;
  EarlyWork early_work_;
  uint32_t random_state_ = 1;
  LibraryState library_state_;
  NumberFaults number_faults_;
  EntryNames entry_names_;
  ObjectStatistics statistics_;
  SelfReply* self_reply_ = nullptr;
  uint64_t waited_us_ = 0;  // no meaning while passed_us_ is 0
  DeliveryState delivery_;

  // ---- The members of Object that the delivery of every message reads.  They lie on one cache
  // line, because with thousands of objects a delivery spends most of its time waiting for memory.

  alignas(kLineBytes) uint32_t entry_count_ = 0;
  int waiting_ = 0;
  int queue_max_ = 32;  // field-notes.md, 2.3
  int waiting_max_ = 0;
  ObjectLimits limits_;
  MessageClass post_class_ = MessageClass::kObject;
  const bool is_image_;
  DeliveryState::PlainFlag is_plain_{delivery_};
  uint64_t message_count_ = 0;
  OwnedMessage running_;
  uint64_t passed_us_ = 0;
  const std::unique_ptr<CodeEntry>* code_entries_ = nullptr;
};

}  // namespace openr_host

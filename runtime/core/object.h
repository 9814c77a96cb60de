// The system's side of one OPEN-R object.
#pragma once

#include <compare>
#include <cstdio>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "runtime/core/address_plan.h"
#include "runtime/core/arena.h"
#include "runtime/core/fiber.h"
#include "runtime/core/fp_flags.h"
#include "runtime/core/message.h"

class RCRegion;

namespace openr_host {

class Hasher;
class System;
struct ObserverState;
struct SubjectState;

// The values of an .ocf file that the host uses.
struct ObjectLimits {
  int priority = 128;        // 0 to 255; the upper four bits are the priority class
  uint32_t stack_bytes = 0;  // 0: unknown
  uint32_t heap_bytes = 0;
};

// the largest number of entries that an object can have on the robot
constexpr uint32_t kSelectorMax = 64;

// An observer that is ready for a subject of some other object.
struct StandingReady {
  uint32_t ready_selector;  // selector of the subject's entry for readies
  ObjectId observer;
  uint32_t notify_selector;

  auto operator<=>(const StandingReady&) const = default;
};

// The handler of an object that runs or waits.
struct HandlerState {
  OwnedMessage running;  // the message being handled; null: no handler runs
  // calls of GetSystemTime() in this handler; each call adds 1 us to the time
  uint64_t time_calls = 0;
  Fiber* blocked = nullptr;      // the stack of the handler while it waits; null: it does not wait
  uint64_t blocked_box = 0;      // the reply box for which the handler waits
  int64_t blocked_since_us = 0;  // virtual time when the wait began
  // what the handler waits for, in words: "the answer of IPStack (Send)"
  std::string blocked_why;
  // Messages that the object cannot handle yet, oldest first.  The reason is that its handler waits
  // or has the processor, or the boot (ObjectManager::IsTooEarly()).
  std::deque<OwnedMessage> held;
  // The memory for the reply when an object calls an entry of its own (self connection).
  struct SelfReply {
    void* data;
    size_t size;
    uint32_t selector;  // the entry that is called
  };
  SelfReply* self_reply = nullptr;
};

// The numbered boxes in which an object receives replies; see requests.h.
struct ReplyBoxes {
  uint64_t last = 0;                         // the number of the newest box
  std::set<uint64_t> open;                   // boxes whose reply may come or has come
  std::map<uint64_t, OwnedMessage> arrived;  // replies that no handler has received yet
};

// The object's use of the robot's processor, if handlers take time; see cpu.h.
struct ProcessorState {
  bool is_busy = false;  // a handler of the object has the processor
  // virtual time since when a message has waited for the processor; -1: none waits
  int64_t starving_since_us = -1;
  struct Outgoing {
    OwnedMessage message;
    int64_t delay_us;
  };
  std::vector<Outgoing> outbox;  // messages that are sent when the time of the handler is over
};

// The files of the stick that the code of one image has open.
class OpenFiles {
 public:
  struct File {
    std::string path;  // on the host
    bool writes = false;
  };

  void CloseAll();

  // The keys are addresses, which differ from run to run, so the order of `streams` must not decide
  // anything.
  std::map<std::FILE*, File> streams;
  std::map<int, File> descriptors;
  // standard input, after the object has read from the console; null before
  std::FILE* terminal = nullptr;
};

class Object {
 public:
  Object(System* system, ObjectId id, int robot);
  virtual ~Object();
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  // Calls entry `selector` with `payload`, the address of the message's bytes.  Returns false if
  // the object has no such entry.
  virtual bool Dispatch(uint32_t selector, void* payload) = 0;

  // Adds to the hash all state of the object that can change what happens later in the run, except
  // regions, queues and ready flags, which System::state_hash() adds.  Images add nothing, because
  // their memory is never hashed.
  virtual void HashState(Hasher*) const {}

  // Returns the name of entry `selector` for traces and messages: "DoStart", "Mover (Notify)".
  std::string EntryName(uint32_t selector) const;

  // Returns the observers that are ready for the subjects of this object.  If the object is
  // replaced, their readies are sent again to its successor.
  virtual std::vector<StandingReady> StandingReadies() const;

  // Takes back a region that a subject of this object had sent to an observer.  Called while this
  // object is being replaced.
  virtual void ReturnRegion(RCRegion*) {}

  // Counts a queued `message` to this object that will not be delivered.  If it is a notification,
  // gives its regions back to the subject.
  virtual void HandleUndelivered(const Message& message);

  // Puts the held messages back at the front of the queue, because they are older than all messages
  // due now.
  void ReturnHeld();

  // Returns whether the object's code was in a worker process that has ended.  That end is a
  // finding already, so its consequences are not reported too.
  virtual bool IsLost() const { return false; }

  // Returns whether a handler of the object runs in another process now.  That process takes wall
  // time, so virtual time does not tell how long the handler takes.
  virtual bool IsAtWorkElsewhere() const { return false; }

  // Returns whether `address` is an instruction of the object's image.
  virtual bool HasCode(const void*) const { return false; }

  // Returns whether the object has an entry `selector`.
  virtual bool HasEntry(uint32_t selector) const = 0;

  // Names entry `selector` after the service and `kind` ("Ready" or "Notify"), and returns the full
  // name of the service.  Called in the Control or Connect entry of a service.
  std::string NameService(uint32_t selector, const char* kind);

  System* const system;
  const ObjectId id;
  const int robot;
  std::string name;         // OBJECT_NAME of the .ocf file, unique per robot
  std::string path;         // /MS/... of an image; empty for objects built in code
  bool is_image = false;    // loaded from a file; its code sees only the Memory Stick
  bool is_system = false;   // part of the robot, not of the application
  bool is_off = false;      // the object's robot is off: messages to the object are dropped
  bool is_leaving = false;  // another object is about to replace this one
  ObjectLimits limits;
  // the class of the messages that the object posts
  MessageClass post_class = MessageClass::kObject;

  // Statistics for the report of the run.
  std::string state;           // text after "state: " of its last OSYSLOG1 INFO line
  uint64_t message_count = 0;  // messages delivered
  uint64_t dropped_count = 0;  // data replaced before they were read, and messages refused
  // number of messages to the object that are not delivered yet, without replies
  int waiting = 0;
  int queue_max = 32;          // limit of `waiting` (field-notes.md, 2.3); see SetResourceValue()
  int waiting_max = 0;         // the highest value of `waiting` so far
  int64_t handler_ns_max = 0;  // longest handler, wall time; 0 without SystemOptions::wall_clock_ns
  size_t stack_max = 0;        // most bytes that a handler used; see SystemOptions::measure_stacks

  // The blocks that NewRegion() has returned to this object.  The order of the set must not decide
  // anything, because addresses differ from run to run.
  std::set<void*> private_regions;

  uint32_t random_state = 1;  // the state of rand()

  // For each FpFlag (index: bit number of the flag), the instruction that first raised the flag,
  // set by CrashLog.  Null: no instruction raised the flag, or the instruction is not known.
  const void* number_faults[kFpKinds] = {};
  // True if checked_code.cc has reported, in the running handler, the conversion of a number that
  // is too large for its integer type.
  bool has_reported_cast = false;

  OpenFiles files;
  HandlerState handler;
  ReplyBoxes boxes;
  ProcessorState processor;

  // Set only for images, and only where addresses are planned.
  std::unique_ptr<AddressPlace> place;
  std::unique_ptr<Arena> arena;
  std::vector<std::unique_ptr<SubjectState>> subjects;
  std::vector<std::unique_ptr<ObserverState>> observers;
  std::map<uint32_t, std::string> entry_names;
  std::map<uint32_t, std::string> services;  // selector registered -> full service name
};

}  // namespace openr_host

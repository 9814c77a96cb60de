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
  int priority = 128;        // 0..255; the upper four bits are the class
  uint32_t stack_bytes = 0;  // 0: unknown
  uint32_t heap_bytes = 0;
};

constexpr uint32_t kSelectorMax = 64;  // the most entries that an object can have on the robot

// An observer that is ready for a subject.
struct StandingReady {
  uint32_t ready_selector;  // of the subject
  ObjectId observer;
  uint32_t notify_selector;

  auto operator<=>(const StandingReady&) const = default;
};

// The handler of an object that runs or waits.
struct HandlerState {
  Message* running = nullptr;    // the message being handled; null: no handler runs
  uint64_t time_calls = 0;       // calls of GetSystemTime() in this handler; each adds 1 us to it
  Fiber* blocked = nullptr;      // the stack of the handler while it waits; null: it does not wait
  uint64_t blocked_box = 0;      // the reply box it waits for
  int64_t blocked_since_us = 0;  // virtual time
  std::string blocked_why;       // what it waits for, in words: "the answer of IPStack (Send)"
  // Messages that the object cannot handle yet, because its handler waits or has the processor, or
  // because of the boot (ObjectManager::IsTooEarly()); oldest first.
  std::deque<Message*> held;
  // Where the reply goes when an object calls an entry of its own (self connection).
  struct SelfReply {
    void* data;
    size_t size;
    uint32_t selector;  // the entry that is called
  };
  SelfReply* self_reply = nullptr;
};

// The boxes by which an object receives replies; see requests.h.
struct ReplyBoxes {
  uint64_t last = 0;                     // the number of the newest box
  std::set<uint64_t> open;               // boxes whose reply may come or has come
  std::map<uint64_t, Message*> arrived;  // replies that no handler has received yet
};

// The use of the robot's processor, if handlers take time; see cpu.h.
struct ProcessorState {
  bool is_busy = false;            // a handler of the object has the processor
  int64_t starving_since_us = -1;  // a message has waited for the processor since; -1: none waits
  struct Outgoing {
    Message* message;
    int64_t delay_us;
  };
  std::vector<Outgoing> outbox;  // messages that will be sent when the handler's time is over
};

// The files of the stick that the code of an image has open.
class OpenFiles {
 public:
  struct File {
    std::string path;  // on the host
    bool writes = false;
  };

  void CloseAll();

  // The keys are addresses, so the order of `streams` must not decide anything in a run.
  std::map<std::FILE*, File> streams;
  std::map<int, File> descriptors;
  std::FILE* terminal = nullptr;  // the object's standard input, once it has read from the console
};

class Object {
 public:
  Object(System* system, ObjectId id, int robot);
  virtual ~Object();
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  // Calls entry `selector` with the address of the message's bytes.  Returns false if there is no
  // such entry.
  virtual bool Dispatch(uint32_t selector, void* payload) = 0;

  // Adds the state of the object that decides the future, except regions, queues and ready flags,
  // which System::state_hash() adds.  Images add nothing: their memory is never hashed.
  virtual void HashState(Hasher*) const {}

  // Returns the name of an entry for traces and messages: "DoStart", "Mover (Notify)".
  std::string EntryName(uint32_t selector) const;

  // Returns the observers that are ready for the subjects of this object.  If the object is
  // replaced, their readies are sent again to its successor.
  virtual std::vector<StandingReady> StandingReadies() const;

  // Called while the object is being replaced: an observer gives back a region that a subject of
  // this object had sent.
  virtual void ReturnRegion(RCRegion*) {}

  // Called for a queued `message` to this object that will not be delivered: counts it, and gives
  // the regions of a notification back to the subject.
  virtual void HandleUndelivered(const Message& message);

  // Returns whether the object's code was in a worker that is lost.  The loss itself is a finding,
  // so consequences of it are not.
  virtual bool IsLost() const { return false; }

  // Returns whether a handler of the object runs in another process, by the wall clock.  Virtual
  // time then does not say how long the handler takes.
  virtual bool IsAtWorkElsewhere() const { return false; }

  // Returns whether `address` is an instruction of the object's image.
  virtual bool HasCode(const void*) const { return false; }

  // Returns whether the object has an entry `selector`.
  virtual bool HasEntry(uint32_t selector) const = 0;

  // Called in the Control or Connect entry of a service: names entry `selector` after the service
  // and `kind` ("Ready" or "Notify"), and returns the full name of the service.
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
  MessageClass post_class = MessageClass::kObject;  // the class of messages that the object posts

  // Statistics of the report.
  std::string state;           // text after "state: " of its last OSYSLOG1 INFO line
  uint64_t message_count = 0;  // messages delivered
  uint64_t dropped_count = 0;  // data replaced before they were read, and messages refused
  int waiting = 0;             // messages to the object that are not delivered yet, without replies
  int queue_max = 32;          // limit of `waiting` (field-notes.md, 2.3); see SetResourceValue()
  int waiting_max = 0;         // the highest value of `waiting` so far
  int64_t handler_ns_max = 0;  // longest handler, wall time; 0 without SystemOptions::wall_clock_ns
  size_t stack_max = 0;        // most bytes that a handler used; see SystemOptions::measure_stacks

  std::set<void*> private_regions;  // blocks of NewRegion(); looked up only

  uint32_t random_state = 1;  // the state of rand()

  // The instruction that first raised each FpFlag, by bit number of the flag.  CrashLog sets it;
  // null: none raised the flag, or it is not known.
  const void* number_faults[kFpKinds] = {};
  // In the running handler, checked_code.cc has reported a conversion to an integer that is too
  // small for the value.
  bool has_reported_cast = false;

  OpenFiles files;
  HandlerState handler;
  ReplyBoxes boxes;
  ProcessorState processor;

  // Images only, and only where addresses are planned.
  std::unique_ptr<AddressPlace> place;
  std::unique_ptr<Arena> arena;
  std::vector<std::unique_ptr<SubjectState>> subjects;
  std::vector<std::unique_ptr<ObserverState>> observers;
  std::map<uint32_t, std::string> entry_names;
  std::map<uint32_t, std::string> services;  // selector registered -> full service name
};

}  // namespace openr_host

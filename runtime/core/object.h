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

// One line of an .ocf file, as far as the host uses it.
struct ObjectLimits {
  int priority = 128;        // 0..255; the upper four bits are the class
  uint32_t stack_bytes = 0;  // 0: unknown
  uint32_t heap_bytes = 0;
};

constexpr uint32_t kSelectorMax = 64;  // entries of an object on the robot

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
  uint64_t time_calls = 0;       // calls of GetSystemTime() in this handler, 1 us each
  Fiber* blocked = nullptr;      // the stack of a handler that waits
  uint64_t blocked_box = 0;      // the reply box it waits for
  int64_t blocked_since_us = 0;  // virtual time
  std::string blocked_why;       // what it waits for, for people
  std::deque<Message*> held;     // messages that arrived while it waited, oldest first
  // A nested call of an entry of the same object (self connection) puts its answer here.
  struct SelfReply {
    void* data;
    size_t size;
    uint32_t selector;  // of the entry called
  };
  SelfReply* self_reply = nullptr;
};

// The boxes by which an object receives replies; see requests.h.
struct ReplyBoxes {
  uint64_t last = 0;                     // the last number given
  std::set<uint64_t> open;               // boxes whose reply may come or has come
  std::map<uint64_t, Message*> arrived;  // replies that were not received yet
};

// The use of the robot's processor, if handlers take time; see cpu.h.
struct ProcessorState {
  bool is_busy = false;            // a handler of the object has the processor
  int64_t starving_since_us = -1;  // a message has waited for the processor since; -1: none waits
  struct Outgoing {
    Message* message;
    int64_t delay_us;
  };
  std::vector<Outgoing> outbox;  // messages posted before the handler's time was over
};

// The files of the stick that the code of an image has open.
class OpenFiles {
 public:
  struct File {
    std::string path;  // on the host
    bool writes = false;
  };

  void CloseAll();

  // Keyed by addresses: looked up, never walked through in an order that a run could see.
  std::map<std::FILE*, File> streams;
  std::map<int, File> descriptors;
  std::FILE* terminal = nullptr;  // its standard input, once it has read from the console
};

class Object {
 public:
  Object(System* system, ObjectId id, int robot);
  virtual ~Object();
  Object(const Object&) = delete;
  Object& operator=(const Object&) = delete;

  // Calls entry `selector` with the address of the message's bytes.  False when
  // there is no such entry.
  virtual bool Dispatch(uint32_t selector, void* payload) = 0;

  // What the object keeps that decides the future and is not in regions, queues
  // or ready flags.  Nothing for images: their memory is never hashed.
  virtual void HashState(Hasher*) const {}

  // Name of an entry for traces and messages: "Start", "Mover (Notify)".
  std::string EntryName(uint32_t selector) const;

  // Who is ready for its subjects, and has to say so again to a new object in its place.
  virtual std::vector<StandingReady> StandingReadies() const;

  // A region that one of its subjects had sent comes back while the object is being replaced.
  virtual void ReturnRegion(RCRegion*) {}

  // `message`, which was on its way to it, comes to nobody: it is counted, and what it carries
  // goes back.
  virtual void HandleUndelivered(const Message& message);

  // Its code is gone for the time being, which is known: nobody complains of what it does not do.
  virtual bool IsLost() const { return false; }

  // Its handler runs on another clock, so that virtual time does not say whether it takes long.
  virtual bool IsAtWorkElsewhere() const { return false; }

  // Whether `address` is one of its instructions.
  virtual bool HasCode(const void*) const { return false; }

  // Whether an entry `selector` can be called.
  virtual bool HasEntry(uint32_t selector) const = 0;

  // The full name of the service whose Control or Connect entry is running; entry
  // `selector`, of the `kind` given, is called after it from now on.
  std::string NameService(uint32_t selector, const char* kind);

  System* const system;
  const ObjectId id;
  const int robot;
  std::string name;         // OBJECT_NAME of the .ocf file, unique per robot
  std::string path;         // /MS/... of an image; empty for objects built in code
  bool is_image = false;    // loaded from a file; its code sees only the Memory Stick
  bool is_system = false;   // part of the robot, not of the application
  bool is_off = false;      // its robot is: what is sent to it is dropped
  bool is_leaving = false;  // another is about to take its place
  ObjectLimits limits;
  MessageClass post_class = MessageClass::kObject;  // of messages it posts

  // Statistics of the report.
  std::string state;           // text after "state: " of its last OSYSLOG1 INFO line
  uint64_t message_count = 0;  // delivered
  uint64_t dropped_count = 0;  // data replaced before it was read, messages refused
  int waiting = 0;             // messages in the queue now
  int queue_max = 32;          // that may wait (field-notes.md, 2.3); SetResourceValue()
  int waiting_max = 0;
  int64_t handler_ns_max = 0;  // wall time, when the system was given a clock
  size_t stack_max = 0;        // bytes; SystemOptions::measure_stacks

  std::set<void*> private_regions;  // blocks of NewRegion(); looked up only

  uint32_t random_state = 1;  // of rand()

  // The instructions that first raised each of the FpFlags, where the host says (CrashLog); null:
  // none, or not known.
  const void* number_faults[kFpKinds] = {};
  // A conversion that does not fit was reported in the handler that runs (checked_code.cc).
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

// The functions of MCOOP.h that send messages, wait for replies, reply, and find objects.  MCOOP.h
// is the interface of Aperios, the robot's operating system.
#include <MCOOP.h>
#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "runtime/api/known_object.h"
#include "runtime/api/mcoop_limits.h"
#include "runtime/core/api.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/system.h"

using namespace openr_host;

namespace {

// A handler that calls GetSystemTime() this many times is reported as a busy loop.
constexpr uint64_t kTimeCallsMax = 1'000'000;

// Makes a message to entry `selector` of object `oid` with a copy of the bytes at `msg`.
OwnedMessage NewBytes(const OID& oid, Selector selector, const void* msg, size_t size) {
  OwnedMessage message = t_current.system->NewMessage(ObjectIdOf(oid), selector);
  if (size > 0) std::memcpy(message->payload, msg, size);
  message->size = static_cast<uint32_t>(size);
  return message;
}

// Returns sSUCCESS if `rbox` is an open reply box of the current object, otherwise an error.  A
// reply box receives the reply to one request.  Only the object that sent this request may wait for
// the reply or close the box.
sError CheckBox(const RID& rbox) {
  const openr_host::Object* const self = t_current.object;
  if (self == nullptr || !rbox.IsValid()) return sINVALIDRID;
  if (ObjectIdOf(rbox.GetMailer()) != self->id) return sRIDCANNOTBETREATED;
  return self->boxes().IsOpen(rbox.GetValue()) ? sSUCCESS : sRIDNOTFOUND;
}

// Returns whether the current object can wait for a reply.  In a constructor or destructor, where
// no object can wait, adds a finding that names `function`, the function of MCOOP.h that the
// program has called.
bool CanWait(const char* function) {
  if (t_current.object->running() != nullptr) return true;
  t_current.system->AddFinding(
      Severity::kError, fmt::format("{}() in a constructor or destructor fails: only a handler can "
                                    "wait for an answer; do it in DoInit or DoDestroy",
                                    function));
  return false;
}

}  // namespace

extern "C" {

sError GetSystemTime(SystemTime* time) {
  const ApiScope scope;
  openr_host::Object* const object = t_current.object;
  if (object == nullptr || time == nullptr) return sINVALIDARG;
  object->NoteTimeCall();
  if (object->time_calls() == kTimeCallsMax) {
    t_current.system->AddFinding(
        Severity::kWarning,
        "1000000 calls of GetSystemTime() in one handler: a busy loop holds up "
        "every object of this robot");
  }
  // Adds 1 us to the returned time for each call of GetSystemTime() in the running handler.
  // Otherwise a loop that waits for a certain time would never end, because virtual time stands
  // still while a handler runs.  Subtracts the time of the robot's boot, because the robot's clock
  // begins at 0 when it boots.
  System& system = *t_current.system;
  const bool has_robot = object->robot < system.robot_count();
  const int64_t booted_us = has_robot ? system.robot(object->robot).booted_us : 0;
  const int64_t now = system.now_us() - booted_us + static_cast<int64_t>(object->passed_us());
  time->seconds = static_cast<longword>(now / 1'000'000);
  time->useconds = static_cast<longword>(now % 1'000'000);
  return sSUCCESS;
}

sError WhoAmI(OID* oid) {
  if (t_current.object == nullptr || oid == nullptr) return sINVALIDARG;
  *oid = OidOf(t_current.object->id);
  return sSUCCESS;
}

sError Find(const char* name, OID* oid) {
  const ApiScope scope;
  if (t_current.object == nullptr || name == nullptr || oid == nullptr) return sINVALIDARG;
  ObjectId found = kNoObject;
  const sError error = t_current.system->calls().FindName(name, &found);
  if (error == sSUCCESS) *oid = OidOf(found);
  return error;
}

sError Register(OID oid, const char* name) {
  const ApiScope scope;
  if (t_current.object == nullptr || name == nullptr || *name == '\0') return sINVALIDARG;
  if (std::strlen(name) > kObjectNameMax) return sOBLETNAMETOOLONG;
  const ObjectId id = ObjectIdOf(oid);
  if (!IsKnown(id)) return sINVALIDOID;
  return t_current.system->calls().RegisterName(id, name);
}

sError Unregister(const char* name) {
  const ApiScope scope;
  if (t_current.object == nullptr || name == nullptr) return sINVALIDARG;
  return t_current.system->calls().UnregisterName(name);
}

// Finds the selector of an entry of the calling object by the entry's name.  Searches only the
// entries of the Extra lines of stub.cfg.  This is our choice, because no source says which names
// the robot searches.
sError FindSelector(const char* name, Selector* selector) {
  const ApiScope scope;
  if (t_current.object == nullptr || name == nullptr || selector == nullptr) return sINVALIDARG;
  for (const auto& [number, entry] : t_current.object->entry_names().names()) {
    if (entry != name) continue;
    *selector = number;
    return sSUCCESS;
  }
  return sOBJNOTFOUND;
}

sError Send(OID oid, Selector selector, void* msg, size_t size) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  if (size > kMessageMax) return sEXCEEDEDSIZEOFMSG;
  return t_current.system->Post(NewBytes(oid, selector, msg, size));
}

sError SendWithRBox(OID oid, Selector selector, void* msg, size_t size, RID* rbox) {
  const ApiScope scope;
  if (t_current.object == nullptr || rbox == nullptr) return sINVALIDARG;
  if (size > kMessageMax) return sEXCEEDEDSIZEOFMSG;
  uint64_t box = 0;
  const sError error = t_current.system->requests().Send(NewBytes(oid, selector, msg, size), &box);
  if (error == sSUCCESS) *rbox = RID(OidOf(t_current.object->id), static_cast<longword>(box));
  return error;
}

sError Receive(RID rbox, void* msg, size_t size, size_t* got, RelativeTime* timeout) {
  const ApiScope scope;
  const sError error = CheckBox(rbox);
  if (error != sSUCCESS) return error;
  if (!CanWait("Receive")) return sFAIL;
  return t_current.system->requests().Wait(rbox.GetValue(), msg, size, got,
                                           timeout == nullptr ? -1 : Microseconds(*timeout),
                                           "a reply (Receive)");
}

sError Call(OID oid, Selector selector, void* msg, size_t size, void* reply, size_t replySize) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  if (size > kMessageMax) return sEXCEEDEDSIZEOFMSG;
  if (t_current.system->object(ObjectIdOf(oid)) == nullptr) return sINVALIDOID;
  if (!CanWait("Call")) return sFAIL;
  return t_current.system->requests().Call(ObjectIdOf(oid), selector, msg, size, reply, replySize);
}

sError Reply(void* msg, size_t size) {
  const ApiScope scope;
  return ReplyToRequest(msg, size);
}

// Passes the request that the running handler has received to object `oid`, which then replies in
// place of this object.  The reply goes directly to the object that sent the request, because the
// new message carries the sender and the reply box of the request.
sError Delegate(OID oid, Selector selector, void* msg, size_t size) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  if (size > kMessageMax) return sEXCEEDEDSIZEOFMSG;
  if (t_current.system->object(ObjectIdOf(oid)) == nullptr) return sINVALIDOID;
  const ReplyTicket ticket = t_current.system->requests().TakeTicket();
  if (ticket.box == 0) return sINVALIDRID;
  OwnedMessage message = NewBytes(oid, selector, msg, size);
  message->sender = ticket.to;
  message->reply_box = ticket.box;
  const sError error = t_current.system->Post(std::move(message));
  // If the message to object `oid` was refused, gives the reply box back to the running handler, so
  // that this object can still reply to the request itself.
  if (error != sSUCCESS) t_current.object->running()->reply_box = ticket.box;
  return error;
}

sError CleanRBox(RID rbox) {
  const ApiScope scope;
  const sError error = CheckBox(rbox);
  if (error != sSUCCESS) return error;
  t_current.system->calls().CloseBox(rbox.GetValue());
  return sSUCCESS;
}

// Sends the reply to the request of the running handler, and ends the handler.  Does not return.
void Return(void* msg, size_t size) {
  Reply(msg, size);
  Exit();
}

// Ends the running handler and does not return.  Outside of a handler does nothing.
void Exit() {
  if (t_current.object != nullptr && t_current.object->running() != nullptr) {
    t_current.image_code = false;
    t_current.system->AbandonHandler();
  }
}

// Does nothing.  On the robot this function ends Prologue(), the entry with which an object begins.
// The host's Prologue() does nothing.
void ExitFromPrologue() {}

// Adds `nanosec` to the times that later calls of GetSystemTime() in this handler return.  Virtual
// time itself stands still while a handler runs.
sError Wait(longword nanosec) {
  if (t_current.object == nullptr) return sFAIL;
  t_current.object->NoteWait(nanosec / 1000);
  return sSUCCESS;
}

}  // extern "C"

// Does nothing.  On the robot this entry runs the constructors of global variables.  On the host
// the loader has run them already.
extern "C" void Prologue(InitInfo*) {}

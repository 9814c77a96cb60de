// The functions of MCOOP.h that order messages for later (events), and the functions that read and
// set limits of an object.  MCOOP.h is the interface of Aperios, the robot's operating system.
#include <MCOOP.h>

#include "runtime/api/known_object.h"
#include "runtime/api/mcoop_limits.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

using namespace openr_host;

namespace {

// Checks whether the current object may order one more event: a message of `size` bytes that is
// sent to object `oid` at a certain time or when a reply arrives.  Returns sSUCCESS, or the error
// that the function of MCOOP.h returns to the program.
sError CheckEventMessage(const OID& oid, size_t size) {
  if (t_current.object == nullptr) return sFAIL;
  if (size > kMessageMax) return sEXCEEDEDSIZEOFMSG;
  if (!IsKnown(ObjectIdOf(oid))) return sINVALIDOID;
  if (t_current.system->calls().CountEvents() >= kEventsMax) return sFULLEVENTENTRY;
  return sSUCCESS;
}

TimeEvents::EventMessage MakeEventMessage(const OID& oid, Selector selector, const void* msg,
                                          size_t size) {
  const auto* const bytes = static_cast<const unsigned char*>(msg);
  return {t_current.object->id, ObjectIdOf(oid), selector, {bytes, bytes + size}};
}

}  // namespace

extern "C" {

sError SetTimeEvent(TimeEventInfo* info, OID oid, Selector selector, void* msg, size_t size,
                    EventID* event) {
  const ApiScope scope;
  if (info == nullptr) return sINVALIDTEVENTINFO;
  const sError error = CheckEventMessage(oid, size);
  if (error != sSUCCESS) return error;
  const longword id = t_current.system->calls().AddTimedEvent(
      MakeEventMessage(oid, selector, msg, size), Microseconds(info->relativeTime),
      Microseconds(info->periodicTime));
  if (event != nullptr) event->value = id;
  return sSUCCESS;
}

sError SetReplyEvent(RID rbox, OID oid, Selector selector, void* msg, size_t size, EventID* event) {
  const ApiScope scope;
  const sError error = CheckEventMessage(oid, size);
  if (error != sSUCCESS) return error;
  openr_host::Object* const self = t_current.object;
  if (!rbox.IsValid()) return sINVALIDRID;
  if (ObjectIdOf(rbox.GetMailer()) != self->id) return sRIDCANNOTBETREATED;
  if (!self->boxes().IsOpen(rbox.GetValue())) return sRIDNOTFOUND;
  const longword id = t_current.system->calls().AddReplyEvent(
      MakeEventMessage(oid, selector, msg, size), rbox.GetValue());
  if (event != nullptr) event->value = id;
  return sSUCCESS;
}

sError CancelEvent(EventID event) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  return t_current.system->calls().CancelEvent(event.value) ? sSUCCESS : sINVALIDEVENTID;
}

// Changes a limit of the current object.  Only the length of its message queue can be changed.
sError SetResourceValue(sResource resource, slongword value) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  if (resource < rMAXMESSAGESIZE || resource > rMAXENTRIES) return sINVALIDRESOURCE;
  if (resource != rMAXQUEUESIZE) return sNOTSUPPORTED;
  if (value <= 0) return sINVALIDARG;
  t_current.system->calls().SetQueueMax(value);
  return sSUCCESS;
}

sError GetResourceValue(sResource resource, slongword* current, slongword* max, slongword* min) {
  if (t_current.object == nullptr || current == nullptr) return sINVALIDARG;
  switch (resource) {
    case rMAXMESSAGESIZE:
      *current = static_cast<slongword>(kMessageMax);
      break;
    case rMAXQUEUESIZE:
      *current = t_current.object->queue_max();
      break;
    case rMAXEVENT:
      *current = kEventsMax;
      break;
    case rMAXENTRIES:
      *current = kEntriesMax;
      break;
    default:
      return sINVALIDRESOURCE;
  }
  // Returns the current length of the message queue as its maximum too, because the host does not
  // limit the length.
  if (max != nullptr) *max = *current;
  if (min != nullptr) *min = 1;
  return sSUCCESS;
}

}  // extern "C"

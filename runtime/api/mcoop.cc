// The Aperios calls of MCOOP.h.
#include <MCOOP.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "runtime/core/api.h"
#include "runtime/core/arena.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/system.h"

using namespace openr_host;

namespace {

constexpr size_t kMessageMax = 256;            // AperiosMessage: a longer one is refused
constexpr uint64_t kTimeCallsMax = 1'000'000;  // in one handler, before it is reported
constexpr int64_t kPageBytes = 4096;

int64_t TimeoutUs(const RelativeTime* timeout) {
  if (timeout == nullptr) return -1;
  return int64_t{timeout->sec} * 1'000'000 + int64_t{timeout->msec} * 1000;
}

Message* NewBytes(const OID& oid, Selector selector, const void* msg, size_t size) {
  Message* const message = t_current.system->NewMessage(ObjectIdOf(oid), selector);
  if (size > 0) std::memcpy(message->payload, msg, size);
  message->size = static_cast<uint32_t>(size);
  return message;
}

}  // namespace

extern "C" {

sError GetSystemTime(SystemTime* time) {
  const ApiScope scope;
  openr_host::Object* const object = t_current.object;
  if (object == nullptr || time == nullptr) return sINVALIDARG;
  if (++object->time_calls == kTimeCallsMax) {
    t_current.system->AddFinding(
        Severity::kWarning,
        "1000000 calls of GetSystemTime() in one handler: a busy loop holds up "
        "every object of this robot");
  }
  const int64_t now = t_current.system->now_us() + static_cast<int64_t>(object->time_calls);
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
  const openr_host::Object* const found =
      t_current.system->FindObject(t_current.object->robot, name);
  if (found == nullptr) return sOBJNOTFOUND;
  *oid = OidOf(found->id);
  return sSUCCESS;
}

sError Register(OID, const char*) { return sNOTSUPPORTED; }
sError Unregister(const char*) { return sNOTSUPPORTED; }
sError FindSelector(const char*, Selector*) { return sNOTSUPPORTED; }

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
  const sError error = t_current.system->SendWithReply(NewBytes(oid, selector, msg, size), &box);
  if (error == sSUCCESS) *rbox = RID(OidOf(t_current.object->id), static_cast<longword>(box));
  return error;
}

sError Receive(RID rbox, void* msg, size_t size, size_t* got, RelativeTime* timeout) {
  const ApiScope scope;
  if (t_current.object == nullptr || !rbox.IsValid()) return sINVALIDRID;
  return t_current.system->WaitForReply(rbox.GetValue(), msg, size, got, TimeoutUs(timeout),
                                        "a reply (Receive)");
}

sError Call(OID oid, Selector selector, void* msg, size_t size, void* reply, size_t replySize) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  if (size > kMessageMax) return sEXCEEDEDSIZEOFMSG;
  if (t_current.system->object(ObjectIdOf(oid)) == nullptr) return sINVALIDOID;
  return t_current.system->Call(ObjectIdOf(oid), selector, msg, size, reply, replySize);
}

sError Reply(void* msg, size_t size) {
  const ApiScope scope;
  openr_host::Object* const object = t_current.object;
  if (object == nullptr) return sFAIL;
  if (object->self_reply != nullptr) {
    std::memcpy(object->self_reply->data, msg, std::min(size, object->self_reply->size));
    return sSUCCESS;
  }
  return t_current.system->Reply(t_current.system->TakeReplyTicket(), msg, size);
}

sError Delegate(OID, Selector, void*, size_t) { return sNOTSUPPORTED; }
sError CleanRBox(RID) { return sSUCCESS; }

void Return(void* msg, size_t size) {
  Reply(msg, size);
  Exit();
}

void Exit() {
  if (t_current.object != nullptr && t_current.object->running != nullptr) {
    t_current.image_code = false;
    t_current.system->AbandonHandler();
  }
}

void ExitFromPrologue() {}

sError SetTimeEvent(TimeEventInfo* info, OID oid, Selector selector, void* msg, size_t size,
                    EventID*) {
  const ApiScope scope;
  if (t_current.object == nullptr || info == nullptr) return sINVALIDTEVENTINFO;
  if (size > kMessageMax) return sEXCEEDEDSIZEOFMSG;
  return t_current.system->Post(NewBytes(oid, selector, msg, size), TimeoutUs(&info->relativeTime));
}

sError SetReplyEvent(RID, OID, Selector, void*, size_t, EventID*) { return sNOTSUPPORTED; }
sError CancelEvent(EventID) { return sNOTSUPPORTED; }

sError NewRegion(size_t size, void** base) {
  const ApiScope scope;
  if (t_current.object == nullptr || base == nullptr) return sINVALIDARG;
  auto memory = std::make_unique<char[]>(size);
  *base = memory.get();
  t_current.object->private_regions[*base] = std::move(memory);
  return sSUCCESS;
}

sError DeleteRegion(void* base) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  return t_current.object->private_regions.erase(base) == 1 ? sSUCCESS : sINVALIDARG;
}

sError NewSharedMemoryRegion(size_t size, MemoryProtectionInfo, MemoryRegionID* id, void** base) {
  const ApiScope scope;
  if (t_current.object == nullptr || id == nullptr || base == nullptr) return sINVALIDARG;
  *id = t_current.system->regions().New(size, t_current.object->id);
  *base = t_current.system->regions().BaseOf(*id);
  return *base == nullptr ? sNOMEMORY : sSUCCESS;
}

sError DeleteSharedMemoryRegion(MemoryRegionID id) {
  const ApiScope scope;
  if (t_current.object == nullptr) return sFAIL;
  return t_current.system->regions().Delete(id) ? sSUCCESS : sINVALIDSHAREDMEMID;
}

sError AllowToAttachMemoryRegion(MemoryRegionID, MemoryProtectionInfo, OID, bool) {
  return sSUCCESS;
}

sError AttachMemoryRegion(MemoryRegionID id, MemoryProtectionInfo, void** base) {
  const ApiScope scope;
  if (t_current.object == nullptr || base == nullptr) return sINVALIDARG;
  *base = t_current.system->regions().BaseOf(id);
  return *base == nullptr ? sINVALIDSHAREDMEMID : sSUCCESS;
}

sError DetachMemoryRegion(MemoryRegionID) { return sSUCCESS; }
sError ChangeProtectionMemoryRegion(MemoryRegionID, MemoryProtectionInfo) { return sSUCCESS; }
sError GrowMemoryRegion(MemoryRegionID, size_t) { return sNOTSUPPORTED; }
sError ShrinkMemoryRegion(MemoryRegionID, size_t) { return sNOTSUPPORTED; }

sError GetPageSize(size_t* size) {
  *size = kPageBytes;
  return sSUCCESS;
}

sError GetFreeMemorySize(size_t*) { return sNOTSUPPORTED; }
sError SetResourceValue(sResource, slongword) { return sNOTSUPPORTED; }
sError GetResourceValue(sResource, slongword*, slongword*, slongword*) { return sNOTSUPPORTED; }

sError Wait(longword nanosec) {
  if (t_current.object == nullptr) return sFAIL;
  t_current.object->time_calls += nanosec / 1000;
  return sSUCCESS;
}

}  // extern "C"

// The entry run at load; constructors have run before it on the host.
extern "C" void Prologue(InitInfo*) {}

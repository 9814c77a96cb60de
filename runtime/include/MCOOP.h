// Calls of the Aperios mCOOP layer that application objects can see.
//
// All return an sError unless noted.  New, Delete, Load, Unload, LoadAndExecMAV and
// SetEntryTable, which only the system calls, are left out: no source gives their arguments.
#ifndef OPENR_MCOOP_H_INCLUDED
#define OPENR_MCOOP_H_INCLUDED

#include <OID.h>
#include <OPENR/SizeResult.h>
#include <RID.h>
#include <SystemResource.h>
#include <SystemTime.h>
#include <TimeEvent.h>
#include <Time_a.h>
#include <Types.h>
#include <stddef.h>

struct InitInfo;

extern "C" {

// Microseconds since boot.  Inside one handler every call is 1 us later than
// the one before, so that a loop that waits for time to pass ends.
sError GetSystemTime(SystemTime* time);

// The name of an object is the OBJECT_NAME of its .ocf file.
sError WhoAmI(OID* oid);
sError Find(const char* name, OID* oid);
sError Register(OID oid, const char* name);
sError Unregister(const char* name);
sError FindSelector(const char* name, Selector* selector);

// Asynchronous.  `size` bytes are copied; at most 256.
sError Send(OID oid, Selector selector, void* msg, size_t size);
sError SendWithRBox(OID oid, Selector selector, void* msg, size_t size, RID* rbox);
// Waits for the answer to a SendWithRBox(): blocks this object only.
sError Receive(RID rbox, void* msg = 0, size_t size = 0, size_t* got = 0,
               RelativeTime* timeout = 0);
// Sends and waits for the answer.
sError Call(OID oid, Selector selector, void* msg, size_t size, void* reply = 0,
            size_t replySize = 0);
// Answers the Call or SendWithRBox being handled.
sError Reply(void* msg = 0, size_t size = 0);
// Hands the request being handled on to another object, which answers it.
sError Delegate(OID oid, Selector selector, void* msg, size_t size);
sError CleanRBox(RID rbox);

// End the current method; they do not return to the caller.
void Return(void* msg = 0, size_t size = 0);
void Exit();
void ExitFromPrologue();

// Messages to come, until they are cancelled: at a time, every so often, or when the reply to
// `rbox` can be received without waiting.  `event` may be 0.
sError SetTimeEvent(TimeEventInfo* info, OID oid, Selector selector, void* msg, size_t size,
                    EventID* event);
sError SetReplyEvent(RID rbox, OID oid, Selector selector, void* msg, size_t size, EventID* event);
sError CancelEvent(EventID event);

// Private memory of this object.
sError NewRegion(size_t size, void** base);
sError DeleteRegion(void* base);

// Memory that can be shared with other objects.  Others need the owner's leave (44 without);
// sizes are in bytes, and a region grows no further than it was made.
sError NewSharedMemoryRegion(size_t size, MemoryProtectionInfo info, MemoryRegionID* id,
                             void** base);
sError DeleteSharedMemoryRegion(MemoryRegionID id);
sError AllowToAttachMemoryRegion(MemoryRegionID id, MemoryProtectionInfo info, OID oid,
                                 bool givingOwnership);
sError AttachMemoryRegion(MemoryRegionID id, MemoryProtectionInfo info, void** base);
sError DetachMemoryRegion(MemoryRegionID id);
sError ChangeProtectionMemoryRegion(MemoryRegionID id, MemoryProtectionInfo info);
sError GrowMemoryRegion(MemoryRegionID id, size_t size);
sError ShrinkMemoryRegion(MemoryRegionID id, size_t size);
sError GetPageSize(size_t* size);
sError GetFreeMemorySize(size_t* size);

sError SetResourceValue(sResource resource, slongword value);
sError GetResourceValue(sResource resource, slongword* current, slongword* most = 0,
                        slongword* least = 0);

// Waits `nanosec` of the handler's own time.
sError Wait(longword nanosec);

}  // extern "C"

// Five arguments: with a reply box.
inline sError Send(OID oid, Selector selector, void* msg, size_t size, RID* rbox) {
  return SendWithRBox(oid, selector, msg, size, rbox);
}
inline sError Receive(RID rbox, void* msg, size_t size, RelativeTime* timeout) {
  return Receive(rbox, msg, size, 0, timeout);
}
inline sError Find(const char* name, Selector* selector) { return FindSelector(name, selector); }

#if OPENR_WIDE_SIZE
template <class Number>
inline typename openr_host::IfUnsigned<Number, sError>::Type Receive(RID rbox, void* msg,
                                                                     size_t size, Number* got,
                                                                     RelativeTime* timeout = 0) {
  return Receive(rbox, msg, size, openr_host::SizeResult(got), timeout);
}
template <class Number>
inline typename openr_host::IfUnsigned<Number, sError>::Type GetPageSize(Number* size) {
  return GetPageSize(openr_host::SizeResult(size));
}
template <class Number>
inline typename openr_host::IfUnsigned<Number, sError>::Type GetFreeMemorySize(Number* size) {
  return GetFreeMemorySize(openr_host::SizeResult(size));
}
#endif

#endif  // OPENR_MCOOP_H_INCLUDED

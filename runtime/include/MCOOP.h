// The functions of Aperios, the robot's operating system, that objects of a program can call; mCOOP
// is the name of this interface.
//
// All return an sError unless noted.  New, Delete, Load, Unload, LoadAndExecMAV and SetEntryTable
// are left out, because only the system calls them and no source gives their arguments.
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

// Returns the time since boot.  Within one handler each call returns 1 us more than the previous
// call, so that a loop that waits for a certain time comes to an end.
sError GetSystemTime(SystemTime* time);

// Functions that find objects and entries, and that register and remove names of objects.  WhoAmI()
// returns the OID of the calling object.  Before a Register(), the name of an object is the
// OBJECT_NAME of its .ocf file.
sError WhoAmI(OID* oid);
sError Find(const char* name, OID* oid);
sError Register(OID oid, const char* name);
sError Unregister(const char* name);
sError FindSelector(const char* name, Selector* selector);

// Send a copy of the message, `size` bytes at `msg`, and return without waiting.  `size` is at most
// 256.
sError Send(OID oid, Selector selector, void* msg, size_t size);
sError SendWithRBox(OID oid, Selector selector, void* msg, size_t size, RID* rbox);
// Waits for the answer to a SendWithRBox().  Only the calling object waits; all other objects run
// on.
sError Receive(RID rbox, void* msg = 0, size_t size = 0, size_t* got = 0,
               RelativeTime* timeout = 0);
// Sends a message and waits for its answer.
sError Call(OID oid, Selector selector, void* msg, size_t size, void* reply = 0,
            size_t replySize = 0);
// Answers the request that the running handler has received, and that another object has sent with
// Call() or SendWithRBox().
sError Reply(void* msg = 0, size_t size = 0);
// Passes the request that the running handler has received on to another object, which answers it
// in place of this object.
sError Delegate(OID oid, Selector selector, void* msg, size_t size);
sError CleanRBox(RID rbox);

// End the running handler.  The code after a call of Return() or Exit() is not executed.
void Return(void* msg = 0, size_t size = 0);
void Exit();
void ExitFromPrologue();

// Request messages for later.  SetTimeEvent() requests a message at a certain time, and again after
// each period.  SetReplyEvent() requests a message when the reply has arrived in the box `rbox`, so
// that Receive() can return at once.  Unless `event` is 0, `*event` becomes the id for
// CancelEvent().
sError SetTimeEvent(TimeEventInfo* info, OID oid, Selector selector, void* msg, size_t size,
                    EventID* event);
sError SetReplyEvent(RID rbox, OID oid, Selector selector, void* msg, size_t size, EventID* event);
sError CancelEvent(EventID event);

// Make and delete private memory of the calling object.
sError NewRegion(size_t size, void** base);
sError DeleteRegion(void* base);

// Functions for memory that can be shared with other objects.  Another object needs the owner's
// permission to use the memory.  Without the permission, calls of the other object for this memory
// fail with error 44 (sPERMISSIONDENIEDSHAREDMEM).  Sizes are in bytes; a region cannot grow beyond
// its first size.
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

// Lets `nanosec` nanoseconds pass for this handler: from now on GetSystemTime() returns times that
// are later by this amount.
sError Wait(longword nanosec);

}  // extern "C"

// Older forms of functions of MCOOP.h, for old programs: Send() with five arguments is
// SendWithRBox().
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

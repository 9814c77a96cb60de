// SystemCalls: the interface for all actions of a handler that other objects or users can see.
//
// SystemCalls has three implementations.  LocalCalls works on the tables of the System itself.  In
// a worker process, WorkerCalls sends the calls to the master (distribution/worker_calls.h).  The
// master executes them with CheckedCalls, which checks what the worker asks for
// (distribution/checked_calls.h).  The functions of the SDK use System::calls() and work with all
// three.
//
// The caller is the current object (t_current).  While objects are loaded, there may be no caller.
#pragma once

#include <MemoryRegion.h>
#include <OPENR/OPENR.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "runtime/config/diagnostic.h"
#include "runtime/core/message.h"
#include "runtime/core/run_end.h"
#include "runtime/core/time_events.h"

namespace openr_host {

class Object;

class SystemCalls {
 public:
  virtual ~SystemCalls() = default;

  // ---- Messages and replies

  // Queues `message`, due `delay_us` from now, and returns an sError as System::Post() does.  The
  // message is passed by reference, because otherwise it would be moved once more at each step on
  // the way to the queue, which makes notifications slower.
  virtual int32_t Post(OwnedMessage&& message, int64_t delay_us) = 0;

  // Opens `box`, a reply box of the caller, so that the caller can receive a reply.  A box is a
  // number that a request carries; the reply to the request carries the same number.
  virtual void OpenBox(uint64_t box) = 0;
  // Closes `box`, a reply box of the caller.  From now on the caller receives no reply in this box;
  // a reply that has already arrived is released.
  virtual void CloseBox(uint64_t box) = 0;

  // Returns whether object `asker` accepts a reply in its reply box `box`.  In a worker process
  // returns true for every box, because only the master knows the boxes of all objects; the master
  // checks the box when the reply is posted.
  virtual bool AcceptsReply(ObjectId asker, uint64_t box) const = 0;

  // Prepares a wait of the caller for the reply in its reply box `box`.  `why` describes for users
  // what the caller waits for.  If `timeout_us` is less than 0, the wait has no limit, and the
  // function returns null.  Otherwise queues a message that ends the wait after `timeout_us`, and
  // returns this message, so that the caller can remove it if the reply comes first.  In a worker
  // process always returns null, because the master ends the wait.
  virtual const Message* BeginWait(uint64_t box, int64_t timeout_us, std::string_view why) = 0;

  // Waits for a line of the console and copies it to `buffer`; see ConsoleInput::Read().
  virtual size_t ReadLine(char* buffer, size_t size) = 0;

  // Sets the number of messages that may wait for the caller (Object::queue_max).
  virtual void SetQueueMax(int32_t messages) = 0;

  // ---- Time events and reply events (see TimeEvents).  `message` is the message that the event
  // posts.  REQUIRES: the caller is message.owner, the object that may cancel the event.

  virtual uint32_t AddTimedEvent(const TimeEvents::EventMessage& message, int64_t first_us,
                                 int64_t period_us) = 0;
  // Adds a reply event, which posts `message` when a reply arrives in the caller's reply box
  // `box`, or at once if the reply has arrived already.  REQUIRES: `box` is open.
  virtual uint32_t AddReplyEvent(const TimeEvents::EventMessage& message, uint64_t box) = 0;
  virtual bool CancelEvent(uint32_t event) = 0;
  virtual int CountEvents() = 0;

  // ---- Names of objects, services and entries

  // The next three functions do the work of Register(), Find() and Unregister() of MCOOP.h, with
  // which objects of the caller's robot find each other by names.  All return an sError.
  virtual int32_t RegisterName(ObjectId object, std::string_view name) = 0;
  virtual int32_t FindName(std::string_view name, ObjectId* object) = 0;
  virtual int32_t UnregisterName(std::string_view name) = 0;

  // Registers entry `selector` of `object` as the service `name` of the caller's robot, so that a
  // connection of CONNECT.CFG can begin or end at it.
  virtual OStatus RegisterService(ObjectId object, uint32_t selector, std::string_view name) = 0;

  // Sets `name` as the text that traces and messages show for the caller's entry `selector`.
  virtual void NameEntry(uint32_t selector, std::string_view name) = 0;

  // ---- Shared memory; see RegionTable and RegionShares

  virtual uint32_t NewRegion(size_t size, ObjectId owner) = 0;
  virtual bool DeleteRegion(uint32_t region) = 0;
  virtual bool ResizeRegion(uint32_t region, size_t size) = 0;
  // Keeps the memory of a region until UnpinRegion(), even if the region is deleted.  Observers pin
  // regions that they have received.  Returns false if there is no such region.
  virtual bool PinRegion(uint32_t region) = 0;
  // Ends the effect of one PinRegion().  Returns false if there is no such region or the region is
  // not pinned.
  virtual bool UnpinRegion(uint32_t region) = 0;

  // The next four functions call the functions of RegionShares for the caller.  AllowAccess() gives
  // object `other` the right `info` to use `region`.  Attach() and Detach() begin and end the
  // caller's use of the region, and CheckAccess() checks whether the caller has the right `info`.
  // All return an sError.
  virtual int32_t AllowAccess(uint32_t region, MemoryProtectionInfo info, ObjectId other,
                              bool giving_ownership) = 0;
  virtual int32_t Attach(uint32_t region, MemoryProtectionInfo info) = 0;
  virtual int32_t Detach(uint32_t region) = 0;
  virtual int32_t CheckAccess(uint32_t region, MemoryProtectionInfo info) = 0;

  // Tells the master process that the caller has mapped (`is_mapped`) or unmapped a buffer of the
  // IPStack: the buffer with the number `cookie`, which lies in `region`.  The IPStack in the
  // master must know this, because an object may send only data in a mapped buffer.
  virtual void NoteMapping(uint32_t cookie, uint32_t region, bool is_mapped) = 0;

  // ---- The run and the sticks of its robots

  // Adds a finding about the object `about`, or about the system if `about` is null.
  virtual void AddFinding(const Object* about, Severity severity, std::string_view text) = 0;

  // Shuts one robot down; see System::Shutdown().
  virtual void Shutdown(int robot, const RunEnd& why) = 0;
  // Switches one robot off at once; see System::PowerOff().
  virtual void PowerOff(int robot, const RunEnd& why) = 0;

  // Records that the caller is about to change the file `path` of its stick
  // (MemoryStick::NoteWritten()).  For a caller in a worker process, the worker and the master
  // record the change, and the function returns only after the master has done so.  Always returns
  // true.
  virtual bool NoteFileWritten(std::string_view path) = 0;
};

}  // namespace openr_host

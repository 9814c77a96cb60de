// The calls of a handler to its System: everything that a handler does and others can see.
//
// There are three kinds.  LocalCalls works on the tables of the System itself.  In a worker
// process, the calls go to the master (distribution/worker_calls.h).  The master executes them with
// calls that check what a worker asks for (distribution/checked_calls.h).  The functions of the SDK
// use System::calls() and do not depend on the kind.
//
// The caller is the current object (t_current), or none while objects are loaded.
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

  // Queues `message`, `delay_us` from now, and returns an sError.  Takes the message.
  virtual int32_t Post(Message* message, int64_t delay_us) = 0;

  // OpenBox() lets the caller receive a reply to `box`.  CloseBox() ends that, and releases a reply
  // that has arrived.
  virtual void OpenBox(uint64_t box) = 0;
  virtual void CloseBox(uint64_t box) = 0;

  // Returns whether object `asker` accepts a reply to `box`, as far as this process knows.
  virtual bool AcceptsReply(ObjectId asker, uint64_t box) const = 0;

  // Called before the caller waits for the reply to `box`, at most `timeout_us` (< 0: for ever).
  // Returns the message that will end the wait at that time; null if none was posted here.
  virtual Message* BeginWait(uint64_t box, int64_t timeout_us, std::string_view why) = 0;

  // Waits for a line of the console; see ConsoleInput::Read().
  virtual size_t ReadLine(char* buffer, size_t size) = 0;

  // Sets the number of messages that may wait for the caller (Object::queue_max).
  virtual void SetQueueMax(int32_t messages) = 0;

  // ---- Time events and reply events; see TimeEvents.  REQUIRES: letter.owner is the caller.

  virtual uint32_t AddTimedEvent(const TimeEvents::Letter& letter, int64_t first_us,
                                 int64_t period_us) = 0;
  // REQUIRES: the box is open.  The reply may have arrived already.
  virtual uint32_t AddReplyEvent(const TimeEvents::Letter& letter, uint64_t box) = 0;
  virtual bool CancelEvent(uint32_t event) = 0;
  virtual int CountEvents() = 0;

  // ---- Names

  // Register(), Find() and Unregister() of MCOOP.h for the caller's robot.  Return an sError.
  virtual int32_t RegisterName(ObjectId object, std::string_view name) = 0;
  virtual int32_t FindName(std::string_view name, ObjectId* object) = 0;
  virtual int32_t UnregisterName(std::string_view name) = 0;

  // Makes entry `selector` of `object` the service `name` of the caller's robot.
  virtual OStatus RegisterService(ObjectId object, uint32_t selector, std::string_view name) = 0;

  // The text that traces and messages show for the caller's entry `selector`.
  virtual void NameEntry(uint32_t selector, std::string_view name) = 0;

  // ---- Shared memory; see RegionTable and RegionShares

  virtual uint32_t NewRegion(size_t size, ObjectId owner) = 0;
  virtual bool DeleteRegion(uint32_t region) = 0;
  virtual bool ResizeRegion(uint32_t region, size_t size) = 0;
  // Return false if there is no such region; UnpinRegion() also if the region is not pinned.
  virtual bool PinRegion(uint32_t region) = 0;
  virtual bool UnpinRegion(uint32_t region) = 0;

  // Access rights of RegionShares.  Return an sError.
  virtual int32_t AllowAccess(uint32_t region, MemoryProtectionInfo info, ObjectId other,
                              bool giving_ownership) = 0;
  virtual int32_t Attach(uint32_t region, MemoryProtectionInfo info) = 0;
  virtual int32_t Detach(uint32_t region) = 0;
  virtual int32_t CheckAccess(uint32_t region, MemoryProtectionInfo info) = 0;

  // Notes that the caller has mapped or unmapped a buffer of the IPStack.
  virtual void NoteMapping(uint32_t cookie, uint32_t region, bool is_mapped) = 0;

  // ---- The run and its stick

  // `about` may be null: a finding about the system.
  virtual void AddFinding(const Object* about, Severity severity, std::string_view text) = 0;

  // See System::Shutdown() and System::PowerOff().
  virtual void Shutdown(int robot, const RunEnd& why) = 0;
  virtual void PowerOff(int robot, const RunEnd& why) = 0;

  // Called before the caller changes the file `path` of its stick.  Returns after all processes
  // that use the stick have been told.
  virtual bool NoteFileWritten(std::string_view path) = 0;
};

}  // namespace openr_host

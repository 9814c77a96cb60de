#include "distribution/worker_calls.h"

#include <sError.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "distribution/ask_master.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/system.h"

namespace openr_host {

int32_t WorkerCalls::Post(OwnedMessage&& message, int64_t delay_us) {
  if (system_->object(message->target) == nullptr)
    return MessagePoster::PostToUnknown(std::move(message), delay_us);
  return master_->Post(std::move(message), delay_us);
}

void WorkerCalls::OpenBox(uint64_t box) {
  LocalCalls::OpenBox(box);
  TellMaster<&SystemCalls::OpenBox>(master_, box);
}

void WorkerCalls::CloseBox(uint64_t box) {
  LocalCalls::CloseBox(box);
  TellMaster<&SystemCalls::CloseBox>(master_, box);
}

// Returns true for every reply box, because this process does not know which boxes of objects in
// other processes are open.  The master checks the box when the reply is posted.
bool WorkerCalls::AcceptsReply(ObjectId, uint64_t) const { return true; }

const Message* WorkerCalls::BeginWait(uint64_t box, int64_t timeout_us, std::string_view why) {
  master_->RecordWait(box, timeout_us, why);
  return nullptr;
}

size_t WorkerCalls::ReadLine(char* buffer, size_t size) {
  Object* const self = t_current.object;
  const uint64_t box = system_->requests().OpenBox();
  master_->RecordWaitForLine(box, size);
  self->wait().set_why(ConsoleInput::kWaitReason);
  const OwnedMessage line = system_->dispatcher().WaitFor(box);
  self->wait().set_why("");
  self->boxes().Close(box);
  const size_t count = std::min<size_t>(line->size, size);
  std::memcpy(buffer, line->payload, count);
  return count;
}

void WorkerCalls::SetQueueMax(int32_t messages) {
  LocalCalls::SetQueueMax(messages);
  TellMaster<&SystemCalls::SetQueueMax>(master_, messages);
}

uint32_t WorkerCalls::AddTimedEvent(const TimeEvents::EventMessage& message, int64_t first_us,
                                    int64_t period_us) {
  return AskMaster<&SystemCalls::AddTimedEvent>(master_, message, first_us, period_us);
}

uint32_t WorkerCalls::AddReplyEvent(const TimeEvents::EventMessage& message, uint64_t box) {
  return AskMaster<&SystemCalls::AddReplyEvent>(master_, message, box);
}

bool WorkerCalls::CancelEvent(uint32_t event) {
  return AskMaster<&SystemCalls::CancelEvent>(master_, event);
}

int WorkerCalls::CountEvents() { return AskMaster<&SystemCalls::CountEvents>(master_); }

int32_t WorkerCalls::RegisterName(ObjectId object, std::string_view name) {
  return AskMaster<&SystemCalls::RegisterName>(master_, object, name);
}

int32_t WorkerCalls::FindName(std::string_view name, ObjectId* object) {
  return AskMaster<&SystemCalls::FindName>(master_, name, object);
}

int32_t WorkerCalls::UnregisterName(std::string_view name) {
  return AskMaster<&SystemCalls::UnregisterName>(master_, name);
}

OStatus WorkerCalls::RegisterService(ObjectId object, uint32_t selector, std::string_view name) {
  const OStatus status = AskMaster<&SystemCalls::RegisterService>(master_, object, selector, name);
  if (status == oSUCCESS) t_current.object->entry_names().SetService(selector, std::string(name));
  return status;
}

void WorkerCalls::NameEntry(uint32_t selector, std::string_view name) {
  LocalCalls::NameEntry(selector, name);
  TellMaster<&SystemCalls::NameEntry>(master_, selector, name);
}

// Makes a region and returns its id.  The master assigns the id; the memory is in this process.
uint32_t WorkerCalls::NewRegion(size_t size, ObjectId owner) {
  const uint32_t region = AskMaster<&SystemCalls::NewRegion>(master_, size, owner);
  const bool has_memory = system_->regions().AdoptOwn(region, size, owner) != nullptr;
  return has_memory ? region : RegionTable::kNoRegion;
}

bool WorkerCalls::DeleteRegion(uint32_t region) {
  if (!LocalCalls::DeleteRegion(region)) return false;
  TellMaster<&SystemCalls::DeleteRegion>(master_, region);
  return true;
}

bool WorkerCalls::ResizeRegion(uint32_t region, size_t size) {
  return AskMaster<&SystemCalls::ResizeRegion>(master_, region, size) &&
         LocalCalls::ResizeRegion(region, size);
}

bool WorkerCalls::PinRegion(uint32_t region) {
  if (!LocalCalls::PinRegion(region)) return false;
  TellMaster<&SystemCalls::PinRegion>(master_, region);
  return true;
}

bool WorkerCalls::UnpinRegion(uint32_t region) {
  if (!LocalCalls::UnpinRegion(region)) return false;
  TellMaster<&SystemCalls::UnpinRegion>(master_, region);
  return true;
}

int32_t WorkerCalls::AllowAccess(uint32_t region, MemoryProtectionInfo info, ObjectId other,
                                 bool giving_ownership) {
  return AskMaster<&SystemCalls::AllowAccess>(master_, region, info, other, giving_ownership);
}

int32_t WorkerCalls::Attach(uint32_t region, MemoryProtectionInfo info) {
  return AskMaster<&SystemCalls::Attach>(master_, region, info);
}

int32_t WorkerCalls::Detach(uint32_t region) {
  return AskMaster<&SystemCalls::Detach>(master_, region);
}

int32_t WorkerCalls::CheckAccess(uint32_t region, MemoryProtectionInfo info) {
  return AskMaster<&SystemCalls::CheckAccess>(master_, region, info);
}

void WorkerCalls::NoteMapping(uint32_t cookie, uint32_t region, bool is_mapped) {
  TellMaster<&SystemCalls::NoteMapping>(master_, cookie, region, is_mapped);
}

void WorkerCalls::AddFinding(const Object* about, Severity severity, std::string_view text) {
  LocalCalls::AddFinding(about, severity, text);
  const ObjectId id = about == nullptr ? kNoObject : about->id;
  TellMaster<&CheckedCalls::AddFindingAbout>(master_, id, severity, text);
}

void WorkerCalls::Shutdown(int robot, const RunEnd& why) {
  TellMaster<&SystemCalls::Shutdown>(master_, robot, why);
}

// Switches the robot off.  Objects in this process are switched off at once, all other objects when
// the master receives the call.
void WorkerCalls::PowerOff(int robot, const RunEnd& why) {
  TellMaster<&SystemCalls::PowerOff>(master_, robot, why);
  LocalCalls::PowerOff(robot, why);
}

// Tells the master that the object is about to change a file, and waits for the answer.  So the
// master learns of the change before the change begins, and can still read the old file.
bool WorkerCalls::NoteFileWritten(std::string_view path) {
  return LocalCalls::NoteFileWritten(path) &&
         AskMaster<&SystemCalls::NoteFileWritten>(master_, path);
}

}  // namespace openr_host

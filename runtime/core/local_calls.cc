#include "runtime/core/local_calls.h"

#include <sError.h>

#include <string>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

Robot& RobotOfCaller(System* system) { return system->robot(t_current.object->robot); }

}  // namespace

int32_t LocalCalls::Post(OwnedMessage&& message, int64_t delay_us) {
  Object* const target = system_->object(message->target);
  return system_->poster().Post(std::move(message), target, delay_us);
}

void LocalCalls::OpenBox(uint64_t box) {
  Object* const self = t_current.object;
  self->boxes().Open(box);
}

void LocalCalls::CloseBox(uint64_t box) {
  Object* const self = t_current.object;
  if (self->boxes().Close(box)) system_->time_events().ForgetBox(self->id, box);
}

bool LocalCalls::AcceptsReply(ObjectId asker, uint64_t box) const {
  return system_->object(asker)->boxes().IsOpen(box);
}

const Message* LocalCalls::BeginWait(uint64_t box, int64_t timeout_us, std::string_view) {
  if (timeout_us < 0) return nullptr;
  // Makes the current object send itself an empty reply that arrives after `timeout_us` and ends
  // the object's wait for a reply.  Requests::Await() recognizes this reply by its sender and its
  // kind.
  OwnedMessage message = system_->NewMessage(t_current.object->id, 0);
  Message* const wake = message.get();
  wake->is_reply = true;
  wake->reply_box = box;
  // The sender of a message of kind kHashed must set its payload hash.  This reply has no bytes, so
  // any constant will do.
  wake->payload_hash = 1;
  wake->kind = PayloadKind::kHashed;
  system_->Post(std::move(message), timeout_us);
  return wake;
}

size_t LocalCalls::ReadLine(char* buffer, size_t size) {
  return system_->console_input().Read(buffer, size);
}

void LocalCalls::SetQueueMax(int32_t messages) { t_current.object->set_queue_max(messages); }

uint32_t LocalCalls::AddTimedEvent(const TimeEvents::EventMessage& message, int64_t first_us,
                                   int64_t period_us) {
  return system_->time_events().AddTimed(message, first_us, period_us);
}

uint32_t LocalCalls::AddReplyEvent(const TimeEvents::EventMessage& message, uint64_t box) {
  const uint32_t event = system_->time_events().AddReply(message, box);
  Object* const self = t_current.object;
  self->boxes().NoteEvent(box);
  // If the reply is already in its box, posts `message` now.  Otherwise `message` would never be
  // posted, because no further reply arrives.
  if (self->boxes().HasReply(box)) system_->time_events().ReplyArrived(self->id, box);
  return event;
}

bool LocalCalls::CancelEvent(uint32_t event) {
  return system_->time_events().Cancel(t_current.object->id, event);
}

int LocalCalls::CountEvents() { return system_->time_events().CountOf(t_current.object->id); }

int32_t LocalCalls::RegisterName(ObjectId object, std::string_view name) {
  ObjectId known = kNoObject;
  if (FindName(name, &known) == sSUCCESS) return sFAIL;
  RobotOfCaller(system_).names[std::string(name)] = object;
  return sSUCCESS;
}

int32_t LocalCalls::FindName(std::string_view name, ObjectId* object) {
  const Robot& robot = RobotOfCaller(system_);
  // Finds an object by the name in its .ocf file first: an object has this name even if it has not
  // called Register().
  if (const Object* const loaded = system_->FindObject(robot.index, name)) {
    *object = loaded->id;
    return sSUCCESS;
  }
  const auto found = robot.names.find(std::string(name));
  if (found == robot.names.end() || system_->object(found->second) == nullptr) return sOBJNOTFOUND;
  *object = found->second;
  return sSUCCESS;
}

int32_t LocalCalls::UnregisterName(std::string_view name) {
  return RobotOfCaller(system_).names.erase(std::string(name)) == 1 ? sSUCCESS : sOBJNOTFOUND;
}

OStatus LocalCalls::RegisterService(ObjectId object, uint32_t selector, std::string_view name) {
  auto& directory = RobotOfCaller(system_).directory;
  if (!directory.emplace(name, std::pair(object, selector)).second) return oALREADY_EXIST;
  t_current.object->entry_names().SetService(selector, std::string(name));
  return oSUCCESS;
}

void LocalCalls::NameEntry(uint32_t selector, std::string_view name) {
  t_current.object->entry_names().SetName(selector, std::string(name));
}

uint32_t LocalCalls::NewRegion(size_t size, ObjectId owner) {
  return system_->regions().New(size, owner);
}

bool LocalCalls::DeleteRegion(uint32_t region) { return system_->regions().Delete(region); }

bool LocalCalls::ResizeRegion(uint32_t region, size_t size) {
  return system_->regions().Resize(region, size);
}

bool LocalCalls::PinRegion(uint32_t region) { return system_->regions().Pin(region); }
bool LocalCalls::UnpinRegion(uint32_t region) { return system_->regions().Unpin(region); }

int32_t LocalCalls::AllowAccess(uint32_t region, MemoryProtectionInfo info, ObjectId other,
                                bool giving_ownership) {
  return system_->region_shares().Allow(t_current.object->id, region, info, other,
                                        giving_ownership);
}

int32_t LocalCalls::Attach(uint32_t region, MemoryProtectionInfo info) {
  return system_->region_shares().Attach(t_current.object->id, region, info);
}

int32_t LocalCalls::Detach(uint32_t region) {
  return system_->region_shares().Detach(t_current.object->id, region);
}

int32_t LocalCalls::CheckAccess(uint32_t region, MemoryProtectionInfo info) {
  return system_->region_shares().ChangeProtection(t_current.object->id, region, info);
}

// Does nothing.  A worker must tell the IPStack in the master which buffers of the IPStack a
// program has mapped; in this process the IPStack knows this already.
void LocalCalls::NoteMapping(uint32_t, uint32_t, bool) {}

void LocalCalls::AddFinding(const Object* about, Severity severity, std::string_view text) {
  system_->RecordFinding(about, severity, std::string(text));
}

void LocalCalls::Shutdown(int robot, const RunEnd& why) {
  system_->robot_table().BeginShutdown(robot, why);
}

void LocalCalls::PowerOff(int robot, const RunEnd& why) {
  system_->robot_table().CutPower(robot, why);
}

bool LocalCalls::NoteFileWritten(std::string_view path) {
  if (MemoryStick* const stick = RobotOfCaller(system_).stick.get()) stick->NoteWritten(path);
  return true;
}

}  // namespace openr_host

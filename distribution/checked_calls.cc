#include "distribution/checked_calls.h"

#include <fmt/format.h>
#include <sError.h>

#include <algorithm>
#include <cstring>

#include "runtime/api/mcoop_limits.h"
#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/robot_services.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"

namespace openr_host {
namespace {

// Largest value of a time, in microseconds, that the master accepts from a worker.  Programs give
// times as RelativeTime, with 32 bits for seconds and 32 bits for milliseconds, and the longest
// RelativeTime is shorter than this limit.  So a value above the limit is an error of the worker
// and is refused.
constexpr int64_t kTimeMaxUs = int64_t{1} << 53;

// Largest number of bytes that the master returns for a ControlPrimitive() request.  A faulty
// worker that asks for more gets only this number.
constexpr uint64_t kResultMax = 1024;

bool IsTime(int64_t time_us) { return time_us >= 0 && time_us <= kTimeMaxUs; }

// Returns whether a worker is loading `object` for the first time.  The stand-in of such an object
// gets its entries when its constructors have returned.
bool IsLoading(const Object& object) {
  return !object.HasEntry(oentryINIT) && !object.has_early_work();
}

TimeEvents::EventMessage MessageOfCaller(const TimeEvents::EventMessage& message) {
  TimeEvents::EventMessage own = message;
  own.owner = t_current.object->id;
  return own;
}

}  // namespace

// Opens a reply box.  Ignores a box that is open already, and box 0, which no object has: only a
// faulty worker opens them.  Refuses a box that no object reaches by counting, because the next
// boxes of the object count from there: they would be wake boxes, or their count would overflow.
void CheckedCalls::OpenBox(uint64_t box) {
  if (box >= kFirstWakeBox) refuse_(fmt::format("the reply box {}", box));
  if (box != 0 && !t_current.object->boxes().IsOpen(box)) LocalCalls::OpenBox(box);
}

uint32_t CheckedCalls::AddTimedEvent(const TimeEvents::EventMessage& message, int64_t first_us,
                                     int64_t period_us) {
  if (!IsTime(first_us) || !IsTime(period_us)) return 0;
  return LocalCalls::AddTimedEvent(MessageOfCaller(message), first_us, period_us);
}

uint32_t CheckedCalls::AddReplyEvent(const TimeEvents::EventMessage& message, uint64_t box) {
  return box == 0 ? 0 : LocalCalls::AddReplyEvent(MessageOfCaller(message), box);
}

int32_t CheckedCalls::RegisterName(ObjectId object, std::string_view name) {
  if (name.empty()) return sINVALIDARG;
  if (name.size() > kObjectNameMax) return sOBLETNAMETOOLONG;
  if (system_->object(object) == nullptr) return sINVALIDOID;
  return LocalCalls::RegisterName(object, name);
}

// Lets constructors find neither their own object nor the names that they have registered for it.
// A run in one process has the same result, because an object whose constructors run is in no
// table yet.
int32_t CheckedCalls::FindName(std::string_view name, ObjectId* object) {
  const int32_t error = LocalCalls::FindName(name, object);
  const bool is_found = error == sSUCCESS && *object == t_current.object->id;
  return is_found && IsLoading(*t_current.object) ? sOBJNOTFOUND : error;
}

OStatus CheckedCalls::RegisterService(ObjectId object, uint32_t selector, std::string_view name) {
  if (!is_own_(object) || name.size() > oserviceNAME_MAX) return oFAIL;
  Object* const self = t_current.object;
  if (!self->has_early_work() || object != self->id)
    return LocalCalls::RegisterService(object, selector, name);
  // Keeps the name of the service until this object, which is of a restarted worker, replaces the
  // lost object.  Until then the directory may have the same name for the lost object.
  const auto& directory = system_->robot(self->robot).directory;
  const auto found = directory.find(std::string(name));
  const bool is_of_other = found != directory.end() && found->second.first != object;
  if (is_of_other || !self->KeepEarlyService(std::string(name), selector)) return oALREADY_EXIST;
  self->entry_names().SetService(selector, std::string(name));
  return oSUCCESS;
}

uint32_t CheckedCalls::NewRegion(size_t size, ObjectId owner) {
  const bool is_allowed = size <= kRobotMemoryBytes && (owner == kNoObject || is_own_(owner));
  return is_allowed ? LocalCalls::NewRegion(size, owner) : RegionTable::kNoRegion;
}

bool CheckedCalls::DeleteRegion(uint32_t region) {
  if (!is_own_(system_->regions().OwnerOf(region)))
    refuse_("the end of a region that is not its own");
  return LocalCalls::DeleteRegion(region);
}

bool CheckedCalls::ResizeRegion(uint32_t region, size_t size) {
  return is_own_(system_->regions().OwnerOf(region)) && LocalCalls::ResizeRegion(region, size);
}

bool CheckedCalls::PinRegion(uint32_t region) {
  ++pins_[region];
  return LocalCalls::PinRegion(region);
}

bool CheckedCalls::UnpinRegion(uint32_t region) {
  const auto pins = pins_.find(region);
  // Refuses to unpin a region that the worker has not pinned.  A pin keeps the memory of a region,
  // so a faulty worker could otherwise free regions of other objects.
  if (pins == pins_.end()) refuse_("a region given back twice");
  ASSERT(pins->second > 0, "{} pins of region {:#x}", pins->second, region);
  if (--pins->second == 0) pins_.erase(pins);
  return LocalCalls::UnpinRegion(region);
}

void CheckedCalls::ReleasePins() {
  for (const auto& [region, count] : pins_) {
    ASSERT(count > 0, "{} pins of region {:#x}", count, region);
    for (int i = 0; i < count; ++i) LocalCalls::UnpinRegion(region);
  }
  pins_.clear();
}

bool CheckedCalls::HasRegion(uint32_t region) const {
  const RegionTable& regions = system_->regions();
  return is_own_(regions.OwnerOf(region)) || is_own_(regions.MakerOf(region));
}

// Records in the master that an object in the worker has mapped or unmapped a buffer of the network
// stack (IPStack).  The IPStack in the master needs the record, because it lets an object send only
// data in a mapped buffer.
void CheckedCalls::NoteMapping(uint32_t cookie, uint32_t region, bool is_mapped) {
  IpStack* const stack = IpStack::OfCurrent();
  if (stack == nullptr) return;
  const antSharedBuffer buffer(region, 0, cookie);
  void* base = nullptr;
  if (is_mapped) {
    stack->buffers().Map(buffer, &base);
  } else {
    stack->buffers().UnMap(buffer);
  }
}

void CheckedCalls::CheckRobot(int robot, const RunEnd& why) const {
  const Object* const self = t_current.object;
  if (robot < 0 || robot >= system_->robot_count()) refuse_("an unknown robot");
  if (self != nullptr && robot != self->robot) refuse_("the end of another robot");
  if (static_cast<int>(why.kind) >= kEndKinds) refuse_("an end of an unknown kind");
}

void CheckedCalls::Shutdown(int robot, const RunEnd& why) {
  CheckRobot(robot, why);
  LocalCalls::Shutdown(robot, why);
}

void CheckedCalls::PowerOff(int robot, const RunEnd& why) {
  CheckRobot(robot, why);
  LocalCalls::PowerOff(robot, why);
}

void CheckedCalls::AddFindingAbout(ObjectId about, Severity severity, std::string_view text) {
  const bool is_known = severity >= Severity::kError && severity <= Severity::kNote;
  AddFinding(system_->object(about), is_known ? severity : Severity::kError, text);
}

OStatus CheckedCalls::ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request,
                                       const std::string& parameter, uint64_t result_size,
                                       std::string* result) {
  // Copies the parameter, because ControlPrimitive() may write into the memory of its argument, and
  // `parameter` is const.
  std::string parameter_copy = parameter;
  result->assign(std::min(result_size, kResultMax), '\0');
  return system_->robot(t_current.object->robot)
      .services->ControlPrimitive(id, request, parameter.empty() ? nullptr : parameter_copy.data(),
                                  parameter.size(), result->empty() ? nullptr : result->data(),
                                  result->size());
}

OStatus CheckedCalls::SetCdtVectorData(uint32_t region, const std::string& bytes) {
  char* const base = system_->regions().BaseOf(region);
  if (base != nullptr && !HasRegion(region)) {
    system_->AddFinding(Severity::kError,
                        fmt::format("SetCdtVectorData({:#x}): the memory is in another process of "
                                    "a distributed run; place both objects in one",
                                    region));
    return oINVALID_ARG;
  }
  if (base != nullptr)
    std::memcpy(base, bytes.data(), std::min(bytes.size(), system_->regions().SizeOf(region)));
  return system_->robot(t_current.object->robot).services->SetCdtVectorData(region);
}

}  // namespace openr_host

// CheckedCalls: the functions of the master that handlers in a worker process may call.
//
// A worker may be faulty, so the master checks each call before it does what the call asks for: a
// worker may act only for its own objects, memory regions and robots.
#pragma once

#include <OPENR/OPENRAPI.h>

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "runtime/core/local_calls.h"

namespace openr_host {

// First number of the wake boxes, the reply boxes of stand-ins.  In a free run, while a handler of
// an object runs in a worker, the object's stand-in waits for a reply to its wake box.  The master
// posts the reply when the handler has returned or waits.  The boxes that objects open themselves
// count from 1 and never reach this number, so a wake box never has the number of such a box.
constexpr uint64_t kFirstWakeBox = uint64_t{1} << 40;

class CheckedCalls : public LocalCalls {
 public:
  // A function that returns whether an object runs in the worker.  The worker may act only for such
  // objects.
  using IsOwn = std::function<bool(ObjectId)>;
  // A function that throws ProcessLost.  The message says that the worker has sent `what`, which is
  // not allowed.
  using Refuse = std::function<void(const std::string& what)>;

  CheckedCalls(System* system, IsOwn is_own, Refuse refuse)
      : LocalCalls(system), is_own_(std::move(is_own)), refuse_(std::move(refuse)) {}

  void OpenBox(uint64_t box) override;
  uint32_t AddTimedEvent(const TimeEvents::EventMessage& message, int64_t first_us,
                         int64_t period_us) override;
  uint32_t AddReplyEvent(const TimeEvents::EventMessage& message, uint64_t box) override;
  int32_t RegisterName(ObjectId object, std::string_view name) override;
  int32_t FindName(std::string_view name, ObjectId* object) override;
  OStatus RegisterService(ObjectId object, uint32_t selector, std::string_view name) override;
  uint32_t NewRegion(size_t size, ObjectId owner) override;
  bool DeleteRegion(uint32_t region) override;
  bool ResizeRegion(uint32_t region, size_t size) override;
  bool PinRegion(uint32_t region) override;
  bool UnpinRegion(uint32_t region) override;
  void NoteMapping(uint32_t cookie, uint32_t region, bool is_mapped) override;
  void Shutdown(int robot, const RunEnd& why) override;
  void PowerOff(int robot, const RunEnd& why) override;

  // Adds a finding (an error, warning or note for the report of the run) about the object `about`;
  // if `about` is kNoObject, the finding is about the system.
  void AddFindingAbout(ObjectId about, Severity severity, std::string_view text);

  // ControlPrimitive() and SetCdtVectorData() get the bytes of a block of memory in place of its
  // address, because an address in the worker means nothing in the master.
  OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, const std::string& parameter,
                           uint64_t result_size, std::string* result);
  // Copies `bytes`, the colour tables for the camera, to `region`, then calls
  // RobotServices::SetCdtVectorData().
  OStatus SetCdtVectorData(uint32_t region, const std::string& bytes);

  // Returns whether an object of the worker owns the region or has made it.  The maker counts, too:
  // its process keeps the bytes of the region, even if another object owns the region now.
  bool HasRegion(uint32_t region) const;

  // Removes all pins of the worker's objects after the worker was lost.  A pin keeps the memory of
  // a region, so a pin that is not removed would keep this memory for ever.
  void ReleasePins();

 private:
  void CheckRobot(int robot, const RunEnd& why) const;

  const IsOwn is_own_;
  const Refuse refuse_;
  // For each region that the worker's objects have pinned, the number of their pins (> 0).  These
  // pins keep the memory of the region.
  std::map<uint32_t, int> pins_;
};

}  // namespace openr_host

// LocalCalls: the SystemCalls of a System that runs handlers in its own process.  SystemCalls are
// the functions of a System that handlers call.
#pragma once

#include "runtime/core/system_calls.h"

namespace openr_host {

class System;

class LocalCalls : public SystemCalls {
 public:
  // `system` must outlive this object.
  explicit LocalCalls(System* system) : system_(system) {}

  int32_t Post(OwnedMessage&& message, int64_t delay_us) override;
  void OpenBox(uint64_t box) override;
  void CloseBox(uint64_t box) override;
  bool AcceptsReply(ObjectId asker, uint64_t box) const override;
  const Message* BeginWait(uint64_t box, int64_t timeout_us, std::string_view why) override;
  size_t ReadLine(char* buffer, size_t size) override;
  void SetQueueMax(int32_t messages) override;
  uint32_t AddTimedEvent(const TimeEvents::EventMessage& message, int64_t first_us,
                         int64_t period_us) override;
  uint32_t AddReplyEvent(const TimeEvents::EventMessage& message, uint64_t box) override;
  bool CancelEvent(uint32_t event) override;
  int CountEvents() override;
  int32_t RegisterName(ObjectId object, std::string_view name) override;
  int32_t FindName(std::string_view name, ObjectId* object) override;
  int32_t UnregisterName(std::string_view name) override;
  OStatus RegisterService(ObjectId object, uint32_t selector, std::string_view name) override;
  void NameEntry(uint32_t selector, std::string_view name) override;
  uint32_t NewRegion(size_t size, ObjectId owner) override;
  bool DeleteRegion(uint32_t region) override;
  bool ResizeRegion(uint32_t region, size_t size) override;
  bool PinRegion(uint32_t region) override;
  bool UnpinRegion(uint32_t region) override;
  int32_t AllowAccess(uint32_t region, MemoryProtectionInfo info, ObjectId other,
                      bool giving_ownership) override;
  int32_t Attach(uint32_t region, MemoryProtectionInfo info) override;
  int32_t Detach(uint32_t region) override;
  int32_t CheckAccess(uint32_t region, MemoryProtectionInfo info) override;
  void NoteMapping(uint32_t cookie, uint32_t region, bool is_mapped) override;
  void AddFinding(const Object* about, Severity severity, std::string_view text) override;
  void Shutdown(int robot, const RunEnd& why) override;
  void PowerOff(int robot, const RunEnd& why) override;
  bool NoteFileWritten(std::string_view path) override;

 protected:
  System* const system_;
};

}  // namespace openr_host

// Stands in the master's System for an object whose code runs in another process.
#pragma once

#include <OPENR/ObjcommTypes.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "runtime/core/object.h"

class RCRegion;

namespace openr_host {

class RemoteProcess;

class RemoteObject : public Object {
 public:
  // How a process was lost; kAtEnd: when all that was wanted of it was what it had come to.
  enum class Loss { kGone, kCrashed, kAtEnd };
  // Hears of it, in the handler that found out.
  using LossListener = std::function<void(const RemoteObject*, Loss, const std::string& why)>;

  RemoteObject(System* system, ObjectId id, int robot, RemoteProcess* process, LossListener lost)
      : Object(system, id, robot), process_(process), lost_(std::move(lost)) {}

  RemoteProcess* process() const { return process_; }
  void set_selectors(std::set<uint32_t> selectors) { selectors_ = std::move(selectors); }

  // Messages that came, or were to come, when the process was lost; nobody heard them.
  uint64_t unheard_count = 0;
  // Notifications that waited in its subjects when its last handler ended.
  uint64_t pending_count = 0;
  uint64_t heap_max = 0;  // bytes that it had at most

  // One in its place, for a process that has come back.
  std::unique_ptr<RemoteObject> NewInstance() const;

  // A subject there has sent to an observer that was ready.
  void UseReady(const StandingReady& ready) { readies_.erase(ready); }

  // The object `observer` has been replaced.
  void ForgetObserver(ObjectId observer);

  std::vector<StandingReady> StandingReadies() const override;
  void TakeBack(RCRegion* region) override;
  void Unheard(const Message& message) override;  // and who waits for an answer need not
  bool IsLost() const override;
  bool IsAtWorkElsewhere() const override;
  bool HasEntry(uint32_t selector) const override { return selectors_.contains(selector); }
  bool Dispatch(uint32_t selector, void* payload) override;
  void HashState(Hasher* hasher) const override;

 private:
  bool Run();
  void RecordReady();
  void SendEmptyReply(const Message& request);

  RemoteProcess* const process_;
  const LossListener lost_;
  std::set<uint32_t> selectors_;
  // Who asserted ready for a subject there and has been sent nothing since.
  std::set<StandingReady> readies_;
};

}  // namespace openr_host

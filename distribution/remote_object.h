// Stands in the master's System for an object whose code runs in another process.
#pragma once

#include <functional>
#include <set>
#include <string>

#include "runtime/core/object.h"

namespace openr_host {

class RemoteProcess;

class RemoteObject : public Object {
 public:
  // `lost` hears why the process was lost, in the handler that found out.
  RemoteObject(System* system, ObjectId id, int robot, RemoteProcess* process,
               std::function<void(RemoteObject*, const std::string&)> lost)
      : Object(system, id, robot), process_(process), lost_(std::move(lost)) {}

  RemoteProcess* process() const { return process_; }
  void set_selectors(std::set<uint32_t> selectors) { selectors_ = std::move(selectors); }

  bool HasEntry(uint32_t selector) const override { return selectors_.contains(selector); }
  bool Dispatch(uint32_t selector, void* payload) override;
  void HashState(Hasher* hasher) const override;

 private:
  RemoteProcess* const process_;
  const std::function<void(RemoteObject*, const std::string&)> lost_;
  std::set<uint32_t> selectors_;
};

}  // namespace openr_host

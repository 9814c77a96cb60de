// Who may use whose shared memory: AllowToAttachMemoryRegion() and its kin (MCOOP.h).
//
// As in the robot's memory-protected configuration: a region belongs to the object that made
// it; any other needs its leave, else error 44 (field-notes.md, 3.1).  Only answers follow from
// this; what a region holds can be reached by every object, as without protection.
#pragma once

#include <MemoryRegion.h>

#include <cstdint>
#include <map>
#include <utility>

#include "runtime/core/message.h"

namespace openr_host {

class RegionTable;

class RegionShares {
 public:
  explicit RegionShares(RegionTable* regions) : regions_(regions) {}

  // All return an sError; `self` is the object that calls.
  int32_t Allow(ObjectId self, uint32_t region, MemoryProtectionInfo info, ObjectId other,
                bool giving_ownership);
  int32_t Attach(ObjectId self, uint32_t region, MemoryProtectionInfo info);
  int32_t Detach(ObjectId self, uint32_t region);
  int32_t ChangeProtection(ObjectId self, uint32_t region, MemoryProtectionInfo info);

  // Whether `self` may write to `region` on a robot with memory protection: it is its own, or its
  // owner has allowed it.  In another process than its owner's only what is its own counts.
  bool MayWrite(ObjectId self, uint32_t region) const;

 private:
  struct Share {
    MemoryProtectionInfo allowed = MEMPROTINFO_INVALID;
    bool attached = false;
  };

  // sSUCCESS when `self` may have `region` with `info`.
  int32_t Check(ObjectId self, uint32_t region, MemoryProtectionInfo info) const;

  RegionTable* const regions_;
  std::map<std::pair<uint32_t, ObjectId>, Share> shares_;
};

}  // namespace openr_host

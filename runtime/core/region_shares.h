// RegionShares: the access rights of objects to regions (blocks of shared memory), for
// AllowToAttachMemoryRegion() and similar functions of MCOOP.h.
//
// The rules are those of the robot's memory-protected configuration: a region belongs to the object
// that made it, and another object needs the owner's permission.  Without the permission the other
// object gets error 44 (field-notes.md, 3.1).  The rights decide only what these functions return.
// As on a robot without protection, every object can still read and write every region.
#pragma once

#include <MemoryRegion.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "runtime/core/message.h"

namespace openr_host {

class RegionTable;

class RegionShares {
 public:
  explicit RegionShares(RegionTable* regions) : regions_(regions) {}

  // The next four functions do the work of AllowToAttachMemoryRegion(), AttachMemoryRegion(),
  // DetachMemoryRegion() and ChangeProtectionMemoryRegion().  `self` is the object that calls them,
  // and `info` is the right to read, or to read and write.  Allow() gives this right to `other`,
  // and with `giving_ownership` makes `other` the owner.  All return an sError.
  int32_t Allow(ObjectId self, uint32_t region, MemoryProtectionInfo info, ObjectId other,
                bool giving_ownership);
  int32_t Attach(ObjectId self, uint32_t region, MemoryProtectionInfo info);
  int32_t Detach(ObjectId self, uint32_t region);
  int32_t ChangeProtection(ObjectId self, uint32_t region, MemoryProtectionInfo info);

  // Returns whether `self` may write to `region` on a robot with memory protection: `self` owns the
  // region, or the owner has allowed it.  In a run with several processes only the master process
  // knows what owners have allowed, so in a worker process only the owner may write.
  bool MayWrite(ObjectId self, uint32_t region) const;

  // Returns the number of records of rights and attached objects.  Records about deleted regions
  // are removed only from time to time (ShareOf()), so some of them may be included.
  size_t count() const { return shares_.size(); }

 private:
  struct Share {
    MemoryProtectionInfo allowed = MEMPROTINFO_INVALID;
    bool attached = false;
  };

  // Returns sSUCCESS if `self` may use `region` with the rights `info` (to read, or to read and
  // write), otherwise an sError.  The owner has all rights; other objects have the rights that
  // Allow() gave them.
  int32_t Check(ObjectId self, uint32_t region, MemoryProtectionInfo info) const;
  Share& ShareOf(uint32_t region, ObjectId object);

  RegionTable* const regions_;
  std::map<std::pair<uint32_t, ObjectId>, Share> shares_;
  // ShareOf() removes the rights to deleted regions when shares_ has this size.
  size_t cleanup_size_ = 64;
};

}  // namespace openr_host

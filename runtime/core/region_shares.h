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
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class RegionTable;
class Uplink;

class RegionShares {
 public:
  explicit RegionShares(RegionTable* regions) : regions_(regions) {}

  // Of a System that runs handlers for another one, which keeps the shares.
  void set_uplink(Uplink* uplink) { uplink_ = uplink; }

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

  // What the uplink of another process asked for.
 public:
  int32_t Serve(ObjectId self, const std::vector<uint64_t>& numbers);

 private:
  // sSUCCESS when `self` may have `region` with `info`.
  int32_t Check(ObjectId self, uint32_t region, MemoryProtectionInfo info) const;

  enum class ShareCall : uint64_t { kAllow, kAttach, kDetach, kCheck };
  int32_t AskUplink(ShareCall call, uint32_t region, MemoryProtectionInfo info, ObjectId other,
                    bool giving_ownership) const;

  RegionTable* const regions_;
  Uplink* uplink_ = nullptr;
  std::map<std::pair<uint32_t, ObjectId>, Share> shares_;
};

}  // namespace openr_host

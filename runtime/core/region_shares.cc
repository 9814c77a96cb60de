#include "runtime/core/region_shares.h"

#include <sError.h>

#include <algorithm>

#include "runtime/core/region_table.h"

namespace openr_host {
namespace {

bool IsProtection(MemoryProtectionInfo info) {
  return info == MEMPROTINFO_R || info == MEMPROTINFO_RW;
}

}  // namespace

int32_t RegionShares::Check(ObjectId self, uint32_t region, MemoryProtectionInfo info) const {
  if (regions_->BaseOf(region) == nullptr) return sINVALIDSHAREDMEMID;
  if (!IsProtection(info)) return sINVALIDSHAREDMEMPROTECT;
  if (regions_->OwnerOf(region) == self) return sSUCCESS;
  const auto found = shares_.find({region, self});
  return found != shares_.end() && found->second.allowed >= info ? sSUCCESS
                                                                 : sPERMISSIONDENIEDSHAREDMEM;
}

// Returns the record of the rights of `object` to `region`, and adds this record if there is none.
// If shares_ has grown to cleanup_size_, first removes the records of deleted regions.  The
// deletion of a region does not remove them, because regions are deleted for many messages, and few
// programs use rights.
RegionShares::Share& RegionShares::ShareOf(uint32_t region, ObjectId object) {
  if (const auto found = shares_.find({region, object}); found != shares_.end())
    return found->second;
  if (shares_.size() >= cleanup_size_) {
    // Keeps the record of an object that is attached, because the object may still detach.
    std::erase_if(shares_, [this](const auto& entry) {
      return !entry.second.attached && regions_->BaseOf(entry.first.first) == nullptr;
    });
    // Raises cleanup_size_ to at least twice the number of the remaining records.  So the search
    // for records of deleted regions is rare.
    cleanup_size_ = std::max(cleanup_size_, 2 * shares_.size());
  }
  return shares_[{region, object}];
}

bool RegionShares::MayWrite(ObjectId self, uint32_t region) const {
  return Check(self, region, MEMPROTINFO_RW) == sSUCCESS;
}

int32_t RegionShares::Allow(ObjectId self, uint32_t region, MemoryProtectionInfo info,
                            ObjectId other, bool giving_ownership) {
  if (regions_->BaseOf(region) == nullptr) return sINVALIDSHAREDMEMID;
  if (regions_->OwnerOf(region) != self) return sPERMISSIONDENIEDSHAREDMEM;
  if (!IsProtection(info)) return sINVALIDSHAREDMEMPROTECT;
  if (other == kNoObject) return sINVALIDOID;
  ShareOf(region, other).allowed = info;
  if (giving_ownership) {
    // The old owner (`self`), which gives the region to `other`, may still read and write the
    // region.  It counts as attached (AttachMemoryRegion()).
    ShareOf(region, self) = {MEMPROTINFO_RW, true};
    regions_->SetOwner(region, other);
  }
  return sSUCCESS;
}

int32_t RegionShares::Attach(ObjectId self, uint32_t region, MemoryProtectionInfo info) {
  const int32_t error = Check(self, region, info);
  if (error != sSUCCESS) return error;
  Share& share = ShareOf(region, self);
  if (share.attached) return sALREADYATTACHEDSHAREDMEM;
  share.attached = true;
  return sSUCCESS;
}

int32_t RegionShares::Detach(ObjectId self, uint32_t region) {
  const auto found = shares_.find({region, self});
  if (found == shares_.end() || !found->second.attached) return sINVALIDSHAREDMEMID;
  found->second.attached = false;
  return sSUCCESS;
}

int32_t RegionShares::ChangeProtection(ObjectId self, uint32_t region, MemoryProtectionInfo info) {
  return Check(self, region, info);
}

}  // namespace openr_host

#include "runtime/core/region_shares.h"

#include <sError.h>

#include "runtime/core/region_table.h"
#include "runtime/core/uplink.h"

namespace openr_host {
namespace {

bool IsProtection(MemoryProtectionInfo info) {
  return info == MEMPROTINFO_R || info == MEMPROTINFO_RW;
}

}  // namespace

int32_t RegionShares::AskUplink(ShareCall call, uint32_t region, MemoryProtectionInfo info,
                                ObjectId other, bool giving_ownership) const {
  return static_cast<int32_t>(
      uplink_
          ->Ask({QuestionKind::kCheckShare,
                 {static_cast<uint64_t>(call), region, static_cast<uint64_t>(info),
                  static_cast<uint64_t>(other), giving_ownership ? uint64_t{1} : uint64_t{0}}})
          .status);
}

int32_t RegionShares::Serve(ObjectId self, const std::vector<uint64_t>& numbers) {
  if (numbers.size() != 5) return sINVALIDARG;
  const auto region = static_cast<uint32_t>(numbers[1]);
  const auto info = static_cast<MemoryProtectionInfo>(numbers[2]);
  switch (static_cast<ShareCall>(numbers[0])) {
    case ShareCall::kAllow:
      return Allow(self, region, info, static_cast<ObjectId>(numbers[3]), numbers[4] != 0);
    case ShareCall::kAttach:
      return Attach(self, region, info);
    case ShareCall::kDetach:
      return Detach(self, region);
    case ShareCall::kCheck:
      return ChangeProtection(self, region, info);
  }
  return sINVALIDARG;
}

int32_t RegionShares::Check(ObjectId self, uint32_t region, MemoryProtectionInfo info) const {
  if (regions_->BaseOf(region) == nullptr) return sINVALIDSHAREDMEMID;
  if (!IsProtection(info)) return sINVALIDSHAREDMEMPROTECT;
  if (regions_->OwnerOf(region) == self) return sSUCCESS;
  const auto found = shares_.find({region, self});
  return found != shares_.end() && found->second.allowed >= info ? sSUCCESS
                                                                 : sPERMISSIONDENIEDSHAREDMEM;
}

bool RegionShares::MayWrite(ObjectId self, uint32_t region) const {
  return Check(self, region, MEMPROTINFO_RW) == sSUCCESS;
}

int32_t RegionShares::Allow(ObjectId self, uint32_t region, MemoryProtectionInfo info,
                            ObjectId other, bool giving_ownership) {
  if (uplink_ != nullptr)
    return AskUplink(ShareCall::kAllow, region, info, other, giving_ownership);
  if (regions_->BaseOf(region) == nullptr) return sINVALIDSHAREDMEMID;
  if (regions_->OwnerOf(region) != self) return sPERMISSIONDENIEDSHAREDMEM;
  if (!IsProtection(info)) return sINVALIDSHAREDMEMPROTECT;
  if (other == kNoObject) return sINVALIDOID;
  shares_[{region, other}].allowed = info;
  if (giving_ownership) {
    shares_[{region, self}] = {MEMPROTINFO_RW, true};
    regions_->SetOwner(region, other);
  }
  return sSUCCESS;
}

int32_t RegionShares::Attach(ObjectId self, uint32_t region, MemoryProtectionInfo info) {
  if (uplink_ != nullptr) return AskUplink(ShareCall::kAttach, region, info, kNoObject, false);
  const int32_t error = Check(self, region, info);
  if (error != sSUCCESS) return error;
  Share& share = shares_[{region, self}];
  if (share.attached) return sALREADYATTACHEDSHAREDMEM;
  share.attached = true;
  return sSUCCESS;
}

int32_t RegionShares::Detach(ObjectId self, uint32_t region) {
  if (uplink_ != nullptr)
    return AskUplink(ShareCall::kDetach, region, MEMPROTINFO_R, kNoObject, false);
  const auto found = shares_.find({region, self});
  if (found == shares_.end() || !found->second.attached) return sINVALIDSHAREDMEMID;
  found->second.attached = false;
  return sSUCCESS;
}

int32_t RegionShares::ChangeProtection(ObjectId self, uint32_t region, MemoryProtectionInfo info) {
  if (uplink_ != nullptr) return AskUplink(ShareCall::kCheck, region, info, kNoObject, false);
  return Check(self, region, info);
}

}  // namespace openr_host

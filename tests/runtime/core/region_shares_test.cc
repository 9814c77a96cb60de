// The access rights to regions that objects give each other.
#include "runtime/core/region_shares.h"

#include <gtest/gtest.h>
#include <sError.h>

#include <vector>

#include "runtime/core/region_table.h"

namespace openr_host {
namespace {

constexpr ObjectId kOwner = 1;
constexpr ObjectId kOther = 2;

class RegionSharesTest : public testing::Test {
 protected:
  // Makes a region, to which the owner and another object then attach.
  uint32_t NewShared() {
    const uint32_t region = table_.New(8, kOwner);
    EXPECT_EQ(shares_.Allow(kOwner, region, MEMPROTINFO_R, kOther, false), sSUCCESS);
    EXPECT_EQ(shares_.Attach(kOwner, region, MEMPROTINFO_RW), sSUCCESS);
    EXPECT_EQ(shares_.Attach(kOther, region, MEMPROTINFO_R), sSUCCESS);
    return region;
  }

  RegionTable table_;
  RegionShares shares_{&table_};
};

TEST_F(RegionSharesTest, TheRightsToDeletedRegionsAreForgotten) {
  for (int i = 0; i < 1000; ++i) {
    const uint32_t region = NewShared();
    EXPECT_EQ(shares_.Detach(kOther, region), sSUCCESS);
    EXPECT_EQ(shares_.Detach(kOwner, region), sSUCCESS);
    table_.Delete(region);
  }
  EXPECT_LE(shares_.count(), 64u);
}

TEST_F(RegionSharesTest, AnObjectDetachesFromADeletedRegion) {
  std::vector<uint32_t> deleted;
  for (int i = 0; i < 100; ++i) deleted.push_back(NewShared());
  for (const uint32_t region : deleted) table_.Delete(region);
  for (int i = 0; i < 1000; ++i) table_.Delete(NewShared());  // rights are removed meanwhile
  for (const uint32_t region : deleted) EXPECT_EQ(shares_.Detach(kOther, region), sSUCCESS);
}

TEST_F(RegionSharesTest, TheRightsToAllOtherRegionsAreKept) {
  std::vector<uint32_t> kept;
  for (int i = 0; i < 100; ++i) {
    kept.push_back(NewShared());
    table_.Delete(NewShared());
  }
  for (const uint32_t region : kept) {
    EXPECT_EQ(shares_.Detach(kOther, region), sSUCCESS);
    EXPECT_EQ(shares_.Attach(kOther, region, MEMPROTINFO_R), sSUCCESS);
  }
}

}  // namespace
}  // namespace openr_host

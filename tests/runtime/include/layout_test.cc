// Compiles layout_checks.h, in which the compiler checks layouts, and tests the accessors.
#include <gtest/gtest.h>

#include "tests/runtime/include/layout_checks.h"
#include "tests/runtime/include/message_layout_checks.h"

namespace {

// Offsets do not show whether the accessors find infos and data, so this is tested here.
TEST(LayoutTest, AVectorFindsItsDataThroughTheOffsetInTheInfo) {
  alignas(8) byte memory[192 + 2 * (32 + 128)] = {};
  auto* const vector = reinterpret_cast<OCommandVectorData*>(memory);
  vector->GetInfo(1)->dataOffset = 192 + 2 * 32 + 128;
  EXPECT_EQ(reinterpret_cast<byte*>(vector->GetInfo(1)), memory + 224);
  EXPECT_EQ(reinterpret_cast<byte*>(vector->GetData(1)), memory + 384);
}

TEST(LayoutTest, APhysicalAddressTakesAndGivesAPointer) {
  ODataVectorInfo info = {};
  info.physAddr = reinterpret_cast<void*>(0x1234);
  void* const pointer = info.physAddr;
  EXPECT_EQ(pointer, reinterpret_cast<void*>(0x1234));
}

}  // namespace

// Compiles layout_checks.h, in which the compiler checks layouts, and tests the accessors.
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OShmPtr.h>
#include <OPENR/OSubject.h>
#include <ObjectEntryTable.h>
#include <gtest/gtest.h>

#include "tests/runtime/include/layout_checks.h"
#include "tests/runtime/include/message_layout_checks.h"

// Sizes of the classes that images and the runtime have in common.  Images of an earlier build have
// the old size, so each change of one needs another kHeadersVersion (runtime/core/image_info.h).
#if __SIZEOF_POINTER__ == 8
CHECK_SIZE(OID, 8);
CHECK_SIZE(OServiceEntry, 16);
CHECK_SIZE(ObjectEntry, 16);
CHECK_SIZE(OObject, 16);
CHECK_SIZE(OSubject, 8);
CHECK_SIZE(OObserver, 8);
CHECK_SIZE(OObserverInfo, 16);
CHECK_SIZE(OSubjectInfo, 16);
CHECK_SIZE(RCRegion, 40);
CHECK_SIZE(OShmPtrBase, 16);
CHECK_SIZE(OMemoryLocator, 8);
CHECK_SIZE(OSystemEvent, 24);
CHECK_SIZE(ONotifyEvent, 240);
CHECK_SIZE(OReadyEvent, 32);
CHECK_SIZE(OConnectMessage, 152);
CHECK_SIZE(OControlMessage, 168);
CHECK_SIZE(ONotifyMessage, 344);
CHECK_SIZE(OReadyMessage, 136);
#endif

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

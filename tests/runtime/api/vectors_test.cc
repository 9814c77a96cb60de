// Tests of the memory of vectors (robot.md 3, 4.1 and 7.2; field-notes.md 3.4).
#include <OPENR/OPENRAPI.h>
#include <gtest/gtest.h>

#include "runtime/core/code_object.h"
#include "runtime/core/system.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

class VectorsTest : public testing::Test {
 protected:
  explicit VectorsTest(SystemOptions options = {}) : system(std::move(options)) {
    dog = system.AddRobot("ERS-210", nullptr);
    object = system.AddObject<SubjectProbe>(dog, "probe");
    system.Boot();
    system.RunFor(1);
  }
  void As(const std::function<void()>& body) { RunAs(object, body); }
  OStatus NewCommands(size_t count) { return OPENR::NewCommandVectorData(count, &id, &commands); }

  System system;
  int dog;
  SubjectProbe* object;
  MemoryRegionID id = 0;
  OCommandVectorData* commands = nullptr;
};

TEST_F(VectorsTest, ACommandVectorHasTheRobotsLayout) {
  As([&] {
    ASSERT_EQ(NewCommands(12), oSUCCESS);
    const ODataVectorInfo& header = commands->vectorInfo;
    EXPECT_EQ(header.memRegionID, id);
    EXPECT_EQ(header.offset, 0u);
    EXPECT_EQ(header.totalSize, 2112u);
    EXPECT_EQ(header.type, odataCOMMAND_VECTOR);
    EXPECT_EQ(header.infoOffset, 192u);
    EXPECT_EQ(header.infoSize, 32u);
    EXPECT_EQ(header.maxNumData, 12u);
    EXPECT_EQ(header.numData, 0u);
    EXPECT_EQ(header.syncKey, ovrsynckeyUNDEF);
    EXPECT_EQ(commands->GetInfo(3)->frameSize, 8u);
    EXPECT_EQ(commands->GetInfo(3)->dataSize, 128u);
    EXPECT_EQ(commands->GetInfo(3)->dataOffset, 192u + 32 * 12 + 128 * 3);
    EXPECT_EQ(commands->GetInfo(3)->primitiveID, oprimitiveID_UNDEF);
  });
}

TEST_F(VectorsTest, ASoundVectorHasRoomForEverySound) {
  As([&] {
    OSoundVectorData* sound = nullptr;
    ASSERT_EQ(OPENR::NewSoundVectorData(2, 100, &id, &sound), oSUCCESS);
    EXPECT_EQ(sound->vectorInfo.type, odataSOUND_VECTOR);
    EXPECT_EQ(sound->vectorInfo.infoSize, 64u);
    EXPECT_EQ(sound->vectorInfo.totalSize, 192u + 2 * (64 + 100));
    EXPECT_EQ(sound->GetInfo(1)->dataOffset, 192u + 2 * 64 + 100);
    EXPECT_EQ(sound->GetInfo(1)->maxDataSize, 100u);
    EXPECT_EQ(sound->GetInfo(1)->dataSize, 0u);
    EXPECT_EQ(OPENR::DeleteSoundVectorData(id), oSUCCESS);
    EXPECT_EQ(OPENR::DeleteSoundVectorData(id), oINVALID_ARG);
  });
}

TEST_F(VectorsTest, MoreThanTheRobotsMemoryIsNoMemory) {
  As([&] {
    EXPECT_EQ(NewCommands(1'000'000), oNO_MEMORY);
    EXPECT_EQ(commands, nullptr);
    EXPECT_EQ(NewCommands(SIZE_MAX), oNO_MEMORY);
    OSoundVectorData* sound = nullptr;
    EXPECT_EQ(OPENR::NewSoundVectorData(1, SIZE_MAX, &id, &sound), oNO_MEMORY);
    EXPECT_EQ(OPENR::NewSoundVectorData(SIZE_MAX, SIZE_MAX, &id, &sound), oNO_MEMORY);
  });
}

TEST_F(VectorsTest, AVectorIsDeletedAsWhatItIs) {
  As([&] {
    ASSERT_EQ(NewCommands(1), oSUCCESS);
    EXPECT_EQ(OPENR::DeleteSoundVectorData(id), oINVALID_ARG);
    EXPECT_EQ(OPENR::DeleteCdtVectorData(id), oFAIL);
    EXPECT_EQ(OPENR::DeleteCommandVectorData(id), oSUCCESS);
    EXPECT_EQ(OPENR::DeleteCommandVectorData(id), oFAIL);
  });
}

TEST_F(VectorsTest, VectorsMadeForEveryCommandAreReported) {
  As([&] {
    for (int i = 0; i < 64; ++i) EXPECT_EQ(NewCommands(1), oSUCCESS);
  });
  EXPECT_TRUE(system.findings().all().empty());
  As([&] {
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(NewCommands(1), oSUCCESS);
  });
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_NE(system.findings().all()[0].text.find("make vectors once, in DoInit"),
            std::string::npos);
  EXPECT_EQ(system.findings().all()[0].object, "probe");
  system.RunFor(10'000);
  EXPECT_FALSE(system.powered_off());
}

TEST_F(VectorsTest, VectorsThatAreDeletedAgainAreFine) {
  As([&] {
    for (int i = 0; i < 1000; ++i) {
      NewCommands(1);
      OPENR::DeleteCommandVectorData(id);
    }
  });
  EXPECT_TRUE(system.findings().all().empty());
}

class StrictVectorsTest : public VectorsTest {
 protected:
  StrictVectorsTest() : VectorsTest({.strict = true}) {}
};

TEST_F(StrictVectorsTest, AndStopTheRobotAt459WhenStrict) {
  As([&] {
    for (int i = 0; i < 459; ++i) NewCommands(1);
  });
  system.RunFor(10'000);
  EXPECT_FALSE(system.powered_off());
  As([&] { NewCommands(1); });
  system.RunFor(10'000);
  EXPECT_TRUE(system.powered_off());
  ASSERT_TRUE(system.end());
  EXPECT_EQ(system.end()->kind, EndKind::kStrict);
  EXPECT_TRUE(system.findings().HasError());
}

}  // namespace
}  // namespace openr_host

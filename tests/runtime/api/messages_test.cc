// The messages of OPENRMessages.h and ObjcommMessages.h as values.
#include <MCOOP.h>
#include <OPENR/ObjcommMessages.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

TEST(MessagesTest, EachKnowsItsType) {
  EXPECT_EQ(OReasonMessage(oreasonBOOT).msgType, omsgREASON);
  EXPECT_EQ(OStatusMessage(oFAIL).msgType, omsgOSTATUS);
  EXPECT_EQ(OConnectMessage(oconnectcmdDISCONNECT).msgType, omsgCONNECT);
  EXPECT_EQ(OPowerStatusMessage().msgType, omsgPOWER_STATUS);
  EXPECT_EQ(OSyslogMessage().msgType, omsgSYSLOG);
  EXPECT_EQ(OControlReplyMessage(oFAIL, SubjectID(), 3).msgType, omsgCONTROL_REPLY_V21);
}

TEST(MessagesTest, AReasonCarriesACopyOfItsParameter) {
  const OShutdownParam param(true);
  const OReasonMessage message(oreasonSHUTDOWN, &param, sizeof param);
  EXPECT_EQ(message.reason, oreasonSHUTDOWN);
  EXPECT_EQ(message.paramSize, sizeof param);
  EXPECT_EQ(message.param[0], 1);
  EXPECT_EQ(message.param[1], 0);
  EXPECT_EQ(OReasonMessage(oreasonBOOT).paramSize, 0u);
}

TEST(MessagesTest, AParameterThatIsTooLargeIsCut) {
  const std::string block(200, 'x');
  const OReasonMessage message(oreasonBOOT, block.data(), block.size());
  EXPECT_EQ(message.paramSize, oreasonPARAM_MAX_SIZE);
  EXPECT_EQ(message.param[oreasonPARAM_MAX_SIZE - 1], 'x');
}

TEST(MessagesTest, AControlMessageCutsANameThatIsTooLong) {
  const std::string name(200, 'n');
  const OControlMessage message(objcommCMD_ADDOBSERVER_V22, ObserverID(), 1, 2, 3, name.c_str());
  EXPECT_EQ(message.d_skip, 1u);
  EXPECT_EQ(message.d_min, 2u);
  EXPECT_EQ(message.d_max, 3u);
  EXPECT_EQ(std::string(message.subName), std::string(oserviceNAME_MAX, 'n'));
}

TEST(MessagesTest, APowerStatusIsGivenAsAWholeOrFieldByField) {
  const OPowerStatusMessage fields(1, 2, 3, 4, 5, 6, static_cast<word>(-7), 8, 9);
  EXPECT_EQ(fields.powerStatus.robotStatus, 1u);
  EXPECT_EQ(fields.powerStatus.voltage, 6);
  EXPECT_EQ(fields.powerStatus.current, -7);
  EXPECT_EQ(fields.powerStatus.timeDif, 8);
  EXPECT_EQ(fields.powerStatus.volume, 9);
  EXPECT_EQ(OPowerStatusMessage(fields.powerStatus).powerStatus.remainingCapacity, 3);
}

TEST(MessagesTest, AVectorIsNamedByTypeAndRegion) {
  const OVRData vector(odataCOMMAND_VECTOR, 77);
  EXPECT_EQ(vector.status, oSUCCESS);
  EXPECT_EQ(vector.type, odataCOMMAND_VECTOR);
  EXPECT_EQ(vector.dataVectorID, 77u);
  EXPECT_EQ(vector.offset, 0u);
  OVRData other;
  other.Set(oFAIL, odataSOUND_VECTOR, 78);
  EXPECT_EQ(other.status, oFAIL);
  EXPECT_EQ(other.dataVectorID, 78u);
}

// Provides an object, because a message needs regions and regions need an object.
class NotifyMessageTest : public testing::Test {
 protected:
  NotifyMessageTest() {
    system.AddRobot("ERS-210", nullptr);
    sender = system.AddObject<SubjectProbe>(0, "sender");
  }

  System system;
  SubjectProbe* sender;
};

TEST_F(NotifyMessageTest, RegionsAreWrittenOneByOneUntilThereIsNoRoom) {
  RunAs(sender, [] {
    RCRegion* const region = new RCRegion(40);
    ONotifyMessage message;
    EXPECT_EQ(message.NumberOfData(), 0);
    EXPECT_EQ(message.NumberOfNotify(), 0);
    const size_t empty = message.GetSizeOfMessage();
    EXPECT_EQ(message.Write(region), oSUCCESS);
    EXPECT_EQ(message.NumberOfData(), 1);
    EXPECT_EQ(message.GetSizeOfMessage(), empty + sizeof(TransferedData));
    EXPECT_EQ(message.data[0].srcRCR, region);
    EXPECT_EQ(message.data[0].memID, region->MemID());
    EXPECT_EQ(message.data[0].size, 40u);
    for (int i = 1; i < MAX_NUM_DATA; ++i) EXPECT_EQ(message.Write(region), oSUCCESS);
    EXPECT_EQ(message.Write(region), oOVERFLOW);
    EXPECT_EQ(message.NumberOfData(), MAX_NUM_DATA);
    EXPECT_EQ(message.GetSizeOfMessage(), sizeof message);
    message.Clear();
    EXPECT_EQ(message.NumberOfData(), 0);
    EXPECT_EQ(region->NumberOfReference(), 1);
    region->RemoveReference();
  });
}

}  // namespace
}  // namespace openr_host

// DecodeContent(): messages of known types in words.
#include "openr/decode/decode_message.h"

#include <EndpointTypes.h>
#include <OPENR/ODataFormats.h>
#include <OPENR/OPENRMessages.h>
#include <OPENR/ObjcommMessages.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "Messages.h"
#include "MoverState.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "virtualrobot/devices/primitive_locator.h"
#include "virtualrobot/devices/primitive_table.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

template <typename T>
std::string BytesOf(const T& value) {
  return std::string(reinterpret_cast<const char*>(&value), sizeof value);
}

class DecodeMessageTest : public testing::Test {
 protected:
  // Returns the text of a notification with data of type `type`.
  std::string Notified(const std::string& type, const std::string& content) const {
    const std::string name = "A.B." + type + ".O";
    const std::string text = DecodeContent(model_, name + " (Notify)", content);
    EXPECT_EQ(DecodeContent(model_, "A.B." + type + ".S", content), text);
    return text;
  }

  template <typename Info>
  static std::string VectorOf(ODataType type, const std::vector<Info>& infos) {
    ODataVectorInfo head;
    std::memset(&head, 0, sizeof head);
    head.type = type;
    head.infoOffset = sizeof head;
    head.numData = head.maxNumData = static_cast<longword>(infos.size());
    std::string content = BytesOf(head);
    for (const Info& info : infos) content += BytesOf(info);
    return content;
  }

  const RobotModel model_ = LoadRobotModel(OPENR_MODEL_DIR "/ers210.json");
};

TEST_F(DecodeMessageTest, EachKindOfMoverCommandIsInWords) {
  const auto text = [this](MoverCommand command) {
    return Notified("MoverCommand", BytesOf(command));
  };
  MoverCommand command = {};
  command.joint = 1;
  command.kind = moverkindPOSITION;
  command.value = 523599;
  EXPECT_EQ(text(command), "move neck_pan to 30.00 deg");
  command.kind = moverkindTRACK;
  command.frames = 4;
  EXPECT_EQ(text(command), "neck_pan to 30.00 deg in 4 frames");
  command.kind = moverkindSPEED;
  command.value = 4550;
  EXPECT_EQ(text(command), "speed of neck_pan at most 45.50 deg/s");
  command.kind = moverkindACCELERATION;
  EXPECT_EQ(text(command), "acceleration of neck_pan 45.50 deg/s^2");
  command.kind = moverkindGAINS;
  command.gain[0] = 10;
  command.gain[1] = 8;
  command.gain[2] = 12;
  EXPECT_EQ(text(command), "gains of neck_pan: P 10, I 8, D 12");
  command.kind = moverkindMOTOR_OFF;
  EXPECT_EQ(text(command), "motor of neck_pan off");
  command.kind = moverkindMOTOR_ON;
  command.joint = MOVER_ALL_JOINTS;
  EXPECT_EQ(text(command), "motor power on");
  command.kind = moverkindSTOP;
  EXPECT_EQ(text(command), "stop the motion");
  command.kind = moverkindPLAY;
  command.loops = 3;
  std::strcpy(command.file, "WALK.MTN");
  EXPECT_EQ(text(command), "play WALK.MTN, 3 times");
  command.kind = 77;
  EXPECT_EQ(text(command), "command 77");
}

TEST_F(DecodeMessageTest, ANotificationMayHaveSeveralCommands) {
  MoverCommand first = {}, second = {};
  first.kind = moverkindSTOP;
  second.kind = moverkindMOTOR_OFF;
  second.joint = 0;
  EXPECT_EQ(Notified("MoverCommand", BytesOf(first) + BytesOf(second)),
            "stop the motion\nmotor of neck_tilt off");
}

TEST_F(DecodeMessageTest, TheBufferOfControllerIsALineForEachJoint) {
  BatchMoverCommand batch = {};
  batch.joint[0] = {1745329, 9000, 12000, batchPOSITION_GIVEN};
  batch.joint[1] = {0, 100, 200, batchMOTOR_OFF};
  EXPECT_THAT(Notified("BatchMoverCommand", BytesOf(batch)),
              StartsWith("neck_tilt to 100.00 deg, at most 90.00 deg/s, 120.00 deg/s^2\n"
                         "neck_pan stays, at most 1.00 deg/s, 2.00 deg/s^2, motor off\n"));
}

TEST_F(DecodeMessageTest, AStateHasTheMotionAndTheEars) {
  SetValueMessage message = {};
  message.state = moverMTN;
  message.keyFrame = 2;
  message.isOver = 1;
  message.earMask = 3;
  message.earOn = 2;
  message.motorsOff = 1;
  std::strcpy(message.file, "BOW.MTN");
  message.commanded[0] = 174533;
  EXPECT_THAT(Notified("SetValueMessage", BytesOf(message)),
              StartsWith("state " + std::string(MoverStateName(moverMTN)) +
                         ", key frame 2, motion BOW.MTN is over, motor power off\n" +
                         model_.plungers[0].name + " off\n" + model_.plungers[1].name +
                         " on\nneck_tilt: commanded 10.00, measured 0.00 deg\n"));
}

TEST_F(DecodeMessageTest, ASoundHasItsFormatAndNoSamples) {
  const PrimitiveTable table(model_);
  OSoundInfo info;
  std::memset(&info, 0, sizeof info);
  info.primitiveID = table.IdOf(model_.microphone_locator);
  info.dataSize = 2048;
  info.frameNumber = 44;
  EXPECT_EQ(Notified("OSoundVectorData", VectorOf<OSoundInfo>(odataSOUND_VECTOR, {info})),
            model_.microphone_locator + " 2048 bytes, frame 44");
  info.samplingRate = 16000;
  info.bitsPerSample = 16;
  info.channel = osoundchannelSTEREO;
  EXPECT_EQ(Notified("OSoundVectorData", VectorOf<OSoundInfo>(odataSOUND_VECTOR, {info})),
            model_.microphone_locator + " 2048 bytes, frame 44, 16000 Hz, 16 bits, stereo");
}

TEST_F(DecodeMessageTest, AnImageHasItsLayersAndNoPixels) {
  OFbkImageInfo high, colours;
  std::memset(&high, 0, sizeof high);
  high.type = odataFBK_YCrCb;
  high.width = 176;
  high.height = 144;
  high.dataSize = 76032;
  high.frameNumber = 8;
  colours = high;
  colours.type = odataFBK_CDT;
  EXPECT_EQ(Notified("OFbkImageVectorData",
                     VectorOf<OFbkImageInfo>(odataFBKIMAGE_VECTOR, {high, colours})),
            "layer H 176 x 144, YCrCb, 76032 bytes, frame 8\n"
            "layer M 176 x 144, colour detection, 76032 bytes, frame 8");
}

TEST_F(DecodeMessageTest, AnLedIsOnOrOff) {
  const PrimitiveTable table(model_);
  OCommandInfo info;
  std::memset(&info, 0, sizeof info);
  info.Set(odataLED_COMMAND2, table.IdOf(model_.leds[0].locator), 1);
  info.dataOffset = sizeof(ODataVectorInfo) + sizeof info;
  OLEDCommandValue2 led = {oledON, 4, 0};
  const std::string head = VectorOf<OCommandInfo>(odataCOMMAND_VECTOR, {info});
  EXPECT_EQ(Notified("OCommandVectorData", head + BytesOf(led)),
            model_.leds[0].locator + " to on in 1 frames");
}

TEST_F(DecodeMessageTest, MessagesOfTheSystemAreKnownByTheirTypeAndSize) {
  OPowerStatusMessage power;
  power.powerStatus.remainingCapacity = 84;
  power.powerStatus.temperature = 2982;
  EXPECT_THAT(DecodeContent(model_, "PowerChanged", BytesOf(power)), HasSubstr("84 %, 25.1"));
  EXPECT_EQ(DecodeContent(model_, "DoInit", BytesOf(OReasonMessage(oreasonBOOT))), "boot");
  EXPECT_EQ(DecodeContent(model_, "(reply)", BytesOf(OStatusMessage(oFAIL))),
            "status " + std::to_string(oFAIL));
  OConnectMessage connect;
  std::strcpy(connect.subName, "A.B.int.S");
  EXPECT_EQ(DecodeContent(model_, "C.D.int.O (Connect)", BytesOf(connect)), "connect to A.B.int.S");
  const OControlMessage control(objcommCMD_ADDOBSERVER_V22, ObserverID(), 0, 1, 1, "A.B.int.S");
  EXPECT_EQ(DecodeContent(model_, "A.B.MoverCommand.S (Control)", BytesOf(control)),
            "add an observer of A.B.int.S");
  // The same bytes as data of an own type are numbers.
  EXPECT_EQ(Notified("Own", BytesOf(OStatusMessage(oSUCCESS))), "2 0");
}

TEST_F(DecodeMessageTest, OwnTypesStayTextOrNumbers) {
  EXPECT_EQ(Notified("Line", "hello"), "\"hello\"");
  EXPECT_EQ(Notified("int", BytesOf(int32_t{-7})), "-7");
}

TEST_F(DecodeMessageTest, ContentThatWasCutShowsItsBeginning) {
  MoverCommand command = {};
  command.kind = moverkindSTOP;
  EXPECT_EQ(Notified("MoverCommand", BytesOf(command) + "xxx"), "stop the motion");
  EXPECT_EQ(Notified("OFbkImageVectorData", std::string(4, 'x')), "\"xxxx\"");
}

TEST_F(DecodeMessageTest, OneLineOfIsCut) {
  EXPECT_EQ(OneLineOf("a\nb"), "a; b");
  const std::string cut = OneLineOf(std::string(500, 'x'));
  EXPECT_EQ(cut, std::string(kDecodedLineMax - 3, 'x') + "...");
  EXPECT_EQ(OneLineOf(std::string(kDecodedLineMax, 'x')), std::string(kDecodedLineMax, 'x'));
}

TEST_F(DecodeMessageTest, EachPrimitiveHasTheLocatorOfTheTable) {
  for (const char* const robot : {"ers210", "ers220", "ers7"}) {
    const RobotModel model = LoadRobotModel(fmt::format("{}/{}.json", OPENR_MODEL_DIR, robot));
    PrimitiveTable table(model);
    const OPrimitiveID first = table.IdOfSensor(0);
    OPrimitiveID id = first;
    for (; table.Find(id) != nullptr; ++id) {
      ASSERT_NE(PrimitiveLocator(model, id), nullptr) << id;
      EXPECT_EQ(*PrimitiveLocator(model, id), table.Find(id)->locator);
    }
    EXPECT_GT(id, first + model.sensors.size());
    EXPECT_EQ(PrimitiveLocator(model, id), nullptr);
    EXPECT_EQ(PrimitiveLocator(model, first - 1), nullptr);
  }
}

TEST_F(DecodeMessageTest, AMessageOfAFindingHasItsNumberAndItsContentOnOneLine) {
  EXPECT_EQ(MessageText(12, "a\nb"), "message 12: a; b");
  EXPECT_EQ(MessageText(12, ""), "message 12");
  EXPECT_EQ(MessageText(12, std::string(200, 'x')), "message 12: " + std::string(57, 'x') + "...");
  EXPECT_EQ(MessageInParentheses(12, "boot"), " (message 12: boot)");
  EXPECT_EQ(MessageInParentheses(0, ""), "");
}

// ---- messages of the network stack

// Makes a Message with `request` as its payload, as antEnvMsg::Send() does.
template <typename T>
std::unique_ptr<Message> MessageWith(const T& request, ObjectId sender) {
  auto message = std::make_unique<Message>();
  message->kind = PayloadKind::kHashed;
  message->sender = sender;
  message->size = sizeof request;
  std::memcpy(message->payload, static_cast<const void*>(&request), sizeof request);
  return message;
}

TEST_F(DecodeMessageTest, AMessageOfTheNetworkStackIsItsDescription) {
  antModuleRef endpoint = MakeModuleRef(EndpointType_TCP, 2);
  TCPEndpointConnectMsg connect(endpoint, IPAddress(10, 0, 1, 100), 1024, IPAddress(10, 0, 1, 2),
                                54000);
  connect.error = TCP_SUCCESS;
  const std::string asked =
      "IPStack: TCP Connect, endpoint 2, from 10.0.1.100:1024 to "
      "10.0.1.2:54000";
  EXPECT_EQ(AntMessageText(connect, false), asked.substr(9));
  EXPECT_EQ(AntMessageText(connect, true), asked.substr(9) + ", TCP_SUCCESS");
  const auto message = MessageWith(connect, 7);  // from another object than the one that asked
  EXPECT_EQ(ContentOf(*message), asked + ", TCP_SUCCESS");
  EXPECT_EQ(DecodeContent(model_, "ConnectCont", ContentOf(*message)), ContentOf(*message));
}

TEST_F(DecodeMessageTest, MessagesOfEachProtocolHaveTheirMainValues) {
  antModuleRef tcp = MakeModuleRef(EndpointType_TCP, 1), udp = MakeModuleRef(EndpointType_UDP, 3);
  EXPECT_EQ(AntMessageText(TCPEndpointReceiveMsg(tcp, nullptr, 1, 64), false),
            "TCP Receive, endpoint 1, 1 to 64 bytes");
  EXPECT_EQ(AntMessageText(TCPEndpointSendMsg(tcp, nullptr, 12), false),
            "TCP Send, endpoint 1, 12 bytes");
  EXPECT_EQ(AntMessageText(UDPEndpointBindMsg(udp, IPAddress(0), 7), false),
            "UDP Bind, endpoint 3, 0.0.0.0:7");
  EXPECT_EQ(AntMessageText(antEnvCreateEndpointMsg(EndpointType_TCP, 8192), false),
            "CreateEndpoint, TCP, pool of 8192 bytes");
}

TEST_F(DecodeMessageTest, AMessageThatOnlyWakesHasNoContent) {
  Message message;
  message.kind = PayloadKind::kHashed;
  EXPECT_EQ(ContentOf(message), "");
}

// ---- messages of a run

SimulationOptions QuietOptions() {
  SimulationOptions options;
  options.stick = OPENR_STICK;
  options.body = "ideal";
  options.host_network = false;
  options.console = [](std::string_view) {};
  return options;
}

TEST(DecodeHandledTest, AMessageThatIsHandledSaysWhatItSaidWhenItCame) {
  Simulation simulation(QuietOptions());
  System& system = simulation.system();
  int vectors = 0, requests = 0, boots = 0;
  system.trace().AddSink([&](const TraceRecord& record, const Message& message) {
    const std::string text = DecodeHandled(system, message);
    EXPECT_EQ(text, DecodeReceived(system, record.target, record.selector, ContentOf(message)));
    vectors += text.starts_with("PRM:/r1/c1-Joint2:j1 ");
    requests += text.starts_with("IPStack: ");
    boots += text == "boot";
  });
  system.Boot();
  system.RunUntil(1'000'000);
  EXPECT_GT(vectors, 50);
  EXPECT_GT(requests, 10);
  EXPECT_GE(boots, 8);  // DoInit and DoStart of four objects
}

TEST(DecodeHandledTest, DataThatAreDeletedAreNotShown) {
  Simulation simulation(QuietOptions());
  Message message;
  message.kind = PayloadKind::kNotify;
  message.target = 0;
  ONotifyMessage& notify = *new (message.payload) ONotifyMessage();
  notify.numOfData = 1;
  notify.data[0] = {nullptr, 4711, 0, 16};  // an id that no region has
  EXPECT_EQ(DecodeHandled(simulation.system(), message), "");
}

// The second of two regions does not follow the beginning of the first region, which is too long.
TEST(DecodeHandledTest, ALongNotificationIsCutAfterTheBytesOfAllItsRegions) {
  Simulation simulation(QuietOptions());
  System& system = simulation.system();
  system.Boot();
  system.RunUntil(1'000'000);
  const Object* const mover = system.FindObject(0, "JointMover");
  ASSERT_NE(mover, nullptr);
  uint32_t selector = UNDEF;
  for (const auto& [entry, name] : mover->entry_names().names()) {
    if (name == "JointMover.Mover.MoverCommand.O (Notify)") selector = entry;
  }
  ASSERT_NE(selector, UNDEF);

  MoverCommand stop = {}, motor_off = {};
  stop.kind = moverkindSTOP;
  motor_off.kind = moverkindMOTOR_OFF;
  std::string data[2];
  while (data[0].size() <= kDecodedBytesMax) data[0] += BytesOf(stop);
  data[1] = BytesOf(motor_off);

  Message message;
  message.kind = PayloadKind::kNotify;
  message.target = mover->id;
  message.selector = selector;
  ONotifyMessage& notify = *new (message.payload) ONotifyMessage();
  notify.numOfData = 2;
  for (int i = 0; i < 2; ++i) {
    const uint32_t region = system.regions().New(data[i].size(), mover->id);
    std::memcpy(system.regions().BaseOf(region), data[i].data(), data[i].size());
    notify.data[i] = {nullptr, region, 0, data[i].size()};
  }
  const std::string text = DecodeHandled(system, message);
  EXPECT_EQ(text, DecodeReceived(system, mover->id, selector, data[0].substr(0, kDecodedBytesMax)));
  EXPECT_THAT(text, StartsWith("stop the motion\n"));
}

}  // namespace
}  // namespace openr_host

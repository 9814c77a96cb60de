// Streams of the remote control against a robot that runs: openr rc stream, and clients that do not
// take what comes.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "tests/openr/rc_robot.h"

namespace openr_host {
namespace {

const remote::Options kPatient = {.timeout = std::chrono::seconds(20)};

class RcStreamsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { robot_ = new RcRobot; }
  static void TearDownTestSuite() { delete robot_; }
  void SetUp() override { ASSERT_EQ(robot_->Problem(), ""); }

  static RcRobot* robot_;
};

RcRobot* RcStreamsTest::robot_ = nullptr;

TEST_F(RcStreamsTest, SensorsComeByThemselvesAtLeastThePeriodApart) {
  const auto events = robot_->Answers({"stream", "sensors", "--every", "100ms", "--count", "6"});
  ASSERT_EQ(events.size(), 6u);
  for (size_t i = 1; i < events.size(); ++i) {
    EXPECT_GE(events[i]["frame"].get<int>(), events[i - 1]["frame"].get<int>() + 16)
        << "100 ms are 12.5 frames, rounded up to vectors";
  }
  EXPECT_TRUE(events[0]["joints_deg"].contains("neck_pan"));
}

TEST_F(RcStreamsTest, KeyFramesComeWhileAMotionPlays) {
  remote::Connection client(robot_->remote_address(), kPatient);
  client.Subscribe(rcstreamSET_VALUES, 0);
  client.PlayMotion("BOW.MTN");
  RcSetValues values{};
  int last = -1;
  while (values.isOver == 0) {
    values = client.Read<RcSetValues>(client.NextEvent());
    if (values.keyFrame < 0) continue;
    EXPECT_GE(values.keyFrame, last);
    last = values.keyFrame;
  }
  EXPECT_GE(last, 0);
  EXPECT_EQ(values.file, "BOW.MTN");
}

TEST_F(RcStreamsTest, AnswersComeInOrderWhileEventsArrive) {
  remote::Connection client(robot_->remote_address(), kPatient);
  const uint16_t tag = client.Subscribe(rcstreamSENSORS, 4);
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(client.Read<RcInfo>(client.Request(rcINFO)).numJoints, 18);
  }
  uint32_t frame = 0;
  for (int i = 0; i < 10; ++i) {
    const remote::Event event = client.NextEvent();
    EXPECT_EQ(event.subscription, tag);
    EXPECT_GT(event.frame, frame);
    frame = event.frame;
    EXPECT_EQ(client.Read<RcSensors>(event).joints.size(), 18u);
  }
}

TEST_F(RcStreamsTest, TheLogOfAMotionIsAFileOfTheReport) {
  const ScratchFolder folder;
  const auto answers =
      robot_->Answers({"mtn", "play", "WALK.MTN", "--log", folder.File("LOG.LOG")});
  ASSERT_EQ(answers.size(), 2u);
  const std::string file = folder.Read("LOG.LOG");
  EXPECT_EQ(file.substr(0, 8), "AIBO_1.1");
  EXPECT_GT(answers[1]["records"], 0);
  EXPECT_EQ(file.size(), 8 + 72 * answers[1]["records"].get<size_t>());
  const auto again = robot_->Answers({"log", folder.File("AGAIN.LOG")});
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(folder.Read("AGAIN.LOG").size(), 8 + 72 * again[0]["records"].get<size_t>());
  EXPECT_EQ(robot_->Rc({"log", folder.File("none/LOG.LOG")}).status, 2);
}

TEST_F(RcStreamsTest, APictureOfTheCameraIsAFile) {
  const ScratchFolder folder;
  const auto answers = robot_->Answers({"camera", "-o", folder.File("dog.ppm"), "--layer", "l"});
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0]["bands"], 6);
  const std::string picture = folder.Read("dog.ppm");
  EXPECT_EQ(picture.substr(0, 13), "P6\n44 36\n255\n");
  EXPECT_EQ(picture.size(), 13u + 44 * 36 * 3);
  robot_->Answers({"camera", "-o", folder.File("dog.raw"), "--layer", "l", "--raw"});
  EXPECT_EQ(folder.Read("dog.raw").size(), 44u * 36 * 6);
  robot_->Answers({"camera", "-o", folder.File("dog.pgm"), "--layer", "c"});
  EXPECT_EQ(folder.Read("dog.pgm").substr(0, 13), "P5\n88 72\n255\n");
  EXPECT_EQ(robot_->Rc({"camera", "-o", folder.File("dog.ppm"), "--layer", "x"}).status, 2);
}

// A connection that subscribes and then neither reads nor sends.
class DeafClient {
 public:
  explicit DeafClient(const remote::Address& address)
      : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const int small = 2048;
    setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
    sockaddr_in robot{};
    robot.sin_family = AF_INET;
    robot.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    robot.sin_port = htons(address.port);
    connect(socket_, reinterpret_cast<sockaddr*>(&robot), sizeof robot);
    const std::string packet("RC\x0b\0\2\x32\1\0\0\4\0", 11);
    EXPECT_EQ(write(socket_, packet.data(), packet.size()), 11);
  }
  ~DeafClient() { close(socket_); }

 private:
  const int socket_;
};

TEST_F(RcStreamsTest, ClientsThatTakeNothingDisturbNobody) {
  const DeafClient first(robot_->remote_address());
  const DeafClient second(robot_->remote_address());
  remote::Connection client(robot_->remote_address(), kPatient);
  const uint32_t begin = client.Request(rcINFO).frame;
  uint32_t frame = begin;
  // Twenty minutes of the robot's time: more than 5000 events, and more than 1 MB, for each of
  // them.
  while (frame - begin < 150'000) frame = client.Request(rcINFO).frame;
  EXPECT_EQ(client.Read<RcInfo>(client.Request(rcINFO)).numJoints, 18);
}

TEST_F(RcStreamsTest, AWrongStreamIsRefusedByTheCommandLine) {
  EXPECT_EQ(robot_->Rc({"stream", "sound"}).status, 2);
}

}  // namespace
}  // namespace openr_host

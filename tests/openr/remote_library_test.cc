// openr::remote against a robot that runs, and against servers that say nothing or end.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <thread>

#include "openr/remote/log_reader.h"
#include "tests/openr/rc_robot.h"

namespace openr_host {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

const remote::Options kPatience = {.timeout = std::chrono::seconds(20)};

class RemoteLibraryTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { robot_ = new RcRobot; }
  static void TearDownTestSuite() { delete robot_; }
  void SetUp() override { ASSERT_EQ(robot_->Problem(), ""); }

  // Calls `function` and returns the error that it must throw.
  template <typename Function>
  static remote::Error ErrorOf(const Function& function) {
    try {
      function();
    } catch (const remote::Error& error) {
      return error;
    }
    ADD_FAILURE() << "no error";
    return {remote::ErrorCode::kLost, "no error"};
  }

  static RcRobot* robot_;
  remote::Connection client_{robot_->remote_address(), kPatience};
};

RcRobot* RemoteLibraryTest::robot_ = nullptr;

TEST_F(RemoteLibraryTest, AnswersMayBeTakenInAnyOrder) {
  const remote::RequestId info = client_.Send(rcINFO);
  const remote::RequestId pan = client_.Send(rcGET, {1});
  const remote::RequestId sensors = client_.Send(rcSENSORS);
  EXPECT_EQ(client_.Read<remote::Sensors>(client_.Wait(sensors)).joints.size(), 18u);
  EXPECT_TRUE(client_.IsAnswered(info));
  EXPECT_GT(client_.Read<remote::JointState>(client_.Wait(pan)).speed, 0);
  EXPECT_EQ(client_.Read<remote::Info>(client_.Wait(info)).design, "ERS-210");
}

TEST_F(RemoteLibraryTest, ARefusalLeavesTheAnswersBehindIt) {
  const remote::RequestId wrong = client_.Send(rcGET, {99});
  const remote::RequestId good = client_.Send(rcGET, {1});
  const remote::Error error = ErrorOf([&] { client_.Wait(wrong); });
  EXPECT_EQ(error.code(), remote::ErrorCode::kRefused);
  EXPECT_EQ(error.status(), rcerrorNO_SUCH_DEVICE);
  EXPECT_TRUE(error.IsConnectionUsable());
  EXPECT_NE(error.text().find("joint 99"), std::string::npos) << error.text();
  EXPECT_GT(client_.Read<remote::JointState>(client_.Wait(good)).speed, 0);
  EXPECT_EQ(ErrorOf([&] {
              client_.RequestAll(rcGET, {{1}, {99}, {2}});
            }).status(),
            rcerrorNO_SUCH_DEVICE);
  EXPECT_EQ(client_.GetInfo().numJoints, 18);
}

TEST_F(RemoteLibraryTest, ADroppedAnswerIsThrownAway) {
  client_.Drop(client_.Send(rcGET, {99}));
  const remote::RequestId answered = client_.Send(rcSENSORS);
  EXPECT_EQ(client_.GetInfo().design, "ERS-210");
  client_.Drop(answered);
  EXPECT_EQ(client_.GetSensors().joints.size(), 18u);
}

TEST_F(RemoteLibraryTest, MoreRequestsThanAreUnderWayAtATimeAreAllAnswered) {
  const std::vector<remote::Bytes> questions(3 * remote::Connection::kInFlight + 1, {1});
  EXPECT_EQ(client_.RequestAll(rcGET, questions).size(), questions.size());
}

TEST_F(RemoteLibraryTest, ABatchHasItsRefusalsAmongTheAnswers) {
  const auto answers = client_.Batch({remote::Connection::JointCall(rcMOVE, 1, 500),
                                      remote::Connection::JointCall(rcMOVE, 99, 0),
                                      remote::Connection::JointCall(rcSPEED, 1, 40)});
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(client_.InForce(answers[0]),
            client_.Devices(rcdeviceJOINT)[1].values[rcjointMAX] / 100.0);
  EXPECT_EQ(answers[1].status, rcerrorNO_SUCH_DEVICE);
  EXPECT_NE(answers[1].error, "");
  EXPECT_EQ(client_.InForce(answers[2]), 40.0);
}

TEST_F(RemoteLibraryTest, DevicesAreFoundByAllTheirNames) {
  const int joint = client_.Find(rcdeviceJOINT, "LF_j1");
  const remote::Description& device = client_.Devices(rcdeviceJOINT)[static_cast<size_t>(joint)];
  EXPECT_EQ(client_.Find(rcdeviceJOINT, device.title), joint);
  EXPECT_EQ(client_.Find(rcdeviceJOINT, device.locator), joint);
  EXPECT_EQ(client_.Find(rcdeviceJOINT, std::to_string(joint)), joint);
  const remote::Error error = ErrorOf([&] { client_.Find(rcdeviceJOINT, "wing"); });
  EXPECT_EQ(error.code(), remote::ErrorCode::kNoDevice);
  EXPECT_EQ(error.text(), "the robot has no 'wing'");
  EXPECT_EQ(error.advice().find("there are\n  0 neck_tilt"), 0u) << error.advice();
}

TEST_F(RemoteLibraryTest, AFileGoesThereAndBackWithItsProgress) {
  std::vector<std::pair<size_t, size_t>> seen;
  const auto progress = [&](size_t done, size_t size) { seen.emplace_back(done, size); };
  const std::string motion = client_.Download(rcfileMOTION, "WALK.MTN", progress);
  ASSERT_GT(motion.size(), 1000u);
  EXPECT_EQ(seen.front(), std::pair(size_t{0}, motion.size()));
  EXPECT_EQ(seen.back(), std::pair(motion.size(), motion.size()));
  seen.clear();
  client_.Upload(rcfileMOTION, "COPY.MTN", motion, progress);
  EXPECT_EQ(seen.front(), std::pair(size_t{0}, motion.size()));
  EXPECT_EQ(seen.back(), std::pair(motion.size(), motion.size()));
  EXPECT_EQ(client_.Download(rcfileMOTION, "copy.mtn"), motion);
  client_.DeleteMotion("COPY.MTN");
  EXPECT_EQ(ErrorOf([&] { client_.Download(rcfileMOTION, "COPY.MTN"); }).status(),
            rcerrorNO_SUCH_FILE);
}

TEST_F(RemoteLibraryTest, ARefusedUploadLeavesAGoodConnection) {
  const std::string nonsense(200'000, 'x');
  const remote::Error error = ErrorOf([&] { client_.Upload(rcfileMOTION, "WRONG.MTN", nonsense); });
  EXPECT_EQ(error.status(), rcerrorBAD_FILE);
  EXPECT_EQ(client_.GetInfo().design, "ERS-210");
}

TEST_F(RemoteLibraryTest, AnEventThatDoesNotComeIsNotWaitedForBeyondTheDeadline) {
  EXPECT_FALSE(client_.NextEvent(steady_clock::time_point{}).has_value());
  const remote::RequestId sensors = client_.Subscribe(rcstreamSENSORS, 4);
  const auto event = client_.NextEvent(steady_clock::now() + kPatience.timeout);
  ASSERT_TRUE(event.has_value());
  EXPECT_EQ(event->subscription, sensors);
  EXPECT_EQ(client_.Read<remote::Sensors>(*event).joints.size(), 18u);
  client_.Unsubscribe(rcstreamSENSORS);
  while (client_.NextEvent(steady_clock::time_point{})) {
  }
  EXPECT_FALSE(client_.NextEvent(steady_clock::now() + milliseconds(50)).has_value());
}

TEST_F(RemoteLibraryTest, ThePictureHasThreeBytesForAPixel) {
  const remote::Picture picture = client_.TakePicture(2);
  EXPECT_EQ(picture.width, 44);
  EXPECT_EQ(picture.Rgb().size(), 44u * 36 * 3);
}

// A socket that listens on a free port of loopback and takes no connection.
class StalledServer {
 public:
  StalledServer() : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    bind(socket_, reinterpret_cast<sockaddr*>(&address), size);
    listen(socket_, 4);
    getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    address_ = {"127.0.0.1", ntohs(address.sin_port)};
  }
  ~StalledServer() { close(socket_); }
  const remote::Address& address() const { return address_; }

 protected:
  int socket() const { return socket_; }

 private:
  const int socket_;
  remote::Address address_;
};

TEST(RemoteLibraryFaultsTest, AServerThatAnswersNothingTimesOut) {
  const StalledServer server;
  remote::Connection client(server.address(), {.timeout = milliseconds(30)});
  try {
    client.RequestAll(rcUPLOAD_DATA, std::vector<remote::Bytes>(32, remote::Bytes(1012)));
    FAIL();
  } catch (const remote::Error& error) {
    EXPECT_EQ(error.code(), remote::ErrorCode::kTimeout);
    EXPECT_FALSE(error.IsConnectionUsable());
    EXPECT_NE(error.advice(), "");
    EXPECT_EQ(std::string(error.what()), error.text() + "; " + error.advice());
  }
}

// Takes one connection and answers each request as a robot that serves version 1 only.
class OldRobot : public StalledServer {
 public:
  OldRobot() : thread_([this] { Serve(); }) {}
  ~OldRobot() { thread_.join(); }

 private:
  void Serve() const {
    const int peer = accept(socket(), nullptr, nullptr);
    RcFramer framer;
    uint8_t bytes[RC_MAX_PACKET];
    for (ssize_t n; (n = recv(peer, bytes, sizeof bytes, 0)) > 0;) {
      framer.Append(bytes, static_cast<int>(n));
      while (framer.Next() == RcFramer::PACKET) Answer(peer, framer.Header());
    }
    close(peer);
  }

  static void Answer(int peer, const RcHeader& request) {
    uint8_t bytes[RC_MAX_PACKET];
    RcWriter out(bytes, sizeof bytes);
    for (int i = 0; i < RC_HEADER_SIZE; ++i) out.U8(0);
    out.U32(8);
    const bool is_old = request.version == RC_VERSION;
    out.U16(is_old ? rcOK : rcerrorVERSION);
    out.U16(0);
    if (is_old) {
      RcInfo info{};
      info.design = "ERS-210";
      info.Write(&out);
    } else {
      out.String("version 2 is not served");
    }
    out.PutHeader(request.command, request.tag);
    (void)!write(peer, bytes, static_cast<size_t>(out.Size()));
  }

  std::thread thread_;
};

TEST(RemoteLibraryFaultsTest, ARobotOfVersionOneIsAskedInVersionOne) {
  const OldRobot robot;
  remote::Connection client(robot.address());
  const remote::Info info = client.GetInfo();
  EXPECT_EQ(info.design, "ERS-210");
  EXPECT_FALSE(info.hasFiles);
  try {
    client.GetPower();
    FAIL();
  } catch (const remote::Error& error) {
    EXPECT_EQ(error.status(), rcerrorVERSION);
    EXPECT_TRUE(error.IsConnectionUsable());
    EXPECT_NE(error.advice(), "");
  }
}

TEST(RemoteLibraryFaultsTest, AnOverdueAnswerIsNoticedWithoutWaitingForIt) {
  const StalledServer server;
  remote::Connection client(server.address(), {.timeout = milliseconds(30)});
  const remote::RequestId id = client.Send(rcINFO);
  try {
    while (!client.IsAnswered(id)) {
    }
    FAIL();
  } catch (const remote::Error& error) {
    EXPECT_EQ(error.code(), remote::ErrorCode::kTimeout);
  }
}

TEST(RemoteLibraryFaultsTest, NobodyListensIsUnreachable) {
  remote::Address address;
  {
    const StalledServer server;
    address = server.address();
  }
  try {
    const remote::Connection client(address);
    FAIL();
  } catch (const remote::Error& error) {
    EXPECT_EQ(error.code(), remote::ErrorCode::kUnreachable);
    EXPECT_NE(error.text().find("no program listens there"), std::string::npos) << error.text();
  }
}

TEST(RemoteLibraryFaultsTest, AUnknownHostIsAnErrorOfTheAddress) {
  try {
    const remote::Connection client({"no-such-host.invalid", 54000});
    FAIL();
  } catch (const remote::Error& error) {
    EXPECT_EQ(error.code(), remote::ErrorCode::kAddress);
  }
}

}  // namespace
}  // namespace openr_host

// openr rc against a robot that runs, and against servers that are none.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "openr/remote/connection.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

namespace remote = openr::remote;
using nlohmann::json;

TEST(RemoteAddressTest, ThePortIsOptional) {
  EXPECT_EQ(remote::ParseAddress("dog").host, "dog");
  EXPECT_EQ(remote::ParseAddress("dog").port, RC_PORT);
  EXPECT_EQ(remote::ParseAddress("dog:99").port, 99);
}

TEST(RemoteAddressTest, NonsenseIsRefused) {
  for (const char* text :
       {"", ":5", "dog:", "dog:0", "dog:65536", "dog:x", "dog:5x", "::1", "[::1]:5"}) {
    EXPECT_THROW(remote::ParseAddress(text), remote::Error) << text;
  }
}

// A listening socket on a free port of loopback.
class Listener {
 public:
  Listener() : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    bind(socket_, reinterpret_cast<sockaddr*>(&address), size);
    listen(socket_, 1);
    getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }
  ~Listener() { close(socket_); }
  remote::Address address() const { return {"127.0.0.1", port_}; }

  // Takes a connection, says `text` and, if asked to, ends it.
  void Say(const std::string& text, bool end) {
    const int peer = accept(socket_, nullptr, nullptr);
    (void)!write(peer, text.data(), text.size());
    if (end) shutdown(peer, SHUT_WR);
    peers_.push_back(peer);
  }

 private:
  int socket_;
  uint16_t port_ = 0;
  std::vector<int> peers_;
};

std::string ComplaintOf(remote::Connection* client) {
  try {
    client->Request(rcINFO);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

TEST(RemoteClientTest, AServerThatSaysNothingTimesOut) {
  const Listener listener;
  remote::Connection client(listener.address(), {.timeout = std::chrono::milliseconds(20)});
  const std::string complaint = ComplaintOf(&client);
  EXPECT_EQ(complaint.find(listener.address().Text() + ": connected, but no answer within 20 ms"),
            0u)
      << complaint;
  EXPECT_NE(complaint.find("as many clients as it can (8)"), std::string::npos) << complaint;
}

TEST(RemoteClientTest, AServerThatSpeaksSomethingElseIsRecognised) {
  Listener listener;
  remote::Connection client(listener.address());
  listener.Say("HTTP/1.0 400 Bad Request\r\n", false);
  EXPECT_NE(ComplaintOf(&client).find("this is no remote control"), std::string::npos);
}

TEST(RemoteClientTest, AConnectionThatEndsIsExplained) {
  Listener listener;
  remote::Connection client(listener.address(), {.timeout = std::chrono::milliseconds(200)});
  listener.Say("RC", true);
  const std::string complaint = ComplaintOf(&client);
  EXPECT_EQ(complaint.find(listener.address().Text() +
                           ": the connection was lost (the robot closed it), and the robot does "
                           "not answer any more: it seems that the run has ended"),
            0u)
      << complaint;
}

// A robot with the ideal body, standing.
class RemoteControlTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    robot_ =
        new ProgramRun({"run", "--rate", "max", "--no-panel", "--rc-port", "0", "--body", "ideal"});
    ready_ = robot_->WaitFor("state: accepting-commands") && robot_->WaitFor("openr rc 127.0.0.1:");
  }
  static void TearDownTestSuite() {
    robot_->Signal(SIGINT);
    delete robot_;
  }
  void SetUp() override { ASSERT_TRUE(ready_) << robot_->Finish().err; }

  static std::string Address() {
    const std::string& text = robot_->heard();
    const size_t begin = text.find("127.0.0.1:");
    return text.substr(begin, text.find(' ', begin) - begin);
  }

  static ProgramResult Rc(const std::vector<std::string>& words) {
    std::vector<std::string> arguments{"rc", Address(), "--json"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    return RunProgram(arguments);
  }

  // The answer as JSON; an empty object after a failure.
  static json Answer(const std::vector<std::string>& words) {
    const ProgramResult result = Rc(words);
    EXPECT_EQ(result.status, 0) << result.err;
    return result.status == 0 ? json::parse(result.out) : json::object();
  }

  // The first sensor values for which `condition` holds.
  template <typename Condition>
  static json SensorsWhen(const Condition& condition) {
    json sensors;
    do {
      sensors = Answer({"sensors"});
    } while (sensors.contains("frame") && !condition(sensors));
    return sensors;
  }
  static json SensorsAfter(uint32_t frame) {
    return SensorsWhen([frame](const json& sensors) { return sensors["frame"] >= frame; });
  }

  static ProgramRun* robot_;
  static bool ready_;
};

ProgramRun* RemoteControlTest::robot_ = nullptr;
bool RemoteControlTest::ready_ = false;

TEST_F(RemoteControlTest, SensorsAreWatchedAlsoWithMoreThanAnHourBetweenTwo) {
  // 2^32 us, which are 0 in an integer of 32 bits.
  ProgramRun watch({"rc", Address(), "--json", "sensors", "--watch", "--every", "4294967296us"});
  ASSERT_TRUE(watch.WaitForOutput("\n"));
  Answer({"info"});  // gives a wrong `watch` time for more lines
  watch.Signal(SIGINT);
  const std::string& out = watch.Finish().out;
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 1);
}

TEST_F(RemoteControlTest, InfoTellsRobotStateAndFrame) {
  const json info = Answer({"info"});
  EXPECT_EQ(info["design"], "ERS-210");
  EXPECT_EQ(info["state"], "accepting-commands");
  EXPECT_GT(info["frame"], 0);
}

TEST_F(RemoteControlTest, AJointGoesWhereItIsTold) {
  const json answer = Answer({"move", "neck_pan", "30"});
  EXPECT_EQ(answer["in_force"], 30.0);
  const json sensors = SensorsAfter(answer["frame"].get<uint32_t>() + 375);
  EXPECT_NEAR(sensors["joints_deg"]["neck_pan"].get<double>(), 30, 2);
}

TEST_F(RemoteControlTest, ACommandBeyondTheLimitEndsAtTheLimit) {
  const json answer = Answer({"move", "neck_roll", "-80"});
  EXPECT_EQ(answer["in_force"], -29.0);
  EXPECT_EQ(answer["limited"], true);
}

TEST_F(RemoteControlTest, SeveralJointsMoveWithOnePacket) {
  const json answer = Answer({"pose", "neck_roll=-80", "tail_tilt=10", "2=5"});
  EXPECT_EQ(answer["in_force"]["neck_roll"], 5.0) << "the last one counts";
  EXPECT_EQ(answer["in_force"]["tail_tilt"], 10.0);
  const json sensors = SensorsAfter(answer["frame"].get<uint32_t>() + 250);
  EXPECT_NEAR(sensors["joints_deg"]["neck_roll"].get<double>(), 5, 2);
  const ProgramResult wrong = Rc({"pose", "neck_roll"});
  EXPECT_EQ(wrong.status, 1);
  EXPECT_NE(wrong.err.find("'neck_roll' is no joint with a number of degrees"), std::string::npos)
      << wrong.err;
}

TEST_F(RemoteControlTest, SpeedAndAccelerationAreLimitedAndTold) {
  EXPECT_EQ(Answer({"speed", "neck_tilt", "50"})["in_force"], 50.0);
  EXPECT_EQ(Answer({"accel", "neck_tilt", "100"})["in_force"], 100.0);
  EXPECT_EQ(Answer({"get", "neck_tilt"})["speed_deg_s"], 50.0);
}

TEST_F(RemoteControlTest, MotorsGainsAndPowerAreToldAndSet) {
  EXPECT_EQ(Answer({"power"})["motor_power"], true);
  EXPECT_EQ(Answer({"motor", "off"})["motor"], "all motors");
  EXPECT_EQ(Answer({"power"})["motor_power"], false);
  const ProgramResult busy = Rc({"move", "neck_pan", "0"});
  EXPECT_NE(busy.err.find("the motors are off"), std::string::npos) << busy.err;
  EXPECT_EQ(Answer({"motor", "on"})["on"], true);
  EXPECT_EQ(Answer({"motor", "off", "tail_tilt"})["motor"], "tail_tilt");
  EXPECT_EQ(Answer({"gains", "tail_tilt"})["on"], false);
  EXPECT_EQ(Answer({"motor", "on", "tail_tilt"})["on"], true);
  const json set = Answer({"gains", "mouth", "30", "0", "5"});
  EXPECT_EQ(set["gains"], (json{30, 0, 5}));
  EXPECT_EQ(Rc({"gains", "mouth", "30", "0", "128"}).status, 2);
}

TEST_F(RemoteControlTest, LightsAndEarsAreSwitched) {
  EXPECT_EQ(Answer({"led", "0", "on"})["on"], true);
  EXPECT_EQ(Answer({"ear", "Left ear", "off"})["on"], false);
}

TEST_F(RemoteControlTest, AnUnknownJointListsTheOnesThereAre) {
  const ProgramResult result = Rc({"move", "wing", "3"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("the robot has no 'wing'; there are"), std::string::npos);
  EXPECT_NE(result.err.find("neck_pan"), std::string::npos);
}

TEST_F(RemoteControlTest, StoppingNothingIsNoError) {
  SensorsWhen([](const json& s) { return s["state"] == "accepting-commands"; });
  EXPECT_EQ(Answer({"mtn", "stop"})["stopped"], false);
  const ProgramResult result = RunProgram({"rc", Address(), "mtn", "stop"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("no motion plays (accepting-commands)"), std::string::npos)
      << result.out;
}

TEST_F(RemoteControlTest, AMotionPlaysAsToldAndStops) {
  const json play = Answer({"mtn", "play", "WALK.MTN", "--loops", "60000", "--keyframes", "4"});
  EXPECT_EQ(play["loops"], 60000);
  EXPECT_EQ(play["key_frames_per_vector"], 4);
  EXPECT_EQ(Answer({"mtn", "stop"})["stopped"], true);
  EXPECT_EQ(Answer({"mtn", "stop"})["stopped"], false);
}

TEST_F(RemoteControlTest, ARefusalIsAJsonAnswerWithFrameAndStatus) {
  const ProgramResult result = Rc({"mtn", "play", "NOWHERE.MTN"});
  EXPECT_EQ(result.status, 1);
  ASSERT_TRUE(json::accept(result.out)) << result.out;
  const json answer = json::parse(result.out);
  EXPECT_EQ(answer["status"], rcerrorNO_SUCH_FILE);
  EXPECT_GT(answer["frame"], 0);
  EXPECT_NE(answer["error"].get<std::string>().find("NOWHERE.MTN"), std::string::npos) << answer;
}

TEST_F(RemoteControlTest, AMotionThatIsNotThereIsRefusedByTheRobot) {
  const ProgramResult result = Rc({"mtn", "play", "NOWHERE.MTN"});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("refused"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace openr_host

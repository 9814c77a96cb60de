// Tests what docs/remote-control.md says of clients, frames and values, with a robot that stands.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>

#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>

#include "RemoteProtocol.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

struct RawAnswer {
  uint32_t frame = 0;
  uint16_t status = 0, tag = 0;
  std::string payload;

  int32_t Number(size_t at) const {
    int32_t number = 0;
    std::memcpy(&number, payload.data() + at, sizeof number);
    return number;
  }
};

// A client that sends what it likes.
class RawClient {
 public:
  explicit RawClient(uint16_t port) : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ~RawClient() { close(socket_); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  static std::string Packet(int command, const std::string& payload = "", uint16_t tag = 0) {
    const auto size = static_cast<uint16_t>(8 + payload.size());
    std::string bytes = {'R',
                         'C',
                         static_cast<char>(size & 0xff),
                         static_cast<char>(size >> 8),
                         1,
                         static_cast<char>(command)};
    bytes += static_cast<char>(tag & 0xff);
    bytes += static_cast<char>(tag >> 8);
    return bytes + payload;
  }
  void Send(const std::string& bytes) const {
    EXPECT_EQ(send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }
  void EndSending() const { shutdown(socket_, SHUT_WR); }

  // The next answer; nothing when the robot has closed the connection.
  std::optional<RawAnswer> Receive() {
    uint16_t size = 0;
    for (;;) {
      if (heard_.size() >= 4) std::memcpy(&size, heard_.data() + 2, sizeof size);
      if (size != 0 && heard_.size() >= size) break;
      char buffer[4096];
      const ssize_t n = recv(socket_, buffer, sizeof buffer, 0);
      if (n <= 0) return {};
      heard_.append(buffer, static_cast<size_t>(n));
    }
    RawAnswer answer;
    std::memcpy(&answer.tag, heard_.data() + 6, 2);
    std::memcpy(&answer.frame, heard_.data() + 8, 4);
    std::memcpy(&answer.status, heard_.data() + 12, 2);
    answer.payload = heard_.substr(16, size - 16);
    heard_.erase(0, size);
    return answer;
  }
  RawAnswer Ask(int command, const std::string& payload = "") {
    Send(Packet(command, payload));
    return Receive().value_or(RawAnswer{0, 0xffff, 0, ""});
  }

 private:
  const int socket_;
  std::string heard_;
};

std::string Bytes(int32_t number) { return {reinterpret_cast<const char*>(&number), 4}; }

class RemoteFactsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    robot_ = new ProgramRun({"run", "--rate", "max", "--rc-port", "0", "--body", "ideal",
                             "--report", folder_->File("r.json")});
    ready_ = robot_->WaitFor("state: accepting-commands") && robot_->WaitFor("openr rc 127.0.0.1:");
    const std::string& text = robot_->heard();
    const size_t at = text.find("127.0.0.1:");
    if (ready_) port_ = static_cast<uint16_t>(std::stoi(text.substr(at + 10)));
  }
  static void TearDownTestSuite() {
    delete robot_;
    delete folder_;
  }
  void SetUp() override { ASSERT_TRUE(ready_) << robot_->Finish().err; }

  static ScratchFolder* folder_;
  static ProgramRun* robot_;
  static bool ready_;
  static uint16_t port_;
};

ScratchFolder* RemoteFactsTest::folder_ = nullptr;
ProgramRun* RemoteFactsTest::robot_ = nullptr;
bool RemoteFactsTest::ready_ = false;
uint16_t RemoteFactsTest::port_ = 0;

TEST_F(RemoteFactsTest, FramesComeInFours) {
  RawClient client(port_);
  uint32_t last = 3;
  for (int i = 0; i < 50; ++i) {
    const uint32_t frame = client.Ask(rcINFO).frame;
    EXPECT_EQ(frame % 4, 3u);
    EXPECT_GE(frame, last);
    last = frame;
  }
}

TEST_F(RemoteFactsTest, AHalfClosedClientHearsTheRestAndThenTheEnd) {
  RawClient client(port_);
  constexpr uint16_t kCount = 60;
  std::string all;
  for (uint16_t i = 0; i < kCount; ++i) all += RawClient::Packet(rcSENSORS, "", i);
  client.Send(all + "RC");  // and no whole packet
  client.EndSending();
  for (uint16_t i = 0; i < kCount; ++i) {
    const std::optional<RawAnswer> answer = client.Receive();
    ASSERT_TRUE(answer) << i;
    EXPECT_EQ(answer->tag, i);
  }
  EXPECT_FALSE(client.Receive());
}

TEST_F(RemoteFactsTest, LimitsAreThoseOfAllClients) {
  const std::string tilt(1, '\0');
  {
    RawClient one(port_);
    EXPECT_EQ(one.Ask(rcSPEED, tilt + Bytes(4321)).Number(0), 4321);
    RawClient other(port_);
    EXPECT_EQ(other.Ask(rcGET, tilt).Number(4), 4321);
  }
  EXPECT_EQ(RawClient(port_).Ask(rcGET, tilt).Number(4), 4321);
}

TEST_F(RemoteFactsTest, GravityIsNegativeUpwards) {
  const RawAnswer answer = RawClient(port_).Ask(rcSENSORS);
  const size_t first = 8 + 4 * (18 + 6 + 4);  // after joints, switches and four other sensors
  const int32_t front = answer.Number(first), right = answer.Number(first + 4);
  const int32_t up = answer.Number(first + 8);
  EXPECT_NEAR(up, -9'800'000, 50'000);
  EXPECT_NEAR(right, 0, 50'000);
  EXPECT_NEAR(front, 450'000, 50'000);
}

TEST_F(RemoteFactsTest, MoreThanEightKeyFramesAreNotRefused) {
  RawClient client(port_);
  for (const int count : {1, 9, 255}) {
    const std::string payload =
        std::string("\x08WALK.MTN\x01", 10) + std::string(1, '\0') + static_cast<char>(count);
    EXPECT_EQ(client.Ask(rcMTN_PLAY, payload).status, rcOK) << count;
    EXPECT_EQ(client.Ask(rcMTN_STOP).status, rcOK);
  }
}

// The last one: it ends the robot.
TEST_F(RemoteFactsTest, ManyQuestionsAtOnceAreNoFindingAboutItsOwnServer) {
  RawClient client(port_);
  std::string all;
  for (uint16_t i = 0; i < 200; ++i) all += RawClient::Packet(rcSENSORS, "", i);
  client.Send(all);
  for (uint16_t i = 0; i < 200; ++i) ASSERT_TRUE(client.Receive());
  robot_->Signal(SIGINT);
  EXPECT_EQ(robot_->Finish().status, 0);
  const auto report = nlohmann::json::parse(folder_->Read("r.json"));
  for (const auto& finding : report["findings"])
    EXPECT_NE(finding["object"], "RCServer") << finding;
}

}  // namespace
}  // namespace openr_host

// A program for the robot with TCPGateway, as a PC sees it: checked, built, run, spoken to.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include "tests/kit/kit_folder.h"
#include "tests/runtime/gateway/gateway_bytes.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kConfFolder[] = "MS/OPEN-R/MW/CONF/";

sockaddr_in Loopback(uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  return address;
}

// A port of loopback that nobody has.
uint16_t FreePort() {
  const int s = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = Loopback(0);
  socklen_t size = sizeof address;
  bind(s, reinterpret_cast<sockaddr*>(&address), size);
  getsockname(s, reinterpret_cast<sockaddr*>(&address), &size);
  close(s);
  return ntohs(address.sin_port);
}

// A connection of the PC, with patience until somebody listens.
class Client {
 public:
  explicit Client(uint16_t port) {
    const sockaddr_in address = Loopback(port);
    for (int tries = 0; tries < 1000; ++tries) {
      socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
      if (connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0) break;
      close(socket_);
      socket_ = -1;
      usleep(20'000);
    }
    const timeval patience{60, 0};
    setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  ~Client() { close(socket_); }

  void Say(const std::string& bytes) { (void)!write(socket_, bytes.data(), bytes.size()); }
  // `size` bytes, fewer when the connection ends.
  std::string Hear(size_t size) {
    std::string bytes(size, 0);
    size_t have = 0;
    while (have < size) {
      const ssize_t n = read(socket_, bytes.data() + have, size - have);
      if (n <= 0) break;
      have += static_cast<size_t>(n);
    }
    bytes.resize(have);
    return bytes;
  }

 private:
  int socket_ = -1;
};

TEST(GatewayProgramTest, CarriesWordsToThePcAndBack) {
  const KitFolder folder("gateway");
  const uint16_t word_port = FreePort(), turned_port = FreePort();
  folder.Write(std::string(kConfFolder) + "ROBOTGW.CFG",
               "TCPGateway.Word.char.S " + std::to_string(word_port) +
                   "\nTCPGateway.Turned.char.O " + std::to_string(turned_port) + "\n");
  const ProgramResult built = folder.Build();
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_THAT(built.out, HasSubstr("TCPGW.BIN                             the runtime's own"));

  ProgramRun run({"run", "--stick", folder.File("MS"), "--no-panel", "--rate", "10"});
  Client word(word_port), turned(turned_port);
  for (const std::string& text : {std::string("openr"), std::string("pc")}) {
    EXPECT_EQ(word.Hear(4), kReadyWord);
    turned.Say(kReadyWord);
    word.Say(OneItem(text + '\0'));
    const std::string back(text.rbegin(), text.rend());
    EXPECT_EQ(turned.Hear(12 + text.size() + 1), OneItem(back + '\0'));
  }
  Client second(word_port);
  EXPECT_EQ(second.Hear(1), "");
  EXPECT_EQ(word.Hear(4), kReadyWord);
  word.Say(Words({0xffffffff}));
  EXPECT_EQ(word.Hear(1), "");
  run.Signal(SIGINT);
  const ProgramResult& result = run.Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("a second connection is refused"));
  EXPECT_THAT(result.err, HasSubstr("announces 4294967295 bytes, the limit is 1048576"));
}

// ---- openr check

class GatewayCheck : public ::testing::Test {
 protected:
  void Config(const std::string& name, const std::string& text) {
    folder_.Write(kConfFolder + name, text);
  }
  std::string Check() { return RunProgram({"check", folder_.File("")}).out; }

  const KitFolder folder_{"gateway"};
};

TEST_F(GatewayCheck, AGoodStickHasOnlyTheProxyToTellOf) {
  const std::string said = Check();
  EXPECT_THAT(said, HasSubstr("ROBOTGW.CFG:4: note: of the OPEN-R calls of a program on a PC"));
  EXPECT_THAT(said, HasSubstr("0 errors"));
  EXPECT_THAT(said, Not(HasSubstr("TCPGW.BIN")));
}

TEST_F(GatewayCheck, ABadLineIsAnError) {
  Config("ROBOTGW.CFG", "TCPGateway.Word.char.S 590020\nTCPGateway.Turned.char.O 59003\n");
  const std::string said = Check();
  EXPECT_THAT(said, HasSubstr("ROBOTGW.CFG:1: '590020' is no port"));
  EXPECT_THAT(said, HasSubstr("CONNECT.CFG:2: the gateway has no 'TCPGateway.Word.char.S'"));
}

TEST_F(GatewayCheck, TwoWiresOfOneServiceAreAnError) {
  Config("CONNECT.CFG",
         "TCPGateway.Word.char.S Turner.In.char.O\nTurner.Out.char.S TCPGateway.Turned.char.O\n"
         "TCPGateway.Word.char.S PowerMonitor.In.char.O\n");
  EXPECT_THAT(Check(), HasSubstr("CONNECT.CFG:3: 'TCPGateway.Word.char.S' is connected already in "
                                 "line 1"));
}

TEST_F(GatewayCheck, TheRobotNeedsTheImageToo) {
  Config("OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/TURNER.BIN\n");
  EXPECT_THAT(Check(), HasSubstr("does not name /MS/OPEN-R/SYSTEM/OBJS/TCPGW.BIN"));
}

TEST_F(GatewayCheck, AServiceWithoutAWireIsNoted) {
  Config("ROBOTGW.CFG",
         "TCPGateway.Word.char.S 59002\nTCPGateway.Turned.char.O 59003\n"
         "TCPGateway.More.char.O 59004\n");
  EXPECT_THAT(Check(), HasSubstr("ROBOTGW.CFG:3: note: CONNECT.CFG does not mention this service"));
}

}  // namespace
}  // namespace openr_host

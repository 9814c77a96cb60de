// Panel and remote control that other computers reach: openr run --listen.
#include "openr/panel/listen.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <vector>

#include "RemoteFiles.h"
#include "RemoteProtocol.h"
#include "cli/base64.h"
#include "openr/panel/access.h"
#include "openr/panel/rc_forwarder.h"
#include "openr/remote/token_file.h"
#include "tests/openr/panel_server.h"
#include "tests/openr/program_run.h"
#include "tests/openr/web_client.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using Bytes = std::vector<uint8_t>;
using Json = nlohmann::ordered_json;

constexpr char kToken[] = "0123456789abcdef";

std::string TokenText(const std::string& file) {
  try {
    return "token " + openr::remote::ReadTokenFile(file);
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(TokenFileTest, AFileThatIsNotThereIsMadeForThisUserOnly) {
  const ScratchFolder scratch;
  const std::string file = scratch.File("token");
  const std::string token = ReadOrMakeToken(file);
  EXPECT_EQ(token.size(), 32u);
  EXPECT_EQ(ReadOrMakeToken(file), token);
  struct stat facts {};
  ASSERT_EQ(stat(file.c_str(), &facts), 0);
  EXPECT_EQ(facts.st_mode & 0777, 0600u);
}

TEST(TokenFileTest, FilesWithoutASecretAreRefused) {
  const ScratchFolder scratch;
  EXPECT_THAT(TokenText(scratch.File("none")), HasSubstr("No such file"));
  EXPECT_THAT(TokenText(scratch.path()), HasSubstr("is no file"));
  const std::string file = scratch.File("token");
  const auto why = [&](const std::string& text) {
    scratch.Write("token", text);
    chmod(file.c_str(), 0600);
    return TokenText(file);
  };
  EXPECT_EQ(why("0123456789abcdef\n"), "token 0123456789abcdef");
  EXPECT_EQ(why("0123456789-_ABCD\r\nmore"), "token 0123456789-_ABCD");
  for (const char* const text : {"", "\n", "short\n", "0123456789abcde\n", "0123456789 abcdef\n"})
    EXPECT_THAT(why(text), HasSubstr("has no token")) << text;
  EXPECT_EQ(why(std::string(128, 'a')), "token " + std::string(128, 'a'));
  EXPECT_THAT(why(std::string(129, 'a')), HasSubstr("has no token"));
  chmod(file.c_str(), 0640);
  EXPECT_THAT(TokenText(file), HasSubstr("other users may read this token: chmod 600 "));
}

TEST(ListenTest, OnlyAddressesOfThisComputerCanBeUsed) {
  EXPECT_EQ(ListenAddressProblem("192.168.0.5"), "");
  for (const char* const text : {"localhost", "192.168.0", "::1", "1.2.3.4:5", ""})
    EXPECT_THAT(ListenAddressProblem(text), HasSubstr("no IPv4 address")) << text;
  uint16_t port = 0;
  // 192.0.2.0/24 is for documentation, so no computer has this address.
  try {
    close(Listen("192.0.2.1", &port));
    ADD_FAILURE() << "something listens at 192.0.2.1";
  } catch (const std::exception& error) {
    EXPECT_THAT(error.what(), HasSubstr("this computer has no such address"));
  }
}

TEST(AccessTest, ThePanelIsKnownByItsAddressOnly) {
  const auto is_known = [](const std::string& address, const std::string& host) {
    WebRequest request;
    request.host = host;
    return Access(kToken, address, 8210).FileRefusal(request).empty();
  };
  EXPECT_TRUE(is_known("127.0.0.1", "127.0.0.1:8210"));
  EXPECT_TRUE(is_known("127.0.0.1", "localhost:8210"));
  EXPECT_FALSE(is_known("127.0.0.1", "192.168.0.5:8210"));
  EXPECT_TRUE(is_known("192.168.0.5", "192.168.0.5:8210"));
  EXPECT_FALSE(is_known("192.168.0.5", "localhost:8210"));
  EXPECT_FALSE(is_known("192.168.0.5", "192.168.0.6:8210"));
  EXPECT_FALSE(is_known("192.168.0.5", "192.168.0.5:8211"));
  EXPECT_TRUE(is_known("0.0.0.0", "192.168.0.6:8210"));
  EXPECT_TRUE(is_known("0.0.0.0", "localhost:8210"));
  // A name of another site can be made to lead to this computer.
  for (const char* const host : {"evil.example:8210", "8210", ":8210", "", "192.168.0.6"})
    EXPECT_FALSE(is_known("0.0.0.0", host)) << host;
}

TEST(AccessTest, FilesOfThePageNeedNeitherTokenNorOrigin) {
  const Access access(kToken, "192.168.0.5", 8210);
  WebRequest request;
  request.host = "192.168.0.5:8210";
  request.origin = "http://evil.example";
  EXPECT_EQ(access.FileRefusal(request), "");
  EXPECT_NE(access.SocketRefusal(request), "");
}

// Browsers leave out the port of HTTP.
TEST(AccessTest, ThePanelAtPort80IsKnownWithoutThePort) {
  const Access access(kToken, "127.0.0.1", 80);
  WebRequest request;
  request.protocol = access.protocol();
  for (const char* const host : {"127.0.0.1", "localhost", "127.0.0.1:80"}) {
    request.host = host;
    request.origin = std::string("http://") + host;
    EXPECT_EQ(access.SocketRefusal(request), "") << host;
    EXPECT_EQ(access.SocketSource(host), std::string("ws://") + host);
  }
  for (const char* const host : {"127.0.0.1:81", "evil.example", ""}) {
    request.host = host;
    EXPECT_NE(access.FileRefusal(request), "") << host;
  }
}

TEST(AccessTest, AForeignHostGetsNoSourceOfWebSockets) {
  const Access access(kToken, "0.0.0.0", 8210);
  EXPECT_EQ(access.SocketSource("10.0.0.7:8210"), "ws://10.0.0.7:8210");
  EXPECT_EQ(access.SocketSource("evil.example:8210"), "");
}

// A forwarder with a client and, once it has connected, a robot; the test plays both.
class RcForwarderTest : public ::testing::Test {
 protected:
  RcForwarderTest() : robots_(Listen("127.0.0.1", &port_)) {}
  ~RcForwarderTest() override {
    if (robot_ >= 0) close(robot_);
    close(robots_);
    for (const int client : clients_) close(client);
    while (RcForwarder::HasThreads()) usleep(1000);  // they end with their clients
  }

  // Connects another client; the functions below are about the last one.
  void Connect(bool allows_controllers = false) {
    int ends[2];
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    clients_.push_back(ends[0]);
    const auto find = [this] { return openr::remote::Address{"127.0.0.1", port_}; };
    RcForwarder(find, kToken, allows_controllers).ServeClient(ends[1]);
    framer_.Reset();
  }

  // Connects a client that has shown the token, and the robot to it.
  void ConnectWithToken(bool allows_controllers = false) {
    Connect(allows_controllers);
    Send(rcTOKEN, 1, Text(kToken));
    EXPECT_EQ(NextAnswer(), "72 1 status 0 ");
    robot_ = AcceptRobot(true);
    ASSERT_GE(robot_, 0);
  }

  // Returns the connection of the forwarder to the robot; -1 if there is none.  Waits for it if
  // `waits`.
  int AcceptRobot(bool waits) {
    pollfd wanted = {robots_, POLLIN, 0};
    poll(&wanted, 1, waits ? 120'000 : 0);
    return accept4(robots_, nullptr, nullptr, SOCK_CLOEXEC);
  }

  static Bytes Text(const std::string& text) {
    Bytes bytes(text.begin(), text.end());
    bytes.insert(bytes.begin(), static_cast<uint8_t>(text.size()));
    return bytes;
  }

  static Bytes Packet(int command, int tag, const Bytes& payload) {
    Bytes packet(RC_HEADER_SIZE + payload.size());
    RcWriter writer(packet.data(), static_cast<int>(packet.size()));
    for (int i = 0; i < RC_HEADER_SIZE; ++i) writer.U8(0);
    writer.Bytes(payload.data(), static_cast<int>(payload.size()));
    writer.PutHeader(command, tag, RC_VERSION_FILES);
    return packet;
  }

  void Send(int command, int tag, const Bytes& payload = {}) {
    const Bytes packet = Packet(command, tag, payload);
    SendTo(clients_.back(), packet);
  }
  static void SendTo(int socket, const Bytes& bytes) {
    EXPECT_EQ(send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(bytes.size()));
  }

  // The robot's answer with no error, to the command `command`.
  void AnswerOfRobot(int command, int tag) {
    SendTo(robot_, Packet(command, tag, Bytes(RC_ANSWER_HEADER_SIZE - RC_HEADER_SIZE)));
  }

  // Returns command, tag, status and error of the next answer; "end" at the end of the stream.
  std::string NextAnswer() {
    RcAnswerHeader header;
    RcFramer::Result result;
    while ((result = framer_.Next()) == RcFramer::NEEDS_MORE) {
      uint8_t bytes[RC_MAX_PACKET];
      pollfd wanted = {clients_.back(), POLLIN, 0};
      const ssize_t n =
          poll(&wanted, 1, 120'000) > 0 ? recv(clients_.back(), bytes, sizeof bytes, 0) : -1;
      if (n <= 0) return "end";
      framer_.Append(bytes, static_cast<int>(n));
    }
    if (result != RcFramer::PACKET || !header.Read(framer_)) return "no answer";
    RcReader reader(framer_.Payload() + 8, framer_.PayloadSize() - 8);
    return fmt::format("{:x} {} status {} {}", header.header.command, header.header.tag,
                       header.status, reader.String());
  }

  // Returns the command and the tag of the next packet that the robot gets; "end" at the end.
  std::string NextRequest() {
    RcHeader header;
    uint8_t packet[RC_MAX_PACKET];
    if (recv(robot_, packet, RC_HEADER_SIZE, MSG_WAITALL) != RC_HEADER_SIZE) return "end";
    header.Read(packet);
    const int rest = header.size - RC_HEADER_SIZE;
    if (rest > 0 && recv(robot_, packet, static_cast<size_t>(rest), MSG_WAITALL) != rest)
      return "end";
    return fmt::format("{:x} {}", header.command, header.tag);
  }

  uint16_t port_ = 0;
  const int robots_;  // listens in place of the robot
  int robot_ = -1;
  std::vector<int> clients_;
  RcFramer framer_;
};

TEST_F(RcForwarderTest, WithoutTheTokenTheRobotGetsNothing) {
  Connect();
  Send(rcINFO, 7);
  EXPECT_THAT(NextAnswer(), HasSubstr("1 7 status 16 a token is needed here"));
  EXPECT_EQ(NextAnswer(), "end");
  for (const Bytes& payload :
       {Text("0123456789abcdeg"), Text("0123456789abcde"), Text(""), Bytes{200, 'a'}, Bytes()}) {
    Connect();
    Send(rcTOKEN, 7, payload);
    EXPECT_EQ(NextAnswer(), "72 7 status 16 the token is wrong");
    EXPECT_EQ(NextAnswer(), "end");
  }
  Connect();
  SendTo(clients_.back(), Bytes{'G', 'E', 'T', ' ', '/'});
  EXPECT_THAT(NextAnswer(), HasSubstr("0 0 status 16 a token is needed here"));
  EXPECT_EQ(AcceptRobot(false), -1);
}

TEST_F(RcForwarderTest, AClientWithTheTokenIsConnectedWithTheRobot) {
  ConnectWithToken();
  Send(rcINFO, 2);
  EXPECT_EQ(NextRequest(), "1 2");
  AnswerOfRobot(rcINFO, 2);
  EXPECT_EQ(NextAnswer(), "1 2 status 0 ");
  shutdown(clients_.back(), SHUT_WR);
  EXPECT_EQ(NextRequest(), "end");
  AnswerOfRobot(rcINFO, 2);  // the robot may still answer after the client's end
  EXPECT_EQ(NextAnswer(), "1 2 status 0 ");
  shutdown(robot_, SHUT_WR);
  EXPECT_EQ(NextAnswer(), "end");
}

TEST_F(RcForwarderTest, RequestsBehindTheTokenAreForwarded) {
  Connect();
  Bytes packets = Packet(rcTOKEN, 1, Text(kToken));
  const Bytes second = Packet(rcINFO, 2, {});
  packets.insert(packets.end(), second.begin(), second.end());
  SendTo(clients_.back(), packets);
  robot_ = AcceptRobot(true);
  EXPECT_EQ(NextRequest(), "1 2");
}

TEST_F(RcForwarderTest, AControllerIsRefusedAfterTheAnswersBefore) {
  ConnectWithToken();
  Send(rcEVENT, 1);  // has no answer
  Send(rcINFO, 2);
  Send(rcUPLOAD_BEGIN, 3, {rcfileIMAGE});
  Send(rcUPLOAD_BEGIN, 4, {rcfileMOTION});
  EXPECT_EQ(NextRequest(), "3f 1");
  EXPECT_EQ(NextRequest(), "1 2");
  SendTo(robot_, Packet(rcEVENT, 9, Bytes(8)));  // is no answer
  AnswerOfRobot(rcINFO, 2);
  EXPECT_EQ(NextAnswer(), "3f 9 status 0 ");
  EXPECT_EQ(NextAnswer(), "1 2 status 0 ");
  EXPECT_THAT(NextAnswer(), HasSubstr("50 3 status 16 a controller is code"));
  EXPECT_EQ(NextRequest(), "50 4");
}

TEST_F(RcForwarderTest, AControllerIsForwardedIfThatIsAllowed) {
  ConnectWithToken(true);
  Send(rcUPLOAD_BEGIN, 3, {rcfileIMAGE});
  EXPECT_EQ(NextRequest(), "50 3");
}

TEST_F(RcForwarderTest, CommandZeroIsAnsweredHere) {
  ConnectWithToken();
  Send(0, 0);
  EXPECT_THAT(NextAnswer(), HasSubstr("0 0 status 3 there is no command 0"));
  Send(rcUPLOAD_BEGIN, 3, {rcfileIMAGE});
  EXPECT_THAT(NextAnswer(), HasSubstr("50 3 status 16"));
}

TEST_F(RcForwarderTest, AClientMayGoWhileItsAnswerWaits) {
  ConnectWithToken();
  Send(rcINFO, 2);
  Send(rcUPLOAD_BEGIN, 3, {rcfileIMAGE});
  EXPECT_EQ(NextRequest(), "1 2");
  shutdown(clients_.back(), SHUT_RDWR);
  EXPECT_EQ(NextRequest(), "end");  // the robot's connection ends without an answer
}

TEST_F(RcForwarderTest, BytesThatAreNoPacketAreAnsweredAndDoNotReachTheRobot) {
  ConnectWithToken();
  Send(rcINFO, 2);
  SendTo(clients_.back(), Bytes(16, 'x'));
  EXPECT_EQ(NextRequest(), "1 2");
  AnswerOfRobot(rcINFO, 2);
  EXPECT_EQ(NextAnswer(), "1 2 status 0 ");
  EXPECT_THAT(NextAnswer(), HasSubstr("0 0 status 1 a packet begins with 'RC'"));
  EXPECT_EQ(NextAnswer(), "end");
  EXPECT_EQ(NextRequest(), "end");
}

TEST_F(RcForwarderTest, ARobotThatIsNotThereIsARefusal) {
  shutdown(robots_, SHUT_RDWR);
  Connect();
  Send(rcTOKEN, 1, Text(kToken));
  EXPECT_THAT(NextAnswer(), HasSubstr("72 1 status 7 127.0.0.1:"));
  EXPECT_EQ(NextAnswer(), "end");
}

TEST_F(RcForwarderTest, ClientsWithoutTheTokenAreCounted) {
  for (int i = 0; i < RcForwarder::kWithoutTokenMax; ++i) Connect();
  Connect();
  EXPECT_EQ(NextAnswer(), "end");
  // Clients that go make room.
  for (const int client : clients_) shutdown(client, SHUT_RDWR);
  while (RcForwarder::HasThreads()) usleep(1000);
  for (int i = 0; i < RcForwarder::kClientsMax; ++i) {
    ConnectWithToken();
    close(std::exchange(robot_, -1));
  }
}

// A run whose panel and remote control are open at all addresses of this computer.
class ListenRunTest : public PanelTest {
 protected:
  // Starts a run.  Sets port_ and rc_port_ to what it says that it has opened.
  void Start(const std::vector<std::string>& flags = {}) {
    std::vector<std::string> arguments = {
        "run", "--rc-port",    "0",         "--body",     "ideal",   "--panel-port",
        "0",   "--rate",       "max",       "--listen",   "0.0.0.0", "--listen-rc-port",
        "0",   "--token-file", token_file_, "--run-name", "open"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    run_ = std::make_unique<ProgramRun>(arguments);
    ASSERT_TRUE(run_->WaitFor("nothing is encrypted")) << run_->heard();
    ASSERT_TRUE(run_->WaitFor("state: accepting-commands")) << run_->heard();
    std::smatch match;
    const std::string& heard = run_->heard();
    ASSERT_TRUE(std::regex_search(heard, match, std::regex("panel: http://ADDRESS:(\\d+)/")));
    port_ = std::stoi(match[1]);
    ASSERT_TRUE(std::regex_search(heard, match, std::regex("openr rc ADDRESS:(\\d+) ")));
    rc_port_ = match[1];
    token_ = openr::remote::ReadTokenFile(token_file_);
  }

  // Runs `openr rc` at the forwarded port.
  ProgramResult Rc(const std::vector<std::string>& words) {
    std::vector<std::string> arguments = {"rc", "127.0.0.1:" + rc_port_};
    arguments.insert(arguments.end(), words.begin(), words.end());
    return RunProgram(arguments);
  }

  const std::string token_file_ = folder_.path() + "/token";
  std::string rc_port_;
  std::unique_ptr<ProgramRun> run_;
};

TEST_F(ListenRunTest, OnlyTheTokenOpensTheRemoteControl) {
  Start();
  EXPECT_THAT(run_->heard(), HasSubstr("reach both at all addresses of this computer"));
  EXPECT_THAT(run_->heard(), HasSubstr("uploads of controllers are off"));
  EXPECT_THAT(run_->heard(), Not(HasSubstr(token_)));
  const ProgramResult without = Rc({"info"});
  EXPECT_EQ(without.status, 1);
  EXPECT_THAT(without.err, HasSubstr("a token is needed here"));
  const ProgramResult with = Rc({"--token-file", token_file_, "get", "neck_pan"});
  EXPECT_EQ(with.status, 0) << with.err;
  EXPECT_THAT(with.out, HasSubstr("neck_pan"));
  const ProgramResult upload = Rc({"--token-file", token_file_, "controller", "upload",
                                   OPENR_STICK "/OPEN-R/MW/OBJS/CONTROLL.BIN"});
  EXPECT_EQ(upload.status, 1);
  EXPECT_THAT(upload.err, HasSubstr("--allow-uploads"));
}

TEST_F(ListenRunTest, ControllersAreTakenIfThatIsAllowed) {
  Start({"--allow-uploads"});
  EXPECT_THAT(run_->heard(), HasSubstr("they may upload controllers"));
  const ProgramResult upload = Rc({"--token-file", token_file_, "controller", "upload",
                                   OPENR_STICK "/OPEN-R/MW/OBJS/CONTROLL.BIN"});
  EXPECT_EQ(upload.status, 0) << upload.err;
}

TEST_F(ListenRunTest, ThePageNeedsTheTokenAndUploadsNoController) {
  Start();
  EXPECT_THAT(Http(port_, "/"), HasSubstr(" 200 "));
  EXPECT_THAT(Http(port_, "/", "evil.example:" + std::to_string(port_)), HasSubstr(" 403 "));
  EXPECT_FALSE(WebSocketClient(port_, {.protocol = "openr.0123456789abcdef"}).is_open());
  WebSocketClient page(port_, Known());
  ASSERT_TRUE(page.is_open()) << page.answer();
  page.Send(Json({{"do", "rc"}, {"call", "motions"}, {"id", "a"}}).dump());
  EXPECT_THAT(page.Receive(), HasSubstr("WALK.MTN"));
  page.Send(Json({{"do", "rc"},
                  {"call", "upload"},
                  {"kind", "controller"},
                  {"name", "CONTROLL.BIN"},
                  {"data", ToBase64("x")},
                  {"id", "b"}})
                .dump());
  EXPECT_THAT(page.Receive(), HasSubstr("--allow-uploads"));
}

// A run that goes on from an earlier moment is a new process with the same ports.
TEST_F(ListenRunTest, TheRemoteControlFollowsARunThatGoesOnFromAnEarlierMoment) {
  Start();
  EXPECT_EQ(Rc({"--token-file", token_file_, "info"}).status, 0);
  WebSocketClient page(port_, Known());
  // Sends a request and returns its answer, without the events that come before it.
  const auto ask = [&page](Json request) {
    request["id"] = "a";
    page.Send(request.dump());
    std::string answer = page.Receive();
    while (answer[0] == '{' && Json::parse(answer).value("id", "") != "a") answer = page.Receive();
    return answer;
  };
  // Checkpoints are taken while a page watches.
  page.Send(R"({"do":"watch","period_ms":100,"events":["clock"],"id":"w"})");
  // Tries again until there is a checkpoint that is old enough.
  std::string back = "error";
  for (int i = 0; i < 10'000 && back.find("error") != std::string::npos; ++i)
    back = ask({{"do", "rewind"}, {"back_s", 1}});
  EXPECT_THAT(back, Not(HasSubstr("error")));
  const std::string branch = ask({{"do", "branch"}});
  EXPECT_THAT(branch, HasSubstr("\"run\""));
  const ProgramResult info = Rc({"--token-file", token_file_, "--timeout", "60s", "info"});
  EXPECT_EQ(info.status, 0) << info.err << branch;
}

TEST_F(ListenRunTest, AnAddressThatIsNotThereEndsTheRunBeforeItBegins) {
  const std::string record = folder_.path() + "/old.rec";
  { std::ofstream(record) << "old"; }
  const ProgramResult result =
      RunProgram({"run", "--rc-port", "0", "--body", "ideal", "--for", "1s", "--listen",
                  "192.0.2.1", "--token-file", token_file_, "--record", record});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("this computer has no such address"));
  std::ifstream file(record);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), "old");
}

TEST_F(ListenRunTest, ARunWhoseTokenIsNoSecretDoesNotBegin) {
  { std::ofstream(token_file_) << kToken << '\n'; }
  chmod(token_file_.c_str(), 0644);
  const ProgramResult result =
      RunProgram({"run", "--rc-port", "0", "--body", "ideal", "--for", "1s", "--listen",
                  "127.0.0.2", "--token-file", token_file_});
  EXPECT_NE(result.status, 0);
  EXPECT_THAT(result.err, HasSubstr("chmod 600"));
}

}  // namespace
}  // namespace openr_host

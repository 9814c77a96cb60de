// Tests of the gateway between objects and a peer on a LoopbackNetwork: rules of ready and bytes of
// measured.md 1.25 to 1.29, files of core.md, 5.4.
#include "runtime/gateway/tcp_gateway.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "runtime/base/temp_folder.h"
#include "runtime/stick/memory_stick.h"
#include "tests/runtime/gateway/gateway_bytes.h"
#include "tests/runtime/ipstack/net_probe.h"

namespace openr_host {
namespace {

constexpr uint16_t kOutPort = 59002, kInPort = 59003;

// A program that sends and receives texts.
class Chat : public CodeObject {
 public:
  Chat() {
    do_ = AddExtra("Do", [this](void*) { std::exchange(todo, nullptr)(); });
    out = AddSubject("Chat.Out.Text.S",
                     [this](const OReadyEvent& event) { readies += event.IsAssert() ? '+' : '-'; });
    in = AddObserver("Chat.In.Text.O", [this](const ONotifyEvent& event) {
      for (int i = 0; i < event.NumOfData(); ++i)
        heard += std::string(event.RCData(i)->Base(), event.RCData(i)->Size()) +
                 (i + 1 < event.NumOfData() ? "," : ";");
      if (reads_on) in->AssertReady();
    });
  }

  void Do(std::function<void()> body) {
    todo = std::move(body);
    system().Post(system().NewMessage(host().id, do_));
  }

  OSubject* out;
  OObserver* in;
  std::string readies;  // '+' for each assert, '-' for each deassert
  std::string heard;
  bool reads_on = true;
  std::function<void()> todo;

 private:
  Selector do_;
};

class TcpGatewayTest : public testing::Test {
 protected:
  TcpGatewayTest() : peer(hub) {
    Config("OBJECT.CFG", "/MS/OPEN-R/SYSTEM/OBJS/TCPGW.BIN\n");
    Config("CONNECT.CFG",
           "Chat.Out.Text.S TCPGateway.Away.Text.O\n"
           "TCPGateway.Home.Text.S Chat.In.Text.O\n");
    Config("ROBOTGW.CFG", "TCPGateway.Away.Text.O 59002\nTCPGateway.Home.Text.S 59003\n");
  }

  void Config(const std::string& name, const std::string& text) {
    const auto conf = std::filesystem::path(folder.path()) / "OPEN-R/MW/CONF";
    std::filesystem::create_directories(conf);
    std::ofstream(conf / name, std::ios::binary) << text;
  }

  void Boot(SystemOptions options = {}) {
    options.console = [](std::string_view) {};
    system = std::make_unique<System>(std::move(options));
    system->AddRobot("ERS-210", std::make_shared<FolderStick>(folder.path()));
    AddIpStack(system.get(), 0, std::make_unique<LoopbackNetwork>(hub));
    chat = system->AddObject<Chat>(0, "chat");
    EXPECT_TRUE(LoadStick(system.get(), 0, {}, {GatewayImage(system.get(), 0)}));
    system->Boot();
    system->RunFor(1000);
  }
  void Meet(uint16_t port) {
    Boot();
    peer.Connect(port);
    Frames(2);
    EXPECT_TRUE(peer.connected);
  }

  // Runs to the next frame boundary, then polls the peer; by default twice, because an answer may
  // need a second frame.
  void Frames(int count = 2) {
    for (int i = 0; i < count; ++i) {
      system->RunFor(kFrameUs);
      peer.Poll();
    }
  }
  void Do(std::function<void()> body) {
    chat->Do(std::move(body));
    system->RunFor(1);
  }
  void Say(std::initializer_list<const char*> texts) {
    Do([&] {
      for (const char* text : texts) chat->out->SetData(text, std::strlen(text));
      chat->out->NotifyObservers();
    });
  }
  void AssertReady() {
    Do([&] { chat->in->AssertReady(); });
  }
  std::string Heard() { return std::exchange(peer.heard, ""); }

  std::string Findings() {
    std::string text;
    for (const Finding& finding : system->findings().all())
      text += finding.object + ": " + finding.text + "\n";
    return text;
  }
  bool Found(const std::string& part) { return Findings().find(part) != std::string::npos; }

  const TempFolder folder;
  std::shared_ptr<LoopbackHub> hub = std::make_shared<LoopbackHub>();
  Peer peer;
  std::unique_ptr<System> system;
  Chat* chat = nullptr;
};

// ---- data of the robot go out

TEST_F(TcpGatewayTest, SubjectIsReadyWhenTheConnectionIsUpNotBefore) {
  Boot();
  Frames(3);
  EXPECT_EQ(chat->readies, "");
  peer.Connect(kOutPort);
  Frames(2);
  EXPECT_EQ(chat->readies, "+");
}

TEST_F(TcpGatewayTest, OneSetIsHeldUntilThePeerIsReady) {
  Meet(kOutPort);
  Say({"one", "two"});
  Frames(3);
  EXPECT_EQ(Heard(), "");
  EXPECT_EQ(chat->readies, "+");  // while the gateway holds a set, it does not request another
  peer.Say(kReadyWord);
  Frames(3);
  EXPECT_EQ(Heard(), Words({4 + 4 + 3 + 4 + 3, 2, 3}) + "one" + Words({3}) + "two");
  EXPECT_EQ(chat->readies, "++");
}

TEST_F(TcpGatewayTest, AReadyIsCreditForOneSet) {
  Meet(kOutPort);
  peer.Say(kReadyWord + kReadyWord);
  Frames();
  Say({"one"});
  Frames();
  Say({"two"});
  Frames(3);
  EXPECT_EQ(Heard(), OneItem("one"));
  peer.Say(kReadyWord);
  Frames(3);
  EXPECT_EQ(Heard(), OneItem("two"));
}

TEST_F(TcpGatewayTest, DeassertOfThePeerHoldsData) {
  Meet(kOutPort);
  peer.Say(kReadyWord + kNotReadyWord);
  Frames();
  Say({"one"});
  Frames(3);
  EXPECT_EQ(Heard(), "");
}

TEST_F(TcpGatewayTest, WordsThatMeanNothingAreReportedAndIgnored) {
  Meet(kOutPort);
  peer.Say(Words({0, 1, 2, 3}));
  Frames();
  Say({"one"});
  Frames(3);
  EXPECT_EQ(Heard(), OneItem("one"));
  EXPECT_TRUE(Found("tcpGateway: the peer says ready with 1, which means nothing; 3 is ready"));
}

TEST_F(TcpGatewayTest, DataAgainstTheDirectionCloseTheConnection) {
  Meet(kOutPort);
  peer.Say(OneItem("hello"));
  Frames(3);
  EXPECT_TRUE(peer.ended);
  EXPECT_TRUE(
      Found("TCPGateway.Away.Text.O (port 59002): the connection is closed: the stream has "
            "the word 0xd where ready (3) is expected"));
}

TEST_F(TcpGatewayTest, EndOfTheConnectionDeassertsAndTheNextOneBeginsAnew) {
  Meet(kOutPort);
  Say({"lost"});
  peer.net.Close(peer.handle);
  Frames(3);
  EXPECT_EQ(chat->readies, "+-");
  peer.Connect(kOutPort, 40001);
  Frames(2);
  EXPECT_EQ(chat->readies, "+-+");
  peer.Say(kReadyWord);
  Frames();
  Say({"new"});
  Frames(3);
  EXPECT_EQ(Heard(), OneItem("new"));
}

TEST_F(TcpGatewayTest, SetsOfAnySizeGoOutWhole) {
  Meet(kOutPort);
  peer.Say(kReadyWord);
  Frames();
  const std::string large(200'000, 'x');
  Say({large.c_str()});
  Frames(20);
  EXPECT_EQ(Heard(), OneItem(large));
  EXPECT_FALSE(Found("Nagle"));
}

// ---- data come in

TEST_F(TcpGatewayTest, ReadyOfTheObserverGoesToThePeer) {
  Meet(kInPort);
  EXPECT_EQ(Heard(), "");
  AssertReady();
  Frames();
  EXPECT_EQ(Heard(), kReadyWord);
  Do([&] { chat->in->DeassertReady(); });
  Frames();
  EXPECT_EQ(Heard(), kNotReadyWord);
}

TEST_F(TcpGatewayTest, ReadyFromBeforeTheConnectionIsTold) {
  Boot();
  AssertReady();
  peer.Connect(kInPort);
  Frames(3);
  EXPECT_EQ(Heard(), kReadyWord);
}

TEST_F(TcpGatewayTest, ASetArrivesAsOneEvent) {
  Meet(kInPort);
  AssertReady();
  Frames();
  const std::string set = Words({4 + 4 + 3 + 4 + 3, 2, 3}) + "one" + Words({3}) + "two";
  peer.Say(set.substr(0, 9));
  Frames();
  EXPECT_EQ(chat->heard, "");
  peer.Say(set.substr(9));
  Frames();
  EXPECT_EQ(chat->heard, "one,two;");
  EXPECT_EQ(Heard(), kReadyWord + kReadyWord);
  EXPECT_EQ(Findings(), "");
}

TEST_F(TcpGatewayTest, DataThatNobodyAskedForWaitAndTheNewestWin) {
  Meet(kInPort);
  peer.Say(OneItem("one") + OneItem("two"));
  Frames();
  EXPECT_EQ(chat->heard, "");
  EXPECT_TRUE(Found("the peer sends data before it was told that the observer is ready"));
  AssertReady();
  Frames();
  EXPECT_EQ(chat->heard, "two;");
}

TEST_F(TcpGatewayTest, AMalformedStreamClosesTheConnection) {
  Meet(kInPort);
  AssertReady();
  Frames();
  peer.Say(OneItem("good") + Words({0x40000000, 1}));
  Frames(4);
  EXPECT_EQ(chat->heard, "good;");
  EXPECT_TRUE(peer.ended);
  EXPECT_TRUE(
      Found("TCPGateway.Home.Text.S (port 59003): the connection is closed: the stream "
            "announces 1073741824 bytes, the limit is 1048576"));
  peer.ended = false;
  peer.Connect(kInPort, 40001);  // the new connection has no bytes of the old stream
  Frames(3);
  peer.Say(OneItem("again"));
  Frames();
  EXPECT_EQ(chat->heard, "good;again;");
}

TEST_F(TcpGatewayTest, ASecondClientIsRefusedAndTheFirstGoesOn) {
  Meet(kInPort);
  AssertReady();
  Frames();
  Peer second(hub, 0x0a000103);
  second.Connect(kInPort);
  for (int i = 0; i < 4; ++i) {
    Frames(1);
    second.Poll();
  }
  EXPECT_TRUE(second.ended);
  EXPECT_TRUE(Found("TCPGateway.Home.Text.S (port 59003): a second connection is refused"));
  peer.Say(OneItem("first"));
  Frames();
  EXPECT_EQ(chat->heard, "first;");
}

// ---- the stick

TEST_F(TcpGatewayTest, ServicesOnTheStickOnlyCauseNoWaiting) {
  Config("ROBOTGW.CFG",
         "TCPGateway.Home.Text.S 59003\nTCPGateway.Away.Text.O 59002\n"
         "TCPGateway.Proxy.AperiosMessage.P 59001\n");
  Boot();
  EXPECT_FALSE(system->findings().HasError());
}

TEST_F(TcpGatewayTest, WithoutItsImageInObjectConfigTheRobotHasNone) {
  Config("OBJECT.CFG", "\n");
  Boot();
  EXPECT_NE(system->FindObject(0, TcpGateway::kName), nullptr);
  EXPECT_TRUE(Found("OBJECT.CFG does not name /MS/OPEN-R/SYSTEM/OBJS/TCPGW.BIN"));
}

TEST_F(TcpGatewayTest, NobodyNamesItNobodyGetsIt) {
  Config("OBJECT.CFG", "\n");
  Config("CONNECT.CFG", "Chat.Out.Text.S Chat.In.Text.O\n");
  Boot();
  EXPECT_EQ(system->FindObject(0, TcpGateway::kName), nullptr);
}

TEST_F(TcpGatewayTest, SecondWireIsAnErrorAndStrictDoesNotStart) {
  Config("CONNECT.CFG",
         "TCPGateway.Home.Text.S Chat.In.Text.O\n"
         "TCPGateway.Home.Text.S Chat.In2.Text.O\n");
  Boot({.strict = true});
  EXPECT_TRUE(Found("CONNECT.CFG:2: 'TCPGateway.Home.Text.S' is connected already in line 1"));
  EXPECT_TRUE(system->powered_off());
}

// ---- two gateways

// Two gateways, of the robot and of the host; each receives the data that the other sends.
class GatewayPairTest : public testing::Test {
 protected:
  static std::unique_ptr<System> Make(const TempFolder& robot, const TempFolder& host,
                                      std::shared_ptr<LoopbackHub> hub, Chat** dog, Chat** pc) {
    const auto put = [](const TempFolder& folder, const std::string& name,
                        const std::string& text) {
      const auto conf = std::filesystem::path(folder.path()) / "OPEN-R/MW/CONF";
      std::filesystem::create_directories(conf);
      std::ofstream(conf / name, std::ios::binary) << text;
    };
    for (const TempFolder* folder : {&robot, &host}) {
      put(*folder, "OBJECT.CFG", "");
      put(*folder, "CONNECT.CFG",
          "Chat.Out.Text.S TCPGateway.Away.Text.O\n"
          "TCPGateway.Home.Text.S Chat.In.Text.O\n");
    }
    put(robot, "ROBOTGW.CFG", "TCPGateway.Away.Text.O 59002\nTCPGateway.Home.Text.S 59003\n");
    put(host, "HOSTGW.CFG",
        "TCPGateway.Away.Text.O 59003 10.0.1.100\n"
        "TCPGateway.Home.Text.S 59002 10.0.1.100\n");
    auto system = std::make_unique<System>(SystemOptions{.console = [](std::string_view) {}});
    for (const int i : {0, 1}) {
      system->AddRobot("ERS-210", std::make_shared<FolderStick>((i == 0 ? robot : host).path()));
      AddIpStack(system.get(), i, std::make_unique<LoopbackNetwork>(hub),
                 {.address = i == 0 ? "" : "10.0.1.2"});
      (i == 0 ? *dog : *pc) = system->AddObject<Chat>(i, "chat");
      LoadStick(system.get(), i, {}, {GatewayImage(system.get(), i)});
    }
    system->Boot();
    system->RunFor(1'000'000);
    return system;
  }
};

TEST_F(GatewayPairTest, CarryBothWays) {
  const TempFolder robot, host;
  Chat *dog = nullptr, *pc = nullptr;
  const auto system = Make(robot, host, std::make_shared<LoopbackHub>(), &dog, &pc);
  EXPECT_EQ(dog->readies, "+");
  EXPECT_EQ(pc->readies, "+");
  const auto say = [&](Chat* who, const std::string& text) {
    who->Do([&, who] {
      who->in->AssertReady();
      who->out->SetData(text.data(), text.size());
      who->out->NotifyObservers();
    });
    system->RunFor(100'000);
  };
  say(dog, "woof");
  say(pc, "sit");
  say(dog, "wag");
  EXPECT_EQ(pc->heard, "woof;wag;");
  EXPECT_EQ(dog->heard, "sit;");
}

TEST_F(GatewayPairTest, RunsRepeatThemselves) {
  uint64_t trace[2], state[2];
  for (const int run : {0, 1}) {
    const TempFolder robot, host;
    Chat *dog = nullptr, *pc = nullptr;
    const auto system = Make(robot, host, std::make_shared<LoopbackHub>(), &dog, &pc);
    dog->Do([&] {
      dog->out->SetData("woof", 4);
      dog->out->NotifyObservers();
    });
    system->RunFor(100'000);
    trace[run] = system->trace_hash();
    state[run] = system->state_hash();
  }
  EXPECT_EQ(trace[0], trace[1]);
  EXPECT_EQ(state[0], state[1]);
}

// The host side starts first, so its first attempt to connect fails.
TEST_F(GatewayPairTest, HostSideTriesAgainEverySecond) {
  const TempFolder robot, host;
  Chat *dog = nullptr, *pc = nullptr;
  auto hub = std::make_shared<LoopbackHub>();
  const auto system = Make(robot, host, hub, &dog, &pc);
  system->Shutdown(0);
  system->RunFor(1'000'000);
  EXPECT_EQ(pc->readies, "+-");
  std::string findings;
  system->RunFor(2'000'000);
  for (const Finding& finding : system->findings().all())
    if (finding.robot == 1) findings += fmt::format("{} {}\n", finding.text, finding.count);
  EXPECT_NE(findings.find("cannot connect to 10.0.1.100"), std::string::npos) << findings;
}

}  // namespace
}  // namespace openr_host

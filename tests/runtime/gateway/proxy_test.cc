// OPEN-R calls from a PC to the robot (core.md, 5.4): two runs of ours that call each other, and a
// run that answers the bytes of a PC that is not ours.
#include <OPENR/OPENRAPI.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <optional>

#include "runtime/base/hasher.h"
#include "runtime/base/temp_folder.h"
#include "runtime/core/robot_services.h"
#include "runtime/gateway/proxy_client.h"
#include "runtime/gateway/system_messages.h"
#include "runtime/gateway/tcp_gateway.h"
#include "runtime/stick/memory_stick.h"
#include "tests/runtime/gateway/gateway_bytes.h"
#include "tests/runtime/ipstack/net_probe.h"

namespace openr_host {
namespace {

constexpr uint16_t kProxyPort = 59001;
constexpr char kHead[] = "PRM:/r1/c1-Joint2:j1";

// ---- two runs

// A robot that records the calls it receives.
class HeardServices : public RobotServices {
 public:
  OStatus OpenPrimitive(const char* locator, OPrimitiveID* id) override {
    heard.push_back(std::string("open ") + locator);
    *id = std::string(locator) == kHead ? 0x77 : oprimitiveID_UNDEF;
    return *id == 0x77 ? oSUCCESS : oNOT_FOUND;
  }
  OStatus ClosePrimitive(OPrimitiveID id) override { return Hear("close", id); }
  OStatus EnableJointGain(OPrimitiveID id) override { return Hear("enable", id); }
  OStatus DisableJointGain(OPrimitiveID id) override { return Hear("disable", id); }
  OStatus SetJointGain(OPrimitiveID id, const word g[6]) override {
    return Hear(fmt::format("gains {} {} {} {} {} {}", g[0], g[1], g[2], g[3], g[4], g[5]), id);
  }
  OStatus GetJointGain(OPrimitiveID id, word gains[6]) override {
    for (size_t i = 0; i < 6; ++i) gains[i] = static_cast<word>(10 + i);
    return Hear("get gains", id);
  }
  OStatus SetDefaultJointGain(OPrimitiveID id) override { return Hear("default", id); }
  OStatus GetJointValue(OPrimitiveID id, OJointValue* value) override {
    value->value = -1234567;
    return Hear("joint", id);
  }
  OStatus NewSyncKey(OVRSyncKey* key) override {
    *key = 5;
    return oSUCCESS;
  }
  OStatus SetMotorPower(OPower power) override {
    heard.push_back(power ? "power on" : "power off");
    return oSUCCESS;
  }
  OStatus GetPowerStatus(OPowerStatus* status) override {
    status->remainingCapacity = 83;
    status->volume = 3;
    return oSUCCESS;
  }

  std::vector<std::string> heard;

 private:
  OStatus Hear(const std::string& what, OPrimitiveID id) {
    heard.push_back(fmt::format("{} {:#x}", what, id));
    return oSUCCESS;
  }
};

// The robot of the PC's own run.  Each function returns a status of its own.
class PcServices : public RobotServices {
 public:
  OStatus DivideSyncKey(OVRSyncKey, OVRSyncKey*, OVRSyncKey*) override { return 100; }
  OStatus GetBootCondition(OBootCondition*) override { return 101; }
  OStatus ObservePowerStatus(const OPowerStatus&, const OServiceEntry&) override { return 102; }
  OStatus UnobservePowerStatus(const OServiceEntry&) override { return 103; }
  OStatus SetTime(const OTime&) override { return 104; }
  OStatus GetTime(OTime* time) override {
    *time = OTime(86400, 9);
    return 105;
  }
  OStatus SetTimeDifference(sbyte hours) override { return 200 + hours; }
  OStatus GetTimeDifference(sbyte*) override { return 106; }
  OStatus SetVolumeSwitch(OVolumeSwitch) override { return 107; }
  OStatus GetVolumeSwitch(OVolumeSwitch*) override { return 108; }
  OStatus Shutdown(const OBootCondition& condition) override {
    off_us = int64_t{condition.bootTime} * 1'000'000;
    return 109;
  }
  std::optional<int64_t> TimeOffUs() const override { return off_us; }
  void SwitchOff() override { ++times_off; }
  void RunFrameWhileOff() override { ++frames_off; }
  void Reseed(uint64_t new_seed) override { seed = new_seed; }
  void HashState(Hasher* hasher) const override { hasher->Add(seed); }

  std::optional<int64_t> off_us;
  int times_off = 0;
  int frames_off = 0;
  uint64_t seed = 0;
};

// A program on the PC; `body` runs in its DoInit.
class Caller : public CodeObject {
 public:
  explicit Caller(std::function<void()> body) : body_(std::move(body)) {}
  OStatus DoInit(const OSystemEvent&) override {
    body_();
    done = true;
    return oSUCCESS;
  }
  bool done = false;

 private:
  const std::function<void()> body_;
};

class ProxyTest : public testing::Test {
 protected:
  ProxyTest() : peer(hub) {
    Write(robot_folder, "OBJECT.CFG", "/MS/OPEN-R/SYSTEM/OBJS/TCPGW.BIN\n");
    Write(robot_folder, "ROBOTGW.CFG", "TCPGateway.Proxy.AperiosMessage.P 59001\n");
    Write(pc_folder, "OBJECT.CFG", "\n");
    Write(pc_folder, "HOSTGW.CFG", "!ROBOT_PROXY 59001 10.0.1.100\n");
  }

  static void Write(const TempFolder& folder, const std::string& name, const std::string& text) {
    const auto conf = std::filesystem::path(folder.path()) / "OPEN-R/MW/CONF";
    std::filesystem::create_directories(conf);
    std::ofstream(conf / name, std::ios::binary) << text;
  }

  std::unique_ptr<System> NewSystem(const TempFolder& folder, const char* address) {
    auto system = std::make_unique<System>(SystemOptions{.console = [](std::string_view) {}});
    system->AddRobot("ERS-210", std::make_shared<FolderStick>(folder.path()));
    IpStackOptions options;
    options.address = address;
    AddIpStack(system.get(), 0, std::make_unique<LoopbackNetwork>(hub), options);
    return system;
  }
  void StartRobot() {
    robot = NewSystem(robot_folder, "10.0.1.100");
    auto services = std::make_unique<HeardServices>();
    asked = services.get();
    robot->robot(0).services = std::move(services);
    EXPECT_TRUE(LoadStick(robot.get(), 0, {}, {GatewayImage(robot.get(), 0)}));
    robot->Boot();
    robot->RunFor(1000);
  }
  void StartPc(std::function<void()> body) {
    pc = NewSystem(pc_folder, "10.0.1.2");
    auto services = std::make_unique<PcServices>();
    own = services.get();
    pc->robot(0).services = std::move(services);
    caller = pc->AddObject<Caller>(0, "caller", std::move(body));
    EXPECT_TRUE(LoadStick(pc.get(), 0, {}, {GatewayImage(pc.get(), 0)}));
    pc->Boot();
  }
  void Frames(int count) {
    for (int i = 0; i < count; ++i) {
      if (robot != nullptr) robot->RunFor(kFrameUs);
      if (pc != nullptr) pc->RunFor(kFrameUs);
      peer.Poll();
    }
  }
  static std::string Findings(const System& system) {
    std::string text;
    for (const Finding& finding : system.findings().all())
      if (!finding.object.empty()) text += finding.object + ": " + finding.text + "\n";
    return text;
  }
  // Returns the answer of the robot to these bytes of another program on a PC.
  std::string Answer(const std::string& bytes) {
    if (!peer.connected) {
      peer.Connect(kProxyPort);
      Frames(3);
    }
    peer.Say(bytes);
    Frames(3);
    return std::exchange(peer.heard, "");
  }

  const TempFolder robot_folder, pc_folder;
  std::shared_ptr<LoopbackHub> hub = std::make_shared<LoopbackHub>();
  Peer peer{hub, 0x0a000103};
  std::unique_ptr<System> robot, pc;
  HeardServices* asked = nullptr;
  PcServices* own = nullptr;
  Caller* caller = nullptr;
};

TEST_F(ProxyTest, CallsOfAnObjectOnThePcAreDoneOnTheRobot) {
  StartRobot();
  OPrimitiveID id = 0, nobody = 0;
  std::vector<OStatus> statuses;
  OJointValue value;
  word gains[6] = {};
  OPowerStatus power;
  OVRSyncKey key = 0;
  StartPc([&] {
    statuses.push_back(OPENR::OpenPrimitive(kHead, &id));
    statuses.push_back(OPENR::OpenPrimitive("PRM:/r9-Joint2:j9", &nobody));
    statuses.push_back(OPENR::SetMotorPower(opowerON));
    statuses.push_back(OPENR::SetJointGain(id, 10, 0, 12, 14, 0, 15));
    statuses.push_back(OPENR::EnableJointGain(id));
    statuses.push_back(OPENR::GetJointValue(id, &value));
    statuses.push_back(
        OPENR::GetJointGain(id, &gains[0], &gains[1], &gains[2], &gains[3], &gains[4], &gains[5]));
    statuses.push_back(OPENR::NewSyncKey(&key));
    statuses.push_back(OPENR::GetPowerStatus(&power));
    statuses.push_back(OPENR::ClosePrimitive(id));
  });
  for (int i = 0; i < 500 && !caller->done; ++i) Frames(1);
  ASSERT_TRUE(caller->done) << Findings(*pc) << Findings(*robot);
  EXPECT_EQ(statuses, (std::vector<OStatus>{oSUCCESS, oNOT_FOUND, oSUCCESS, oSUCCESS, oSUCCESS,
                                            oSUCCESS, oSUCCESS, oSUCCESS, oSUCCESS, oSUCCESS}));
  EXPECT_EQ(id, 0x77u);
  EXPECT_EQ(value.value, -1234567);
  EXPECT_EQ(gains[0], 10);
  EXPECT_EQ(gains[5], 15);
  EXPECT_EQ(key, 5u);
  EXPECT_EQ(power.remainingCapacity, 83);
  EXPECT_EQ(power.volume, 3);
  EXPECT_EQ(asked->heard,
            (std::vector<std::string>{std::string("open ") + kHead, "open PRM:/r9-Joint2:j9",
                                      "power on", "gains 10 0 12 14 0 15 0x77", "enable 0x77",
                                      "joint 0x77", "get gains 0x77", "close 0x77"}));
  EXPECT_EQ(Findings(*pc) + Findings(*robot), "");
}

TEST_F(ProxyTest, TwoRunsWithTheSameAnswersAreTheSame) {
  uint64_t hash[2];
  for (uint64_t& one : hash) {
    StartRobot();
    StartPc([] {
      OPrimitiveID id;
      OPENR::OpenPrimitive(kHead, &id);
      OPENR::SetMotorPower(opowerON);
    });
    Frames(100);
    EXPECT_TRUE(caller->done);
    one = pc->trace_hash();
    pc.reset();
  }
  EXPECT_EQ(hash[0], hash[1]);
}

TEST_F(ProxyTest, WithoutARobotACallFailsAfterTenSecondsAndTheNextOneAtOnce) {
  OStatus first = oSUCCESS, second = oSUCCESS;
  int64_t first_us = 0, second_us = 0;
  StartPc([&] {
    OPrimitiveID id;
    first = OPENR::OpenPrimitive(kHead, &id);
    first_us = pc->now_us();
    second = OPENR::SetMotorPower(opowerON);
    second_us = pc->now_us();
  });
  Frames(1300);
  ASSERT_TRUE(caller->done);
  EXPECT_EQ(first, oFAIL);
  EXPECT_EQ(second, oFAIL);
  EXPECT_GE(first_us, ProxyClient::kPatienceUs);
  EXPECT_LT(second_us, first_us + kFrameUs);
  EXPECT_NE(Findings(*pc).find("the robot has not answered an OPEN-R call within 10 s"),
            std::string::npos)
      << Findings(*pc);
  EXPECT_NE(Findings(*pc).find("!ROBOT_PROXY (port 59001): cannot connect to 10.0.1.100, error 10; "
                               "tried again every second; a robot that openr runs on this computer "
                               "is 127.0.0.1: write that, or run with --ip 10.0.1.100=127.0.0.1"),
            std::string::npos)
      << Findings(*pc);
}

// A network that drops all packets to one address, as a firewall does.
class DroppingNetwork : public LoopbackNetwork {
 public:
  void Connect(NetHandle, uint16_t, NetAddress) override {}
};

TEST_F(ProxyTest, AnAddressThatNeverAnswersGetsTheHintAsWell) {
  for (const char* address : {"10.0.1.100", "127.0.0.1"}) {
    Write(pc_folder, "HOSTGW.CFG", std::string("!ROBOT_PROXY 59001 ") + address + "\n");
    System system({.console = [](std::string_view) {}});
    system.AddRobot("ERS-210", std::make_shared<FolderStick>(pc_folder.path()));
    AddIpStack(&system, 0, std::make_unique<DroppingNetwork>());
    LoadStick(&system, 0, {}, {GatewayImage(&system, 0)});
    system.Boot();
    system.RunFor(30'000'000);
    const bool is_loopback = address[0] == '1' && address[1] == '2';
    EXPECT_EQ(Findings(system),
              is_loopback
                  ? ""
                  : "tcpGateway: !ROBOT_PROXY (port 59001): no answer from 10.0.1.100 within "
                    "5 s; a robot that openr runs on this computer is 127.0.0.1: write that, "
                    "or run with --ip 10.0.1.100=127.0.0.1\n");
  }
}

TEST_F(ProxyTest, ARobotThatComesLaterIsFound) {
  OStatus status = oFAIL;
  StartPc([&] {
    OPrimitiveID id;
    status = OPENR::OpenPrimitive(kHead, &id);
  });
  Frames(400);
  EXPECT_FALSE(caller->done);
  StartRobot();
  Frames(400);
  EXPECT_TRUE(caller->done);
  EXPECT_EQ(status, oSUCCESS);
}

TEST_F(ProxyTest, ACallThatIsNotCarriedIsSaid) {
  StartRobot();
  OStatus control = oSUCCESS;
  StartPc([&] {
    control = OPENR::ControlPrimitive(1, oprmreqCAM_SET_GAIN, nullptr, 0, nullptr, 0);
    OTime time;
    OPENR::GetTime(&time);
  });
  Frames(100);
  ASSERT_TRUE(caller->done);
  EXPECT_EQ(control, oNOT_SUPPORTED);
  EXPECT_NE(Findings(*pc).find("OPENR::ControlPrimitive() is not carried to the robot"),
            std::string::npos);
  EXPECT_NE(Findings(*pc).find("OPENR::GetTime() is not carried to the robot: the layout"),
            std::string::npos);
}

TEST_F(ProxyTest, TheRobotOfThePcsRunAnswersCallsWhoseMessageIsNotKnown) {
  StartRobot();
  std::vector<OStatus> statuses;
  OTime time;
  StartPc([&] {
    OBootCondition boot;
    sbyte hours = 0;
    OVolumeSwitch volume = 0;
    statuses = {OPENR::GetBootCondition(&boot),
                OPENR::SetTime(OTime(1000, 0)),
                OPENR::GetTime(&time),
                OPENR::SetTimeDifference(-3),
                OPENR::GetTimeDifference(&hours),
                OPENR::SetVolumeSwitch(ovolumeSW1),
                OPENR::GetVolumeSwitch(&volume)};
  });
  Frames(100);
  ASSERT_TRUE(caller->done);
  EXPECT_EQ(statuses, (std::vector<OStatus>{101, 104, 105, 197, 106, 107, 108}));
  EXPECT_EQ(time.GetClock(), 86400);
  const std::string findings = Findings(*pc);
  for (const char* function : {"GetBootCondition", "SetTime", "GetTime", "SetTimeDifference",
                               "GetTimeDifference", "SetVolumeSwitch", "GetVolumeSwitch"}) {
    EXPECT_NE(findings.find(std::string("OPENR::") + function +
                            "() is not carried to the robot: the layout of its message is not "
                            "known; the robot of this run answers (docs/network.md)"),
              std::string::npos)
        << function << ": " << findings;
  }
}

TEST_F(ProxyTest, TheRobotOfThePcsRunAnswersCallsThatNeedNoRobot) {
  StartRobot();
  std::vector<OStatus> statuses;
  StartPc([&] {
    OVRSyncKey first = 0, second = 0;
    statuses = {OPENR::DivideSyncKey(5, &first, &second),
                OPENR::ObservePowerStatus(OPowerStatus(), OServiceEntry()),
                OPENR::UnobservePowerStatus(OServiceEntry())};
  });
  Frames(100);
  ASSERT_TRUE(caller->done);
  EXPECT_EQ(statuses, (std::vector<OStatus>{100, 102, 103}));
  EXPECT_EQ(Findings(*pc), "");
}

TEST_F(ProxyTest, TheRobotOfThePcsRunHasTheStateOfTheRun) {
  StartPc([] {});
  RobotServices& services = *pc->robot(0).services;
  ASSERT_NE(&services, own);
  services.Reseed(7);
  EXPECT_EQ(own->seed, 7u);
  Hasher of_proxy, of_robot;
  services.HashState(&of_proxy);
  own->HashState(&of_robot);
  EXPECT_EQ(of_proxy.Digest(), of_robot.Digest());
  EXPECT_FALSE(services.TimeOffUs().has_value());
}

// The gateway, and with it the way to the robot, is made anew at the second boot.
TEST_F(ProxyTest, ABootTimerBootsTheRobotOfThePcsRunAgain) {
  const auto ask = [] {
    OTime time;
    OPENR::GetTime(&time);
  };
  StartPc(ask);
  pc->robot(0).load_again = [this, ask] {
    IpStackOptions options;
    options.address = "10.0.1.2";
    AddIpStack(pc.get(), 0, std::make_unique<LoopbackNetwork>(hub), options);
    caller = pc->AddObject<Caller>(0, "caller", ask);
    return LoadStick(pc.get(), 0, {}, {GatewayImage(pc.get(), 0)});
  };
  Frames(10);
  ASSERT_TRUE(caller->done);
  EXPECT_EQ(pc->robot(0).services->Shutdown(OBootCondition(obcbBOOT_TIMER, 1, obcbttRELATIVE)),
            109u);
  pc->Shutdown(0, {EndKind::kPowerOff, "the test shut the robot down"});
  Frames(10);
  ASSERT_TRUE(pc->robot_table().off_robots().Contains(0));
  EXPECT_EQ(own->times_off, 1);
  EXPECT_GT(own->frames_off, 0);
  EXPECT_EQ(pc->robot(0).boots, 1);
  Frames(200);
  EXPECT_FALSE(pc->robot_table().off_robots().Contains(0));
  EXPECT_EQ(pc->robot(0).boots, 2);
  ASSERT_TRUE(caller->done);
  // Each of the two boots has made one call and got one warning.
  uint64_t warnings = 0;
  for (const Finding& finding : pc->findings().all())
    if (finding.text.find("OPENR::GetTime() is not carried") != std::string::npos)
      warnings += finding.count;
  EXPECT_EQ(warnings, 2u);
}

// ---- a PC that is not ours

TEST_F(ProxyTest, ARobotAnswersBytesOfTheReference) {
  StartRobot();
  const std::string found = Answer(OneItem(Words({1}) + Padded("OVirtualRobot", 64)));
  ASSERT_EQ(found.size(), 24u);
  EXPECT_EQ(found.substr(0, 20), Words({20, 1, 12, 2, 0}));
  const std::string oid = found.substr(20);
  const std::string locator = Padded(kHead, 128);
  EXPECT_EQ(Answer(OneItem(Words({5}) + oid + Words({4, 132, 12}) + Words({1024}) + locator)),
            OneItem(Words({6, 0, 12}) + Words({1025, 0, 0x77})));
  // Request 8 of the control enables the gain.
  const std::string control = Padded(Words({1027, 0, 8, 0, 0, 0, 4, 0, 0x77}), 224);
  const std::string enabled = Answer(OneItem(Words({5}) + oid + Words({9, 224, 224}) + control));
  EXPECT_EQ(enabled.substr(0, 24), Words({244, 1, 236, 6, 0, 224}));
  EXPECT_EQ(enabled.substr(24), control);  // the same message, with status 0
  EXPECT_EQ(asked->heard.back(), "enable 0x77");
}

TEST_F(ProxyTest, WhatTheRobotCannotDoIsAnsweredAndSaid) {
  StartRobot();
  EXPECT_EQ(Answer(OneItem(Words({1}) + Padded("move\x1b[2JMe", 64))), OneItem(Words({2, 12, 0})));
  EXPECT_NE(Findings(*robot).find("looks for 'move?[2JMe'; OVirtualRobot, OPowerManager and "
                                  "ODesignedRobot can be called"),
            std::string::npos)
      << Findings(*robot);
  EXPECT_EQ(Answer(OneItem(Words({5, 0x12345, 4, 0, 8}))), OneItem(Words({6, 7, 0})));
  EXPECT_EQ(Answer(OneItem(Words({5, 0x80000002, 10, 0, 12}))), OneItem(Words({6, 2, 0})));
  EXPECT_NE(Findings(*robot).find("entry 10 of OPowerManager is not carried"), std::string::npos);
  EXPECT_EQ(Answer(OneItem(Words({5, 0x80000001, 4, 3, 12}) + "abc")), OneItem(Words({6, 2, 0})));
  EXPECT_NE(Findings(*robot).find("a message of 3 bytes to OVirtualRobot, entry 4"),
            std::string::npos);
  EXPECT_TRUE(asked->heard.empty());
  EXPECT_FALSE(peer.ended);
  EXPECT_EQ(Answer(OneItem(Words({7, 1, 2, 3}))), "");
  EXPECT_TRUE(peer.ended);
  EXPECT_NE(Findings(*robot).find("has the command 7 (SENDWITHRBOX)"), std::string::npos);
}

}  // namespace
}  // namespace openr_host

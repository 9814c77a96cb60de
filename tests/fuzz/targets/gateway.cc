// The fuzz target gateway: the connections of a running TCPGateway, to which peers connect, send
// whole and partial frames, and close, while a program of the robot sends and receives.
#include <algorithm>
#include <cerrno>
#include <cstring>

#include "runtime/core/load_stick.h"
#include "runtime/core/system.h"
#include "runtime/gateway/tcp_gateway.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/ipstack/loopback_network.h"
#include "runtime/stick/memory_stick.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {
namespace {

constexpr uint32_t kRobotIp = 0x0a000164, kPeerIp = 0x0a000102;
constexpr uint16_t kPorts[] = {59002, 59003, 54300};  // data of the robot, data for it, calls
constexpr size_t kConnections = 6;

// A program of the robot that sends texts, and receives texts of the peers.
class Chat : public CodeObject {
 public:
  Chat() {
    act_ = AddExtra("Act", [this](void*) { Act(); });
    out_ = AddSubject("Chat.Out.Text.S");
    in_ = AddObserver("Chat.In.Text.O", [this](const ONotifyEvent& event) {
      for (int i = 0; i < event.NumOfData(); ++i) {
        RCRegion* const region = event.RCData(i);
        heard += region->Size() == 0 ? '\0' : region->Base()[region->Size() - 1];
        bytes += region->Size();
      }
      data_max = std::max(data_max, event.NumOfData());
    });
  }

  void Do(uint8_t what) {
    what_ = what;
    system().Post(system().NewMessage(host().id, act_));
    system().RunFor(1);
  }

  std::string heard;  // the last byte of each item; reading it shows that its memory is there
  size_t bytes = 0;   // received in all
  int data_max = 0;   // most items of a set

 private:
  void Act() {
    if (what_ % 4 == 0) in_->AssertReady();
    if (what_ % 4 == 1) in_->DeassertReady();
    if (what_ % 4 < 2) return;
    for (int i = what_ / 4 % 4; i >= 0; --i) out_->SetData("text", 4);
    out_->NotifyObservers();
  }

  OSubject* out_;
  OObserver* in_;
  Selector act_ = 0;
  uint8_t what_ = 0;
};

// A stick with three files in memory, because searches in a folder of the host would take a third
// of the time of a short input.
class GatewayStick : public MemoryStick {
 public:
  Location Locate(std::string_view name) override {
    static const FuzzFile objects("/MS/OPEN-R/SYSTEM/OBJS/TCPGW.BIN\n");
    static const FuzzFile connections(
        "Chat.Out.Text.S TCPGateway.Away.Text.O\n"
        "TCPGateway.Home.Text.S Chat.In.Text.O\n");
    static const FuzzFile ports(
        "TCPGateway.Away.Text.O 59002\n"
        "TCPGateway.Home.Text.S 59003\n"
        "TCPGateway.Proxy.AperiosMessage.P 54300\n");
    if (name.ends_with("/CONF/OBJECT.CFG")) return {objects.path(), true, 0};
    if (name.ends_with("/CONF/CONNECT.CFG")) return {connections.path(), true, 0};
    if (name.ends_with("/CONF/ROBOTGW.CFG")) return {ports.path(), true, 0};
    return {"", false, ENOENT};
  }
  uint64_t ContentHash() override { return 0; }
};

std::string Words(std::initializer_list<uint32_t> words) {
  std::string bytes;
  for (const uint32_t word : words) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift);
  }
  return bytes;
}

// The peers of one run.  Each step is a byte, low three bits the connection and high bits what it
// does; the bytes behind it are its arguments.
class Peers {
 public:
  Peers(std::shared_ptr<LoopbackHub> hub, System* system, Chat* chat)
      : net_(std::move(hub)), system_(system), chat_(chat) {
    net_.Attach(kPeerIp);
  }

  void Run(FuzzBytes input) {
    while (!input.empty()) Step(&input);
    for (NetHandle& handle : handles_) Drop(&handle, false);
    Frame();
  }
  int closed() const { return closed_; }

 private:
  void Step(FuzzBytes* input) {
    BeginFuzzStep(input->taken());
    const uint8_t step = input->U8();
    NetHandle& handle = handles_[step % 8 % kConnections];
    switch (step >> 4) {
      case 0:
      case 1:
      case 2:
        Drop(&handle, false);
        handle = net_.NewHandle();
        net_.Connect(handle, static_cast<uint16_t>(40000 + handle),
                     {kRobotIp, kPorts[(step >> 4) % std::size(kPorts)]});
        break;
      case 3:
        Drop(&handle, (step & 8) != 0);
        break;
      case 4:
        Send(handle, Words({(step & 8) != 0 ? kGatewayAssert : kGatewayDeassert}));
        break;
      case 5:
      case 6:
        SendSet(handle, input);
        break;
      case 7:
        Send(handle, std::string(input->Text(input->U8())));
        break;
      case 8:  // a flood
        Send(handle, std::string(size_t{input->U8()} * 256, static_cast<char>(input->U8())));
        break;
      case 9:
        if (handle != 0) net_.Close(handle);
        break;
      case 10:
      case 11:
        chat_->Do(input->U8());
        break;
      case 12:
        system_->RunFor(GatewayConnection::kRetryUs);
        break;
      default:
        Frame();
    }
  }

  // Sends a set, of which some bytes may be missing or have wrong counts.
  void SendSet(NetHandle handle, FuzzBytes* input) {
    const uint8_t shape = input->U8();
    std::string items;
    for (int i = shape % 4; i > 0; --i) {
      const std::string_view item = input->Text(input->U8() % 32);
      items += Words({static_cast<uint32_t>(item.size())}) + std::string(item);
    }
    const uint32_t count = shape % 4 + (shape >= 0xf0 ? input->U32() : 0);
    const auto size = static_cast<uint32_t>(items.size() + 4) + (shape >> 4 == 14 ? 1 : 0);
    std::string set = Words({size, count}) + items;
    if (shape >> 4 == 13) set.resize(set.size() / 2);
    Send(handle, set);
  }

  void Send(NetHandle handle, const std::string& bytes) {
    if (handle != 0 && !bytes.empty()) net_.Send(handle, bytes.data(), bytes.size());
  }
  void Drop(NetHandle* handle, bool reset) {
    if (*handle == 0) return;
    net_.Drop(*handle, reset);
    *handle = 0;
    closed_ += 1;
  }
  void Frame() {
    system_->RunFor(kFrameUs);
    for (const NetHandle handle : handles_) {
      if (handle != 0) net_.Receive(handle, 1 << 16);
    }
    for (const NetworkEvent& event : net_.Poll()) {
      if (event.kind != NetworkEvent::Kind::kFailed) continue;
      for (NetHandle& handle : handles_) {
        if (handle == event.handle) Drop(&handle, false);
      }
    }
  }

  LoopbackNetwork net_;
  System* const system_;
  Chat* const chat_;
  NetHandle handles_[kConnections] = {};
  int closed_ = 0;
};

}  // namespace

bool fuzz::gateway(std::string_view bytes) {
  const auto hub = std::make_shared<LoopbackHub>();
  SystemOptions options;
  options.console = [](std::string_view) {};
  System system(std::move(options));
  system.AddRobot("ERS-210", std::make_shared<GatewayStick>());
  IpStack* const stack = AddIpStack(&system, 0, std::make_unique<LoopbackNetwork>(hub));
  Chat* const chat = system.AddObject<Chat>(0, "chat");
  FuzzCheck(LoadStick(&system, 0, {}, {GatewayImage(&system, 0)}), "the stick loads");
  system.Boot();
  system.RunFor(1000);
  Peers peers(hub, &system, chat);
  peers.Run(FuzzBytes(bytes.substr(0, 4096)));
  // Each service listens, and has a connection, and the last one may be closing.
  FuzzCheck(stack->endpoint_count() <= 3 * std::size(kPorts), "endpoints are given back");
  FuzzCheck(!system.powered_off(), "the robot goes on");
  // Notes the size of the largest set that has arrived and the number of connections, because all
  // sizes and numbers have the same branches.
  ReachFuzzState(
      static_cast<uint64_t>(std::min(chat->data_max, 4) * 8 + std::min(peers.closed(), 7)));
  return chat->data_max > 2 && peers.closed() > 2;
}

}  // namespace openr_host

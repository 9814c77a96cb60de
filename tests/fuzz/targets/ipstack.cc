// The fuzz target ipstack: messages of a program to IPStack, and a network that answers in any way
// and order that network.h allows.
#include <DNSEndpointMsg.h>
#include <EndpointTypes.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <ant.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/ip_stack.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/fuzz/target_list.h"

namespace openr_host {
namespace {

constexpr uint32_t kBufferBytes = 1024;
constexpr size_t kMessageBytes = 2048;  // larger than each struct of a message

// Messages that succeed only if the program and the network have done several other things before.
// The planted bug wants them all in one session.
constexpr const char* kTransfers[] = {"TCP Send", "TCP Receive", "UDP Receive",
                                      "DNS GetHostByName"};

// Remembers what the stack has asked for.  Poll() answers some of it as the input says: with
// success, in part, or with a failure.
class AnyNetwork : public Network {
 public:
  void Attach(uint32_t) override { asked_.clear(); }
  void SelectAddress(NetHandle, uint32_t) override {}
  void Listen(NetHandle listener, uint16_t) override { asked_[listener]; }
  void Accept(NetHandle, NetHandle handle) override { asked_[handle].accepts = true; }
  void Connect(NetHandle handle, uint16_t, NetAddress) override { asked_[handle].connects = true; }
  void Send(NetHandle handle, const void*, size_t size) override { asked_[handle].sends += size; }
  void Receive(NetHandle handle, size_t size) override { asked_[handle].receives = size; }
  void Close(NetHandle handle) override { asked_[handle].closes = true; }
  void Bind(NetHandle handle, uint16_t, bool) override { asked_[handle]; }
  void SendTo(NetHandle, NetAddress, const void*, size_t) override {}
  void ReceiveFrom(NetHandle handle, size_t count) override { asked_[handle].datagrams = count; }
  void Resolve(NetHandle handle, const std::string&) override { asked_[handle].resolves = true; }
  void ResolveAddress(NetHandle handle, uint32_t) override { asked_[handle].resolves = true; }
  void Drop(NetHandle handle, bool) override { asked_.erase(handle); }
  uint16_t HostPort(NetProtocol, uint16_t) const override { return 0; }
  std::vector<NetworkEvent> Poll() override { return std::exchange(events_, {}); }

  // Makes an event for one of the sockets, counted from the newest, for the next Poll().
  void Answer(FuzzBytes* input) {
    if (asked_.empty()) return;
    auto found = asked_.rbegin();
    std::advance(found, input->U8() % asked_.size());
    NetworkEvent event;
    event.handle = found->first;
    if (Fill(&found->second, input, &event)) events_.push_back(event);
    if (event.kind == NetworkEvent::Kind::kFailed) found->second = {};
  }

 private:
  struct Asked {
    bool accepts = false, connects = false, closes = false, resolves = false;
    size_t sends = 0, receives = 0, datagrams = 0;
  };
  using Kind = NetworkEvent::Kind;

  static bool Fill(Asked* asked, FuzzBytes* input, NetworkEvent* event) {
    const uint8_t what = input->U8();
    event->remote = {input->U32(), static_cast<uint16_t>(input->U8() * 100)};
    if (what % 8 == 7) {
      event->kind = Kind::kFailed;
      event->error = static_cast<NetError>(1 + what / 8 % 10);
      return true;
    }
    if (std::exchange(asked->accepts, false)) {
      event->kind = Kind::kAccepted;
    } else if (std::exchange(asked->connects, false)) {
      event->kind = Kind::kConnected;
    } else if (what % 8 < 2 && asked->sends > 0) {
      event->kind = Kind::kSent;
      event->count = 1 + input->U8() % asked->sends;
      asked->sends -= event->count;
    } else if (what % 8 < 5 && asked->receives > 0) {
      event->bytes = input->Text(1 + input->U8() % std::exchange(asked->receives, 0));
      event->kind = event->bytes.empty() ? Kind::kEnd : Kind::kReceived;
    } else if (asked->datagrams > 0) {
      asked->datagrams -= 1;
      event->kind = Kind::kDatagram;
      event->bytes = input->Text(input->U8());
    } else if (std::exchange(asked->resolves, false)) {
      event->kind = Kind::kResolved;
      event->host.name = std::string(input->Text(input->U8()));
      event->host.addresses.assign(input->U8() % 40, event->remote.ip);
      const size_t aliases = input->U8() % 40;
      event->host.aliases.assign(aliases, std::string(input->Text(input->U8())));
    } else if (what % 8 == 5 && asked->closes && asked->sends == 0) {
      asked->closes = false;
      event->kind = Kind::kClosed;
    } else {
      return false;
    }
    return true;
  }

  std::map<NetHandle, Asked> asked_;
  std::vector<NetworkEvent> events_;
};

// A program that sends the stack what the input says.  Endpoints and buffers are counted from the
// newest, so that an input which is put together from two others uses those of each.
class Sender : public CodeObject {
 public:
  Sender() {
    act_ = AddExtra("Act", [this](void*) { Act(); });
    reply_ = AddExtra("Reply", [this](void* payload) { Reply(antEnvMsg::Receive(payload)); });
  }

  void Do(FuzzBytes* input) {
    input_ = input;
    system().Post(system().NewMessage(host().id, act_));
    system().RunFor(1);
  }

  // Returns a set of bits: which of kTransfers were answered with success.
  unsigned transfers() const { return transfers_; }

 private:
  void Reply(antEnvMsg* message) {
    if (!AntMessageText(*message, true).ends_with("_SUCCESS")) return;
    const std::string name = AntMessageName(*message);
    if (name == "TCP Receive") {
      const auto& receive = *static_cast<TCPEndpointReceiveMsg*>(message);
      FuzzCheck(receive.sizeMax <= static_cast<int>(kBufferBytes), "bytes beyond the buffer");
    }
    const auto* const found = std::find(std::begin(kTransfers), std::end(kTransfers), name);
    if (found != std::end(kTransfers)) transfers_ |= 1U << (found - std::begin(kTransfers));
  }

  // Returns an endpoint, or once in a while a reference that no stack has made.
  antModuleRef Endpoint() {
    const uint8_t which = input_->U8();
    if (which >= 0xf0 || endpoints_.empty()) return MakeModuleRef(which % 8, input_->U8());
    return endpoints_[endpoints_.size() - 1 - which % endpoints_.size()];
  }
  int32_t Number() {
    const uint8_t number = input_->U8();
    return number < 0xf0 ? number : static_cast<int32_t>(input_->U32());
  }
  // Returns a place in a buffer, or beyond it.
  byte* Place() {
    const uint8_t which = input_->U8();
    if (buffers_.empty() || which == 0xff) return nullptr;
    return buffers_[buffers_.size() - 1 - which % buffers_.size()] + input_->U8() * 8;
  }

  template <typename M>
  void Send(M message) {
    // A copy with room behind it, because the stack takes as many bytes as the operation has.
    alignas(16) unsigned char room[kMessageBytes] = {};
    static_assert(sizeof message < kMessageBytes);
    std::memcpy(room, static_cast<void*>(&message), sizeof message);
    auto* const copy = reinterpret_cast<antEnvMsg*>(room);
    if (input_->U8() >= 0xf8) copy->dstOperation = Number();
    copy->Send(antStackRef(IpStack::kName), myOID_, static_cast<int32>(reply_), sizeof message);
  }

  void NewEndpoint() {
    constexpr int32 kTypes[] = {EndpointType_TCP, EndpointType_UDP, EndpointType_DNS};
    const uint8_t type = input_->U8();
    const int32_t protocol = type < 0xf0 ? kTypes[type % 3] : Number();
    antEnvCreateEndpointMsg create(protocol, Number());
    create.Call(antStackRef(IpStack::kName), sizeof create);
    if (create.error == ANT_SUCCESS) endpoints_.push_back(create.moduleRef);
  }
  void NewBuffer() {
    if (buffers_.size() >= 8) return;
    antEnvCreateSharedBufferMsg create(kBufferBytes);
    create.Call(antStackRef(IpStack::kName), sizeof create);
    if (create.error == ANT_SUCCESS && create.buffer.Map() == ANT_SUCCESS) {
      buffers_.push_back(static_cast<byte*>(create.buffer.GetAddress()));
    }
  }

  // Takes the bytes of the input in the order of its statements, because compilers differ in the
  // order in which they evaluate the arguments of a call.
  void Act() {
    const uint8_t what = input_->U8() % 24;
    if (what < 2) return NewEndpoint();
    if (what == 2) return NewBuffer();
    antModuleRef endpoint = Endpoint();
    const auto ip = static_cast<uint32_t>(Number());
    const auto port = static_cast<Port>(Number());
    switch (what) {
      case 3:
      case 4:
        return Send(TCPEndpointListenMsg(endpoint, ip, port));
      case 5:
      case 6:
        return Send(TCPEndpointConnectMsg(endpoint, 0, static_cast<Port>(Number()), ip, port));
      case 7: {
        byte* const place = Place();
        return Send(TCPEndpointSendMsg(endpoint, place, Number()));
      }
      case 8:
      case 9: {
        byte* const place = Place();
        const int least = Number();
        return Send(TCPEndpointReceiveMsg(endpoint, place, least, Number()));
      }
      case 10:
        return Send(TCPEndpointCloseMsg(endpoint, ip % 2 != 0, 0, port % 2 != 0));
      case 11:
        return Send(TCPEndpointSetBlockingModeMsg(endpoint, ip % 2 != 0));
      case 12:
        return Send(TCPEndpointBindMsg(endpoint, ip, port));
      case 13:
        return Send(UDPEndpointBindMsg(endpoint, ip, port));
      case 14:
        return Send(UDPEndpointConnectMsg(endpoint, ip, port));
      case 15: {
        byte* const place = Place();
        return Send(UDPEndpointSendMsg(endpoint, ip, port, place, Number()));
      }
      case 16: {
        byte* const place = Place();
        return Send(UDPEndpointReceiveMsg(endpoint, place, Number()));
      }
      case 17:
        return Send(UDPEndpointCloseMsg(endpoint, ip % 2 != 0, 0));
      case 18:
      case 19:
        return Send(DNSEndpointGetHostByNameMsg(endpoint, "aibo.example"));
      case 20:
        return Send(DNSEndpointGetHostByAddrMsg(endpoint, ip));
      case 21:
        return Send(DNSEndpointGetAliasMsg(endpoint, static_cast<int>(ip)));
      case 22:
        return Send(DNSEndpointCloseMsg(endpoint));
      default:
        return Send(UDPEndpointAddressMsg(endpoint));
    }
  }

  FuzzBytes* input_ = nullptr;
  unsigned transfers_ = 0;
  std::vector<antModuleRef> endpoints_;
  std::vector<byte*> buffers_;
  Selector act_ = 0, reply_ = 0;
};

}  // namespace

bool fuzz::ipstack(std::string_view bytes) {
  SystemOptions options;
  options.console = [](std::string_view) {};
  System system(std::move(options));
  system.AddRobot("ERS-210", nullptr);
  const auto network = std::make_shared<AnyNetwork>();
  IpStack* const stack = AddIpStack(&system, 0, network);
  Sender* const sender = system.AddObject<Sender>(0, "sender");
  system.Boot();
  system.RunFor(1000);
  FuzzBytes input(bytes.substr(0, 4096));
  while (!input.empty()) {
    BeginFuzzStep(input.taken());
    switch (input.U8() % 4) {
      case 0:
      case 1:
        sender->Do(&input);
        break;
      case 2:
        network->Answer(&input);
        break;
      default:
        system.RunFor(kFrameUs);
    }
    FuzzCheck(stack->endpoint_count() <= IpStack::kEndpointsMax, "the number of endpoints");
  }
  ReachFuzzState(sender->transfers());
  return sender->transfers() == (1U << std::size(kTransfers)) - 1;
}

}  // namespace openr_host

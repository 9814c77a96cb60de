// A robot that uses sockets of this computer, and other programs on this computer.
#pragma once

#include <gtest/gtest.h>

#include <cerrno>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "runtime/ipstack/host_network.h"
#include "tests/runtime/ipstack/net_probe.h"

namespace openr_host {

constexpr uint32_t kLocal = 0x7f000001;
constexpr int kTriesMax = 200'000;  // in frames; a few are needed, more on a busy computer

// A socket of another program on this computer.
class HostPeer {
 public:
  explicit HostPeer(NetProtocol protocol) : fd(OpenSocket(protocol)) {}

  bool Connect(uint16_t port) {
    const int error = ConnectTo(fd, {kLocal, port});
    return error == 0 || error == EINPROGRESS;
  }
  void Say(const std::string& text) { SendBytes(fd, text.data(), text.size()); }

  // Reads what has arrived; returns false if there is nothing.
  bool Hear() {
    std::string bytes;
    const int64_t count = ReceiveBytes(fd, 65536, &bytes, &from);
    heard += bytes;
    if (count == 0) ended = true;
    if (count < 0 && errno == ECONNRESET) reset = true;
    return count > 0;
  }

  Fd fd;
  std::string heard;
  NetAddress from;
  bool ended = false;
  bool reset = false;
};

class HostRobotTest : public testing::Test {
 protected:
  // Starts the robot; its kPort gets any free port of the host.
  void Start(HostNetworkOptions options) {
    system = std::make_unique<System>();
    system->AddRobot("ERS-210", nullptr);
    IpStackOptions stack_options;
    stack_options.addresses = options.addresses;
    stack = AddIpStack(system.get(), 0, std::make_unique<HostNetwork>(std::move(options)),
                       std::move(stack_options));
    probe = system->AddObject<NetProbe>(0, "probe");
  }
  void Boot() {
    system->Boot();
    system->RunFor(1000);
  }
  void Start() { Start(AnyPort()); }
  static HostNetworkOptions AnyPort() {
    HostNetworkOptions options;
    options.tcp_ports[kPort] = 0;
    options.udp_ports[kPort] = 0;
    return options;
  }
  void Do(std::function<void()> body) {
    probe->Do(std::move(body));
    system->RunFor(1);
  }
  // Runs frames until `done` returns true; returns false after kTriesMax frames.
  bool Until(const std::function<bool()>& done) {
    for (int i = 0; i < kTriesMax; ++i) {
      if (done()) return true;
      system->RunFor(kFrameUs);
      std::this_thread::yield();
    }
    return done();
  }
  bool Hears(HostPeer* peer, const std::string& text) {
    return Until([&] {
      while (peer->Hear()) {
      }
      return peer->heard == text;
    });
  }
  uint16_t TcpPort() { return stack->HostPort(NetProtocol::kTcp, kPort); }

  std::unique_ptr<System> system;
  IpStack* stack = nullptr;
  NetProbe* probe = nullptr;
};

}  // namespace openr_host

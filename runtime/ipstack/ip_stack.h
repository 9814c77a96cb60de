// IPStack: the object that gives programs TCP, UDP and DNS.
//
// It is known by the name "IPStack" and spoken to with the messages of TCPEndpointMsg.h
// and its kin, from Call() and Send() of antEnvMsg.  Those post to entries of their own
// here (EntryFor), since selectors 0 to 3 belong to DoInit to DoDestroy.
//
// Time: what only concerns the stack (creating, binding, a send that fits) is answered
// at the instant it is asked.  What comes from outside enters at multiples of kFrameUs
// of virtual time, and only there: while an operation waits for the network, the stack
// posts itself a Poll message for the next boundary, hands everything Network::Poll()
// returns to the endpoints, and then answers in the order of endpoint and operation.
// When nothing waits there are no such messages.  PollNetwork() is the only caller of
// Network::Poll(): the place to record and to replay what came from outside.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "runtime/config/address_config.h"
#include "runtime/core/code_object.h"
#include "runtime/ipstack/endpoint.h"
#include "runtime/ipstack/network.h"
#include "runtime/ipstack/parameters.h"
#include "runtime/ipstack/shared_buffers.h"
#include "runtime/ipstack/tcp_ports.h"

namespace openr_host {

struct IpStackOptions {
  // What the functions of ERA201D1.h find.
  enum class Card { kPresent, kNoCard, kNoDriver };

  std::string address;  // of the robot, dotted; "": ETHER_IP of its WLANCONF.TXT
  Card card = Card::kPresent;
  // Further addresses: programs may bind to them as to the robot's own (address_config.h).
  std::vector<AddressPair> addresses = {};
};

class IpStack : public CodeObject {
 public:
  static constexpr char kName[] = "IPStack";

  // The robot's limits are not known; these only keep a mistake from taking the host's
  // memory.
  static constexpr size_t kEndpointsMax = 256;  // alive at a time
  static constexpr int32_t kPoolBytesMax = 4 << 20;
  // Pool of an endpoint created with poolSize 0, whose meaning is not documented.
  static constexpr int32_t kPoolBytesDefault = 1 << 20;

  IpStack(std::unique_ptr<Network> network, IpStackOptions options);
  ~IpStack() override;

  // The stack of the current object's robot; null when it has none.
  static IpStack* OfCurrent();

  // Entry of this object for the documented selector (Entry_antEnv_...), 0..2.
  Selector EntryFor(Selector selector) const { return first_entry_ + selector; }

  // Port of the host under which the robot's port is found; 0: none (yet).  For people.
  uint16_t HostPort(NetProtocol protocol, uint16_t port) const {
    return network_->HostPort(protocol, port);
  }

  // Closes what an object that is gone has left open, without answers.
  void ForgetObject(ObjectId owner);

  OStatus DoDestroy(const OSystemEvent& event) override;
  void HashState(Hasher* hasher) const override;

  const IpStackOptions& options() const { return options_; }
  const Parameters& parameters() const { return parameters_; }
  SharedBuffers& buffers() { return buffers_; }
  size_t endpoint_count() const { return endpoints_.size(); }

  // ---- for endpoints

  Network& network() { return *network_; }
  TcpPorts& tcp_ports() { return tcp_ports_; }
  uint32_t address() const { return address_; }

  // Whether a program may name `ip` as its own end: any, loopback, the robot's or a further one.
  bool IsOwnAddress(uint32_t ip) const;

  // `ip` if it is a further address, else 0: the robot's own one.
  uint32_t FurtherAddress(uint32_t ip) const;

  // How a program that bound to `ip` sees its own end.
  uint32_t LocalAddress(uint32_t ip) const { return FurtherAddress(ip) == 0 ? address_ : ip; }

  // A new handle whose events go to `sink`, and its end.
  NetHandle Open(EventSink* sink);
  void Drop(NetHandle handle, bool reset);

  // A port of 1024..4999 that no UDP endpoint has (IPPORT_RESERVED, IPPORT_USERRESERVED);
  // 0 when all are taken.
  uint16_t ChoosePort();
  bool TakeUdpPort(uint16_t port) { return udp_ports_.insert(port).second; }
  void ReturnUdpPort(uint16_t port) { udp_ports_.erase(port); }

  // Gives the message back with `error` in its error field.  `data` are the bytes that
  // were transferred, for the hash.
  void Answer(Operation* operation, int32_t error, const void* data = nullptr, size_t size = 0);

  // A finding about the object that sent `operation`.
  void Warn(const Operation& operation, const std::string& text);

  // If `data`, which are sent now, are not those of the moment of Send().
  void WarnIfChanged(const Operation& operation, const void* data, size_t size);

  // DNS servers, for all objects.
  std::vector<uint32_t>& dns_servers() { return dns_servers_; }

 private:
  void TakeMessage(void* payload);
  void HandleStackMessage(Operation* operation);
  void HandleEndpointMessage(Operation* operation);
  void CreateEndpoint(Operation* operation);
  void PollNetwork();
  void KeepPolling();
  void EraseDead();
  void CloseAll();

  const std::unique_ptr<Network> network_;
  const IpStackOptions options_;
  Parameters parameters_;
  uint32_t address_ = 0;
  SharedBuffers buffers_;
  TcpPorts tcp_ports_;
  std::set<uint16_t> udp_ports_;  // bound ones
  std::vector<uint32_t> dns_servers_;
  std::map<uint32_t, std::unique_ptr<Endpoint>> endpoints_;  // by index
  std::map<NetHandle, EventSink*> sinks_;
  uint32_t last_index_ = 0;
  NetHandle last_handle_ = 0;
  uint16_t next_port_;
  Selector first_entry_ = 0;
  Selector poll_entry_ = 0;
  bool poll_posted_ = false;
};

// Adds the object, before System::Boot().  The System owns it and it owns `network`.
IpStack* AddIpStack(System* system, int robot, std::unique_ptr<Network> network,
                    IpStackOptions options = {});

}  // namespace openr_host

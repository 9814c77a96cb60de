// IPStack, the object through which programs use TCP, UDP and DNS.
//
// The name of the object is "IPStack".  Programs send messages of TCPEndpointMsg.h and similar
// headers to IPStack with Call() and Send() of antEnvMsg.  Each message contains a selector of
// IPStack from 0 to 2.  On the host the selectors 0 to 3 belong to DoInit to DoDestroy.  So Call()
// and Send() post the message to another entry of IPStack (EntryFor).
//
// Time: operations that concern only the stack (creating, binding, a send that fits into the pool
// of its endpoint) are answered at the instant of the request.  Input from outside enters only at
// multiples of kFrameUs of virtual time.  While an operation waits for the network, the stack posts
// itself a Poll message for the next multiple of kFrameUs.  The handler of the Poll message passes
// all events of Network::Poll() to the endpoints.  Then the stack answers the operations in the
// order of endpoint and operation.  If no operation waits, there are no Poll messages.
// PollNetwork() is the only caller of Network::Poll(), so PollNetwork() is the place to record and
// to replay input from outside.
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
  // The state of the network card that the functions of ERA201D1.h report.
  enum class Card { kPresent, kNoCard, kNoDriver };

  std::string address;  // the robot's address, such as "10.0.1.100"; "": ETHER_IP of WLANCONF.TXT
  Card card = Card::kPresent;
  // Pairs of an address that programs use and the host's address that replaces it.  Programs may
  // bind to AddressPair::robot of each pair, besides the robot's own address (address_config.h).
  std::vector<AddressPair> addresses = {};
  // Whether faults of WLANCONF.TXT are added to the findings.  False in a worker process of a
  // distributed run, because the network stack in the master adds them.
  bool reports_settings = true;
};

class IpStack : public CodeObject {
 public:
  static constexpr char kName[] = "IPStack";

  // Limits that keep a faulty program from using up the host's memory.  The values are our choice,
  // because the robot's limits are not known.
  static constexpr size_t kEndpointsMax = 256;  // largest number of endpoints at a time
  static constexpr int32_t kPoolBytesMax = 4 << 20;
  // The size of the pool of an endpoint that was created with poolSize 0.  A pool limits the bytes
  // that an endpoint has sent and the network has not accepted yet.  The size is our choice,
  // because no document says what 0 means.
  static constexpr int32_t kPoolBytesDefault = 1 << 20;

  IpStack(std::shared_ptr<Network> network, IpStackOptions options);
  ~IpStack() override;

  // Returns the network stack of the current object's robot, or null if the robot has none.
  static IpStack* OfCurrent();
  // Returns the network stack of `robot`, or null if the robot has none.
  static IpStack* Of(System* system, int robot);

  // Converts `selector`, the documented selector of an entry of IPStack (Entry_antEnv_..., 0 to 2),
  // to the selector of this entry on the host.  Messages contain the documented selector.  The two
  // selectors differ, because on the host the selectors 0 to 3 belong to DoInit to DoDestroy.
  Selector EntryFor(Selector selector) const { return first_entry_ + selector; }

  // Returns the host's port for the robot's `port`, for messages to the user.  Returns 0 while
  // `port` is not bound to a port of the host.
  uint16_t HostPort(NetProtocol protocol, uint16_t port) const {
    return network_->HostPort(protocol, port);
  }

  // Closes the endpoints of an object that has ended.  Their pending operations get no answers.
  void ForgetObject(ObjectId owner);

  OStatus DoDestroy(const OSystemEvent& event) override;
  void HashState(Hasher* hasher) const override;

  const IpStackOptions& options() const { return options_; }
  const Parameters& parameters() const { return parameters_; }
  SharedBuffers& buffers() { return buffers_; }
  size_t endpoint_count() const { return endpoints_.size(); }

  // ---- Functions that endpoints call

  Network& network() { return *network_; }
  TcpPorts& tcp_ports() { return tcp_ports_; }
  uint32_t address() const { return address_; }

  // Returns whether a program may use `ip` as its own address: 0.0.0.0, loopback, the robot's own
  // address, or one of the other addresses that the options give (IpStackOptions::addresses).
  bool IsOwnAddress(uint32_t ip) const;

  // If `ip` is AddressPair::robot of a pair in IpStackOptions::addresses, and not the robot's own
  // address, returns `ip`.  Otherwise returns 0, which stands for the robot's own address.
  uint32_t FurtherAddress(uint32_t ip) const;

  // Returns the local address that the stack puts into its answers to a program that has bound to
  // `ip`.  For loopback and 0.0.0.0, the local address is the robot's own address.
  uint32_t LocalAddress(uint32_t ip) const { return FurtherAddress(ip) == 0 ? address_ : ip; }

  // Returns a number for a new socket, and sends the events of this socket to `sink`.  Drop(),
  // called with this number, closes the socket.
  NetHandle Open(EventSink* sink);
  void Drop(NetHandle handle, bool reset);

  // Returns a free port of 1024 to 4999 (IPPORT_RESERVED, IPPORT_USERRESERVED), or 0 if there is
  // none.  A port is free if no UDP endpoint has bound it and it is not open for TCP.
  uint16_t ChoosePort();
  bool ReserveUdpPort(uint16_t port) { return udp_ports_.insert(port).second; }
  void ReturnUdpPort(uint16_t port) { udp_ports_.erase(port); }

  // Sends the message of `operation` back to the object that has sent it, with `error` in its error
  // field.  `data` are the transferred bytes; the trace's hash of the answer includes them.
  void Answer(Operation* operation, int32_t error, const void* data = nullptr, size_t size = 0);

  // Adds a finding about the object that has sent `operation`.
  void Warn(const Operation& operation, const std::string& text);
  // Adds a note about `operation` to the findings of its sender.
  void Note(const Operation& operation, const std::string& text);

  // Adds a finding if the program has changed the bytes of a Send after its request.  Compares the
  // hash of the bytes at `data`, which are sent now, with the hash at the time of the request.
  void WarnIfChanged(const Operation& operation, const void* data, size_t size);

  // The addresses of the DNS servers, which programs can set; common to all objects of the robot.
  std::vector<uint32_t>& dns_servers() { return dns_servers_; }

 private:
  void HandleMessage(void* payload);
  void HandleStackMessage(Operation* operation);
  void HandleEndpointMessage(Operation* operation);
  void CreateEndpoint(Operation* operation);
  void PollNetwork();
  void KeepPolling();
  void EraseDead();
  void CloseAll();

  const std::shared_ptr<Network> network_;
  const IpStackOptions options_;
  Parameters parameters_;
  uint32_t address_ = 0;
  SharedBuffers buffers_;
  TcpPorts tcp_ports_;
  std::set<uint16_t> udp_ports_;  // ports that UDP endpoints have bound
  std::vector<uint32_t> dns_servers_;
  // The endpoints of this network stack that are not deleted yet.  The key is the index in the
  // endpoint's reference (antModuleRef).
  std::map<uint32_t, std::unique_ptr<Endpoint>> endpoints_;
  std::map<NetHandle, EventSink*> sinks_;
  uint32_t last_index_ = 0;
  uint16_t next_port_;
  Selector first_entry_ = 0;
  Selector poll_entry_ = 0;
  bool poll_posted_ = false;
};

// Adds the object IPStack to `robot`.  Called before System::Boot(), and at each later boot of the
// robot (in Robot::load_again) with the same `network`.  The System owns the returned stack.
IpStack* AddIpStack(System* system, int robot, std::shared_ptr<Network> network,
                    IpStackOptions options = {});

}  // namespace openr_host

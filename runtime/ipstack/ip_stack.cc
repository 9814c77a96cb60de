#include "runtime/ipstack/ip_stack.h"

#include <EndpointTypes.h>
#include <Internet.h>
#include <fmt/format.h>

#include <cstring>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/dns_endpoint.h"
#include "runtime/ipstack/tcp_endpoint.h"
#include "runtime/ipstack/udp_endpoint.h"

namespace openr_host {
namespace {

MemoryStick* StickOf(const Object& object) {
  return object.system->robot(object.robot).stick.get();
}

// Returns the error that answers an operation on a closed endpoint.  DNS has an error number of its
// own; TCP and UDP share an error number.
int32_t ClosedError(int32_t protocol) {
  return protocol == EndpointType_DNS ? int32_t{DNS_CONNECTION_CLOSED}
                                      : int32_t{TCP_CONNECTION_CLOSED};
}
static_assert(int{TCP_CONNECTION_CLOSED} == int{UDP_CONNECTION_CLOSED});

int32_t InvalidError(int32_t protocol) {
  switch (protocol) {
    case EndpointType_TCP:
      return TCP_OPERATION_INVALID;
    case EndpointType_UDP:
      return UDP_OPERATION_INVALID;
    case EndpointType_DNS:
      return DNS_OPERATION_INVALID;
    default:
      return ANT_FAIL;
  }
}

}  // namespace

IpStack::IpStack(std::shared_ptr<Network> network, IpStackOptions options)
    : network_(std::move(network)),
      options_(std::move(options)),
      parameters_(StickOf(host()), options_.address),
      buffers_(&system().regions()),
      tcp_ports_(this),
      next_port_(IPPORT_RESERVED) {
  host().set_system(true);
  host().set_post_class(MessageClass::kInput);
  if (options_.reports_settings) {
    for (const Diagnostic& diagnostic : parameters_.diagnostics())
      system().AddFindingAbout(&host(), diagnostic.severity, RenderWithoutKind(diagnostic));
  }
  const WlanConfig& wlan = parameters_.wlan();
  address_ = IpFromText(wlan.ether_ip);
  if (!wlan.dns_server_1.empty()) dns_servers_.push_back(IpFromText(wlan.dns_server_1));
  network_->Attach(address_);

  const auto take = [this](void* payload) { HandleMessage(payload); };
  // Adds the entries of the network stack in the order of their documented selectors, 0 to 2,
  // because EntryFor() adds the documented selector to first_entry_.
  first_entry_ = AddExtra("Initialize", take);
  AddExtra("HartBeat", take);
  AddExtra("External", take);
  poll_entry_ = AddExtra("Poll", [this](void*) { PollNetwork(); });
}

IpStack::~IpStack() = default;  // closes no sockets; the destructor of the network closes them

IpStack* IpStack::OfCurrent() {
  return t_current.object == nullptr ? nullptr : Of(t_current.system, t_current.object->robot);
}

IpStack* IpStack::Of(System* system, int robot) {
  Object* const found = system->FindObject(robot, kName);
  auto* const code_host = dynamic_cast<CodeHost*>(found);
  return code_host == nullptr ? nullptr : dynamic_cast<IpStack*>(code_host->code.get());
}

bool IpStack::IsOwnAddress(uint32_t ip) const {
  return ip == 0 || ip == address_ || IPAddress(ip).InLoop() || FurtherAddress(ip) != 0;
}

uint32_t IpStack::FurtherAddress(uint32_t ip) const {
  for (const AddressPair& pair : options_.addresses)
    if (pair.robot == ip && ip != address_) return ip;
  return 0;
}

NetHandle IpStack::Open(EventSink* sink) {
  const NetHandle handle = network_->NewHandle();
  sinks_[handle] = sink;
  return handle;
}

void IpStack::Drop(NetHandle handle, bool reset) {
  if (sinks_.erase(handle) == 1) network_->Drop(handle, reset);
}

uint16_t IpStack::ChoosePort() {
  for (int tries = IPPORT_RESERVED; tries < IPPORT_USERRESERVED; ++tries) {
    const uint16_t port = next_port_;
    next_port_ = port + 1 < IPPORT_USERRESERVED ? static_cast<uint16_t>(port + 1) : IPPORT_RESERVED;
    if (!udp_ports_.contains(port) && !tcp_ports_.IsOpen(port)) return port;
  }
  return 0;
}

void IpStack::Warn(const Operation& operation, const std::string& text) {
  system().AddFindingAbout(system().object(operation.sender), Severity::kWarning, text);
}

void IpStack::Note(const Operation& operation, const std::string& text) {
  system().AddFindingAbout(system().object(operation.sender), Severity::kNote, text);
}

void IpStack::WarnIfChanged(const Operation& operation, const void* data, size_t size) {
  if (AntMessageHash(operation.message(), data, size) == operation.request_hash) return;
  Warn(operation,
       fmt::format("{}: the buffer was written between Send() and its answer; it belongs "
                   "to the stack until then, and what went out is neither the old "
                   "text nor surely the new one",
                   AntMessageName(operation.message())));
}

// Handles a message that an object has sent to the network stack with antEnvMsg::Send() or Call().
void IpStack::HandleMessage(void* payload) {
  const Message& request = *host().running();
  Operation operation;
  const auto& message = *static_cast<const antEnvMsg*>(payload);
  if (request.size < sizeof(antEnvMsg) || request.size < AntMessageSize(message)) {
    system().AddFindingAbout(
        system().object(request.sender), Severity::kWarning,
        fmt::format("{} bytes sent to entry {} of IPStack are no message of the network stack; "
                    "use antEnvMsg::Send() or Call()",
                    request.size, request.selector));
    return;
  }
  ASSERT(request.size <= sizeof operation.bytes, "{} bytes", request.size);
  operation.size = request.size;
  operation.sender = request.sender;
  operation.request_hash = request.payload_hash;
  operation.cause = request.cause;
  std::memcpy(operation.bytes, payload, request.size);
  operation.ticket = system().requests().TakeTicket();
  if (operation.message().dstModule.IsNull()) {
    HandleStackMessage(&operation);
  } else {
    HandleEndpointMessage(&operation);
  }
  KeepPolling();
}

void IpStack::HandleStackMessage(Operation* operation) {
  antEnvMsg& message = operation->message();
  const Object* const sender = system().object(operation->sender);
  if (message.dstSelector == Entry_antEnv_Initialize) {
    switch (message.dstOperation) {
      case antEnv_Operation_InitGetParam:
        return Answer(operation, parameters_.Get(&operation->As<antEnvInitGetParamMsg>()));
      // Refuses the request of an object of a program, because only system objects may set
      // parameters of the network stack.
      case antEnv_Operation_InitSetParam:
        return Answer(operation, sender != nullptr && sender->is_system()
                                     ? parameters_.Set(operation->As<antEnvInitSetParamMsg>())
                                     : ANT_FAIL);
      // Does nothing, because the network stack runs since the boot.  Answers every object with
      // success, because no document says that the robot refuses this request of a program
      // (docs/openr/network.md, 3.3).
      case antEnv_Operation_InitStart:
        return Answer(operation, ANT_SUCCESS);
      default:
        return Answer(operation, ANT_FAIL);
    }
  }
  if (message.dstSelector != Entry_antEnv_External) return Answer(operation, ANT_FAIL);
  switch (message.dstOperation) {
    case antEnv_Operation_CreateEndpoint:
      return CreateEndpoint(operation);
    case antEnv_Operation_CreateSharedBuffer: {
      auto& create = operation->As<antEnvCreateSharedBufferMsg>();
      return Answer(operation, buffers_.Create(create.size, operation->sender, &create.buffer));
    }
    case antEnv_Operation_DestroySharedBuffer: {
      const antError error = buffers_.Destroy(operation->As<antEnvDestroySharedBufferMsg>().buffer);
      if (error == ANT_FAIL)
        Warn(*operation,
             "a shared buffer was to be destroyed while it is mapped; UnMap() it first");
      return Answer(operation, error);
    }
    default:
      return Answer(operation, ANT_FAIL);
  }
}

void IpStack::CreateEndpoint(Operation* operation) {
  auto& message = operation->As<antEnvCreateEndpointMsg>();
  if (message.poolSize < 0) return Answer(operation, ANT_FAIL);
  if (message.poolSize > kPoolBytesMax || endpoints_.size() >= kEndpointsMax) {
    Warn(
        *operation,
        fmt::format("CreateEndpoint fails: pool of {} bytes (most {}), {} endpoints open (most {})",
                    message.poolSize, kPoolBytesMax, endpoints_.size(), kEndpointsMax));
    return Answer(operation, ANT_NOMEMORY);
  }
  const int32_t pool = message.poolSize == 0 ? kPoolBytesDefault : message.poolSize;
  const ObjectId owner = operation->sender;
  std::unique_ptr<Endpoint> endpoint;
  switch (message.protocol) {
    case EndpointType_TCP:
      endpoint = std::make_unique<TcpEndpoint>(this, owner, pool);
      break;
    case EndpointType_UDP:
      endpoint = std::make_unique<UdpEndpoint>(this, owner, pool);
      break;
    case EndpointType_DNS:
      endpoint = std::make_unique<DnsEndpoint>(this, owner, pool);
      break;
    default:
      return Answer(operation, ANT_ENDPOINT_NOFACTORY);
  }
  endpoints_[++last_index_] = std::move(endpoint);
  message.moduleRef = MakeModuleRef(message.protocol, last_index_);
  Answer(operation, ANT_SUCCESS);
}

void IpStack::HandleEndpointMessage(Operation* operation) {
  const antModuleRef& ref = operation->message().dstModule;
  const int32_t protocol = ProtocolOf(ref);
  const auto found = endpoints_.find(ref.index);
  if (found == endpoints_.end() || found->second->protocol() != protocol) {
    // Recognises the reference to a closed endpoint by its index.  Endpoints get their indexes in
    // ascending order, so an unknown index that is not larger than the last index belonged to a
    // closed endpoint.
    const bool was_closed = found == endpoints_.end() && ref.index != 0 && ref.index <= last_index_;
    return Answer(operation,
                  was_closed && protocol != 0 ? ClosedError(protocol) : InvalidError(protocol));
  }
  found->second->Start(*operation);
  found->second->AnswerReady();
  if (found->second->dead()) endpoints_.erase(found);
}

void IpStack::Answer(Operation* operation, int32_t error, const void* data, size_t size) {
  antEnvMsg& message = operation->message();
  SetAntError(&message, error);
  // Sets the numbers of received bytes and found addresses in an answer with an error to 0, because
  // such an answer has no data.  The error 0 means success in every protocol.
  if (error != 0) ClearCounts(&message);
  const uint64_t hash = AntMessageHash(message, data, size);
  if (operation->ticket.box != 0) {
    system().requests().Reply(operation->ticket, operation->bytes, operation->size, hash);
    return;
  }
  OwnedMessage answer =
      system().NewMessage(ObjectIdOf(message.contInfo.oid), message.contInfo.selector);
  std::memcpy(answer->payload, operation->bytes, Message::kPayloadMax);
  answer->size = operation->size;
  answer->kind = PayloadKind::kHashed;
  answer->payload_hash = hash;
  system().Post(std::move(answer));  // drops the answer if the object that has asked has ended
}

void IpStack::PollNetwork() {
  poll_posted_ = false;
  for (auto& [index, endpoint] : endpoints_) endpoint->BeginFrame();
  for (const NetworkEvent& event : network_->Poll()) {
    if (event.kind == NetworkEvent::Kind::kNote) {
      system().AddFindingAbout(&host(), Severity::kWarning, event.bytes);
      continue;
    }
    const auto sink = sinks_.find(event.handle);
    if (sink != sinks_.end()) sink->second->StoreEvent(event);
  }
  for (auto& [index, endpoint] : endpoints_) endpoint->AnswerReady();
  EraseDead();
  KeepPolling();
}

void IpStack::EraseDead() {
  std::erase_if(endpoints_, [](const auto& entry) { return entry.second->dead(); });
}

// Posts a Poll message for the beginning of the next frame (a multiple of 8 ms) if an endpoint
// waits for the network.  The handler of this message polls the network.
void IpStack::KeepPolling() {
  if (poll_posted_) return;
  bool needed = false;
  for (const auto& [index, endpoint] : endpoints_) needed = needed || endpoint->WaitsForNetwork();
  if (!needed) return;
  // Post() adds crowding_delay_us() to the delay of a message: 1 us while very many messages are
  // delivered at one instant, so that time goes on, otherwise 0.  The Poll message must be due
  // exactly at the beginning of the frame, so this function subtracts crowding_delay_us() first.
  const int64_t now_us = system().now_us();
  const int64_t delay_us = kFrameUs - now_us % kFrameUs - system().poster().crowding_delay_us();
  system().Post(system().NewMessage(host().id, poll_entry_), delay_us);
  poll_posted_ = true;
}

void IpStack::ForgetObject(ObjectId owner) {
  for (auto& [index, endpoint] : endpoints_) {
    if (endpoint->owner() == owner) endpoint->Drop();
  }
  EraseDead();
  buffers_.ForgetObject(owner);
}

void IpStack::CloseAll() {
  for (auto& [index, endpoint] : endpoints_) endpoint->Drop();
  endpoints_.clear();
  tcp_ports_.CloseAll();
}

OStatus IpStack::DoDestroy(const OSystemEvent&) {
  CloseAll();
  return oSUCCESS;
}

void IpStack::HashState(Hasher* hasher) const {
  hasher->Add(address_);
  parameters_.HashState(hasher);
  buffers_.HashState(hasher);
  hasher->Add(last_index_);
  hasher->Add(network_->last_handle());
  hasher->Add(next_port_);
  hasher->Add(poll_posted_);
  for (const uint16_t port : udp_ports_) hasher->Add(port);
  for (const uint32_t server : dns_servers_) hasher->Add(server);
  for (const auto& [index, endpoint] : endpoints_) {
    hasher->Add(index);
    hasher->Add(endpoint->protocol());
    hasher->Add(endpoint->owner());
    endpoint->HashState(hasher);
  }
}

IpStack* AddIpStack(System* system, int robot, std::shared_ptr<Network> network,
                    IpStackOptions options) {
  IpStack* const stack =
      system->AddObject<IpStack>(robot, IpStack::kName, std::move(network), std::move(options));
  const bool is_first_boot = robot >= system->robot_count() || system->robot(robot).boots == 1;
  if (is_first_boot) {
    system->object_table().OnEnd([system, robot](ObjectId id) {
      IpStack* const present = IpStack::Of(system, robot);
      if (present == nullptr) return;
      const CurrentScope scope(system, &present->host());
      present->ForgetObject(id);
    });
  }
  return stack;
}

}  // namespace openr_host

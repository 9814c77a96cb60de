#include "runtime/gateway/tcp_gateway.h"

#include <antEnvMsg.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <iterator>
#include <optional>
#include <utility>

#include "runtime/base/hasher.h"
#include "runtime/core/system.h"
#include "runtime/gateway/proxy_client.h"
#include "runtime/gateway/proxy_server.h"
#include "runtime/gateway/proxy_services.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {

TcpGateway::TcpGateway(const GatewayConfig& config) {
  host().set_system(true);
  answer_ = AddExtra("Network", [this](void* payload) {
    const antEnvMsg& answer = *antEnvMsg::Receive(payload);
    const auto index = reinterpret_cast<uintptr_t>(answer.continuation);
    channels_.at(index)->connection().HandleAnswer(answer);
  });
  open_ = AddExtra("Open", [this](void* payload) {
    int index = 0;
    std::memcpy(&index, payload, sizeof index);
    channels_.at(static_cast<size_t>(index))->connection().Open();
  });
  for (const GatewayRecord& record : config.services) AddChannel(record);
  AddProxies(config);
  look_ = AddExtra("Look", [this](void* payload) {
    int index = 0;
    std::memcpy(&index, payload, sizeof index);
    channels_.at(static_cast<size_t>(index))->connection().WarnIfNoAnswer();
  });
  // Makes the gateway's message queue large enough for all its channels (services).  A channel has
  // only a few messages at a time (answers of the network, data, readies), so 8 for each channel
  // are enough.
  host().set_queue_max(std::max(host().queue_max(), 8 * static_cast<int>(channels_.size())));
}

TcpGateway::~TcpGateway() = default;

void TcpGateway::AddChannel(const GatewayRecord& record) {
  const int index = static_cast<int>(channels_.size());
  const std::string service = Compose(record.service);
  if (record.service.is_subject()) {
    auto channel = std::make_unique<IncomingChannel>(this, index, record);
    channel->set_subject(
        AddSubject(service, [to = channel.get()](const OReadyEvent& event) { to->Ready(event); }));
    channels_.push_back(std::move(channel));
  } else {
    auto channel = std::make_unique<OutgoingChannel>(this, index, record);
    channel->set_observer(AddObserver(
        service, [to = channel.get()](const ONotifyEvent& event) { to->Notify(event); }));
    channels_.push_back(std::move(channel));
  }
}

void TcpGateway::AddProxies(const GatewayConfig& config) {
  if (!config.proxy) return;
  const int index = static_cast<int>(channels_.size());
  if (config.proxy->host.empty()) {
    channels_.push_back(std::make_unique<ProxyServer>(this, index, *config.proxy));
    return;
  }
  auto client = std::make_unique<ProxyClient>(this, index, *config.proxy);
  proxy_client_ = client.get();
  channels_.push_back(std::move(client));
  call_ = AddExtra("Call", [this](void* payload) {
    proxy_client_->AddRequest(payload, host().running()->size);
  });
  expire_ = AddExtra("Expire", [this](void*) { proxy_client_->Expire(); });
}

// Connects to the robot that HOSTGW.CFG names for OPEN-R calls (calls of OPENR:: functions by
// objects of a PC).  DoStart would be too late, because objects call these functions in their
// DoInit.
OStatus TcpGateway::DoInit(const OSystemEvent&) {
  stack_ = antStackRef(IpStack::kName);
  if (proxy_client_ != nullptr && stack_.IsValid()) proxy_client_->connection().Open();
  return oSUCCESS;
}

OStatus TcpGateway::DoStart(const OSystemEvent&) {
  if (!stack_.IsValid()) {
    Warn("the robot has no network; nothing is carried");
    return oSUCCESS;
  }
  for (const auto& channel : channels_)
    if (channel.get() != proxy_client_) channel->connection().Open();
  return oSUCCESS;
}

void TcpGateway::PostToStack(antEnvMsg* message, int size) {
  message->Send(stack_, myOID_, static_cast<int32>(answer_), size);
}

void TcpGateway::OpenLater(int channel, int64_t delay_us) { PostLater(open_, channel, delay_us); }
void TcpGateway::CheckForAnswerLater(int channel, int64_t delay_us) {
  PostLater(look_, channel, delay_us);
}

void TcpGateway::PostLater(Selector entry, int channel, int64_t delay_us) {
  OwnedMessage message = system().NewMessage(host().id, entry);
  std::memcpy(message->payload, &channel, sizeof channel);
  message->size = sizeof channel;
  system().Post(std::move(message), delay_us);
}

void TcpGateway::ExpireLater(int64_t delay_us) {
  system().Post(system().NewMessage(host().id, expire_), delay_us);
}

void TcpGateway::Warn(const std::string& text) {
  system().AddFindingAbout(&host(), Severity::kWarning, text);
}

void TcpGateway::HashState(Hasher* hasher) const {
  for (const auto& channel : channels_) channel->HashState(hasher);
}

namespace {

// Reads the gateway's configuration from a stick and adds the gateway to the System.
class GatewayLoader {
 public:
  GatewayLoader(System* system, int robot)
      : system_(system),
        robot_(robot),
        has_robot_file_(Text(kRobotGatewayFile).has_value()),
        config_(Read(kRobotGatewayFile, GatewaySide::kRobot)) {
    GatewayConfig other = Read(kHostGatewayFile, GatewaySide::kHost);
    // If both ROBOTGW.CFG and HOSTGW.CFG have a line for OPEN-R calls (calls of OPENR:: functions
    // that a program on a PC sends to a robot), uses the line of ROBOTGW.CFG: this run then plays
    // the robot that answers such calls.  The line of HOSTGW.CFG would make it play the PC.
    if (!config_.proxy) config_.proxy = std::move(other.proxy);
    std::move(other.services.begin(), other.services.end(), std::back_inserter(config_.services));
    std::move(other.diagnostics.begin(), other.diagnostics.end(),
              std::back_inserter(config_.diagnostics));
    // Removes the ProxyServices that the robot's previous boot has made to send OPEN-R calls of
    // objects to another robot.  Add() makes a new ProxyServices if the gateway files of the stick
    // still name such a robot.
    ProxyServices::Remove(&system_->robot(robot_).services);
  }

  void Add() {
    if (host_ != nullptr) return;
    auto* const gateway = system_->AddObject<TcpGateway>(robot_, TcpGateway::kName, config_);
    host_ = &gateway->host();
    Report(config_.diagnostics);
    if (CallsARobot()) {
      std::unique_ptr<RobotServices>& services = system_->robot(robot_).services;
      services = std::make_unique<ProxyServices>(system_, host_->id, gateway->call_entry(),
                                                 std::move(services));
    }
    if (config_.services.empty() && !config_.proxy)
      Warn(fmt::format("{} names no service; nothing is carried", kRobotGatewayFile));
  }

  // Reports lines of CONNECT.CFG that connect services which the gateway does not have.  Adds the
  // gateway first if it is needed and OBJECT.CFG does not name it.  Called after the stick has been
  // read.
  void CheckWires() {
    const auto text = Text("CONNECT.CFG");
    if (!text && !CallsARobot()) return;
    const ConnectConfig wires = ParseConnectConfig("CONNECT.CFG", text.value_or(""), Design());
    const bool is_wired = !config_.services.empty() && NamesGateway(wires);
    // Adds the gateway, although OBJECT.CFG does not name it, if CONNECT.CFG connects one of its
    // services, or if the gateway files name a robot for OPEN-R calls.  Only the stick of a robot
    // must name the gateway in OBJECT.CFG; the stick of a PC need not.
    if (host_ == nullptr && (is_wired || CallsARobot())) {
      Add();
      if (has_robot_file_)
        Warn(
            fmt::format("OBJECT.CFG does not name /MS/OPEN-R/SYSTEM/OBJS/{}; the robot has no "
                        "gateway then",
                        kGatewayImage));
    }
    if (host_ == nullptr) return;
    Report(
        CheckGatewayWires(wires, config_, has_robot_file_ ? kRobotGatewayFile : kHostGatewayFile));
  }

 private:
  const std::string& Design() { return system_->robot(robot_).design; }

  std::optional<std::string> Text(const char* name) {
    MemoryStick* const stick = system_->robot(robot_).stick.get();
    return stick == nullptr ? std::nullopt
                            : stick->ReadFile(std::string("/MS/OPEN-R/MW/CONF/") + name);
  }

  GatewayConfig Read(const char* file, GatewaySide side) {
    const auto text = Text(file);
    return text ? ParseGatewayConfig(file, *text, Design(), side) : GatewayConfig();
  }

  // Returns whether HOSTGW.CFG names a robot to which calls of OPENR:: functions are sent.  In this
  // case the run plays a PC, and the gateway is added even if neither OBJECT.CFG nor CONNECT.CFG of
  // the PC's stick names it.
  bool CallsARobot() const { return config_.proxy && !config_.proxy->host.empty(); }

  static bool NamesGateway(const ConnectConfig& wires) {
    return std::any_of(wires.connections.begin(), wires.connections.end(), [](const auto& wire) {
      return Compose(wire.subject).starts_with(kGatewayPrefix) ||
             Compose(wire.observer).starts_with(kGatewayPrefix);
    });
  }

  void Report(const std::vector<Diagnostic>& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics)
      system_->AddFindingAbout(host_, diagnostic.severity, RenderWithoutKind(diagnostic));
  }
  void Warn(std::string text) {
    system_->AddFindingAbout(host_, Severity::kWarning, std::move(text));
  }

  System* const system_;
  const int robot_;
  const bool has_robot_file_;
  GatewayConfig config_;  // the records of ROBOTGW.CFG and HOSTGW.CFG
  const Object* host_ = nullptr;
};

}  // namespace

SystemImage GatewayImage(System* system, int robot) {
  const auto loader = std::make_shared<GatewayLoader>(system, robot);
  return {kGatewayImage, [loader] { loader->Add(); }, [loader] { loader->CheckWires(); }};
}

}  // namespace openr_host

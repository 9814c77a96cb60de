#include "openr/serve/robot_client.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"

namespace openr_host {
namespace {

constexpr NetHandle kHandle = 1;
constexpr uint32_t kFirstIp = 0x0a000103;  // 10.0.1.3, the lowest address that a connection gets
constexpr uint16_t kFirstPort = 40000;
constexpr size_t kReceiveMax = size_t{1} << 20;
constexpr int kClientsMax = 64;

const char* TextOf(NetError error) {
  switch (error) {
    case NetError::kRefused:
      return "no object listens on this port yet";
    case NetError::kReset:
    case NetError::kClosed:
      return "the robot has closed the connection";
    default:
      return "the connection has failed";
  }
}

}  // namespace

int RobotClients::Connect(const System& system, int robot, uint16_t port) {
  if (robot < 0 || robot >= system.robot_count())
    throw std::runtime_error(fmt::format("there is no robot {}", robot));
  const auto is_open = [](const auto& client) { return !client.second.has_ended; };
  if (std::ranges::count_if(clients_, is_open) >= kClientsMax)
    throw std::runtime_error(fmt::format("{} connections are open, close some", kClientsMax));
  const IpStack* const stack = IpStack::Of(const_cast<System*>(&system), robot);
  if (stack == nullptr) throw std::runtime_error("the robot has no network now");
  const int number = ++last_;
  Client& client = clients_[number];
  client.network = std::make_unique<LoopbackNetwork>(HubOf(robot));
  client.ip = FreeAddress(robot, stack->address());
  client.robot = robot;
  client.network->Attach(client.ip);
  // Ports may repeat, because connections that are open have different addresses.
  client.network->Connect(kHandle, static_cast<uint16_t>(kFirstPort + number % 20000),
                          {stack->address(), port});
  Poll(&client);
  if (client.problem.empty()) return number;
  const std::string problem = client.problem;
  clients_.erase(number);
  throw std::runtime_error(fmt::format("port {}: {}", port, problem));
}

uint32_t RobotClients::FreeAddress(int robot, uint32_t robot_ip) const {
  std::set<uint32_t> taken = {robot_ip};
  for (const auto& [number, client] : clients_) {
    if (client.robot == robot && !client.has_ended) taken.insert(client.ip);
  }
  uint32_t ip = kFirstIp;
  while (taken.contains(ip)) ++ip;
  return ip;
}

RobotClients::Client& RobotClients::Find(int connection) {
  const auto found = clients_.find(connection);
  if (found != clients_.end()) return found->second;
  throw std::runtime_error(fmt::format("there is no connection {}", connection));
}

void RobotClients::Poll(Client* client) {
  for (const NetworkEvent& event : client->network->Poll()) {
    if (event.kind == NetworkEvent::Kind::kConnected) {
      client->is_connected = true;
    } else if (event.kind == NetworkEvent::Kind::kReceived) {
      client->received += event.bytes;
    } else if (event.kind == NetworkEvent::Kind::kEnd) {
      client->has_ended = true;
    } else if (event.kind == NetworkEvent::Kind::kFailed) {
      client->problem = TextOf(event.error);
      client->has_ended = true;
    } else {
      continue;
    }
    if (!client->has_ended) client->network->Receive(kHandle, kReceiveMax);
  }
}

RobotClients::State RobotClients::StateOf(int connection) {
  Client& client = Find(connection);
  Poll(&client);
  return {client.is_connected && !client.has_ended, client.has_ended, client.is_closed,
          client.problem, client.received.size()};
}

void RobotClients::Send(int connection, std::string_view bytes) {
  Client& client = Find(connection);
  Poll(&client);
  if (client.is_closed) throw std::runtime_error("the connection is closed");
  if (client.has_ended)
    throw std::runtime_error(client.problem.empty() ? "the robot has ended the connection"
                                                    : client.problem);
  client.network->Send(kHandle, bytes.data(), bytes.size());
}

std::string RobotClients::Take(int connection, size_t size_max) {
  Client& client = Find(connection);
  Poll(&client);
  const size_t size = std::min(size_max, client.received.size());
  std::string bytes = client.received.substr(0, size);
  client.received.erase(0, size);
  return bytes;
}

void RobotClients::Close(int connection) {
  Client& client = Find(connection);
  client.network->Close(kHandle);
  // Does not delete the client's network object yet, because the robot may still read bytes that
  // were sent before.
  client.has_ended = true;
  client.is_closed = true;
}

}  // namespace openr_host

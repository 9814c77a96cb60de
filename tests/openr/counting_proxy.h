// CountingProxy, which stands between a client of the remote control and a robot.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "openr/remote/connection.h"

namespace openr_host {

// Forwards the bytes of connections to a robot and back, and writes down the requests, those in
// batches each on its own.  Can fall silent and can end all connections.
class CountingProxy {
 public:
  explicit CountingProxy(const openr::remote::Address& robot)
      : robot_port_(robot.port), listener_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address = Loopback(0);
    socklen_t size = sizeof address;
    bind(listener_, reinterpret_cast<sockaddr*>(&address), size);
    listen(listener_, 4);
    getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    address_ = "127.0.0.1:" + std::to_string(ntohs(address.sin_port));
    thread_ = std::thread([this] { Run(); });
  }
  ~CountingProxy() {
    is_ended_ = true;
    thread_.join();
    Cut();
    close(listener_);
  }
  CountingProxy(const CountingProxy&) = delete;
  CountingProxy& operator=(const CountingProxy&) = delete;

  const std::string& address() const { return address_; }  // for clients

  // Forwards nothing more.
  void FallSilent() { is_silent_ = true; }
  // Ends all connections.
  void End() { is_cut_ = true; }

  // Returns the requests that were forwarded, in their order: command and first byte of the payload
  // (the device, for commands of one), -1 without payload.
  std::vector<std::pair<int, int>> requests() const {
    const std::lock_guard lock(mutex_);
    return requests_;
  }
  int Count(int command) const {
    int count = 0;
    for (const auto& [each, device] : requests()) count += each == command ? 1 : 0;
    return count;
  }

 private:
  struct Pair {
    int client, robot;
    RcFramer framer;
  };

  static sockaddr_in Loopback(uint16_t port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(port);
    return address;
  }

  void Run() {
    while (!is_ended_) {
      if (is_cut_) Cut();
      std::vector<pollfd> wanted{{listener_, POLLIN, 0}};
      for (const auto& pair : pairs_) {
        wanted.push_back({pair->client, POLLIN, 0});
        wanted.push_back({pair->robot, POLLIN, 0});
      }
      if (is_silent_) wanted.clear();
      poll(wanted.data(), wanted.size(), 5);
      for (size_t i = 1; i < wanted.size(); ++i) {
        if (wanted[i].revents != 0) Forward(pairs_[(i - 1) / 2].get(), i % 2 == 1);
      }
      if (!wanted.empty() && wanted[0].revents != 0) Accept();
    }
  }

  void Accept() {
    auto pair = std::make_unique<Pair>();
    pair->client = accept(listener_, nullptr, nullptr);
    pair->robot = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = Loopback(robot_port_);
    if (!is_cut_) connect(pair->robot, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    pairs_.push_back(std::move(pair));
  }

  void Forward(Pair* pair, bool from_client) {
    uint8_t bytes[RC_MAX_PACKET];
    const ssize_t count = recv(from_client ? pair->client : pair->robot, bytes, sizeof bytes, 0);
    if (count <= 0) {
      shutdown(pair->client, SHUT_RDWR);
      shutdown(pair->robot, SHUT_RDWR);
      return;
    }
    (void)!send(from_client ? pair->robot : pair->client, bytes, static_cast<size_t>(count),
                MSG_NOSIGNAL);
    if (!from_client) return;
    pair->framer.Append(bytes, static_cast<int>(count));
    Note(&pair->framer);
  }

  void Note(RcFramer* framer) {
    while (framer->Next() == RcFramer::PACKET) {
      if (framer->Header().command == rcBATCH) {
        RcFramer inner;
        inner.Append(framer->Payload(), framer->PayloadSize());
        Note(&inner);
      } else if (framer->Header().command != rcEVENT) {
        const std::lock_guard lock(mutex_);
        requests_.emplace_back(framer->Header().command,
                               framer->PayloadSize() > 0 ? framer->Payload()[0] : -1);
      }
    }
  }

  void Cut() {
    for (const auto& pair : pairs_) {
      close(pair->client);
      close(pair->robot);
    }
    pairs_.clear();
  }

  const uint16_t robot_port_;
  const int listener_;
  std::string address_;
  std::atomic<bool> is_ended_ = false, is_silent_ = false, is_cut_ = false;
  mutable std::mutex mutex_;
  std::vector<std::pair<int, int>> requests_;
  std::vector<std::unique_ptr<Pair>> pairs_;
  std::thread thread_;
};

}  // namespace openr_host

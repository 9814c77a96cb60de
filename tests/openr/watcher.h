// A client of the socket of a run.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <deque>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

namespace openr_host {

// A connection to the socket of a run.
class Watcher {
 public:
  explicit Watcher(const std::string& socket_path) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, socket_path.c_str(), sizeof address.sun_path - 1);
    socket_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    EXPECT_EQ(connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ~Watcher() { close(socket_); }
  Watcher(const Watcher&) = delete;
  Watcher& operator=(const Watcher&) = delete;

  void Write(const std::string& line) const {
    const std::string text = line + "\n";
    ASSERT_EQ(send(socket_, text.data(), text.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(text.size()));
  }

  // Returns the next line; null if the run has ended or sends nothing for 20 s.
  nlohmann::ordered_json Next() {
    for (size_t end; (end = received_.find('\n')) == std::string::npos;) {
      pollfd waited = {socket_, POLLIN, 0};
      char buffer[64 << 10];
      if (poll(&waited, 1, 20'000) <= 0) return nullptr;
      const ssize_t count = recv(socket_, buffer, sizeof buffer, 0);
      if (count <= 0) return nullptr;
      received_.append(buffer, static_cast<size_t>(count));
    }
    const size_t end = received_.find('\n');
    nlohmann::ordered_json line = nlohmann::ordered_json::parse(received_.substr(0, end));
    received_.erase(0, end + 1);
    return line;
  }

  // Sends a request and returns its answer; null if the run ends before.  Keeps the events that
  // come before the answer for WaitFor().
  nlohmann::ordered_json Ask(const std::string& request) {
    Write(request);
    for (nlohmann::ordered_json line = Next();; line = Next()) {
      if (line.is_null() || !line.contains("event")) return line;
      kept_.push_back(std::move(line));
    }
  }

  // Returns the next event `name` for which `fits` holds; null if the run ends before, or if none
  // comes for a minute.
  template <typename Fits>
  nlohmann::ordered_json WaitFor(const std::string& name, Fits fits) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (std::chrono::steady_clock::now() < deadline) {
      nlohmann::ordered_json line;
      if (kept_.empty()) {
        line = Next();
      } else {
        line = std::move(kept_.front());
        kept_.pop_front();
      }
      if (line.is_null() || (line.value("event", "") == name && fits(line))) return line;
    }
    return nullptr;
  }
  nlohmann::ordered_json WaitFor(const std::string& name) {
    return WaitFor(name, [](const nlohmann::ordered_json&) { return true; });
  }

  // Forgets the events that have come.
  void DropEvents() { kept_.clear(); }

 private:
  int socket_ = -1;
  std::string received_;
  std::deque<nlohmann::ordered_json> kept_;
};

}  // namespace openr_host

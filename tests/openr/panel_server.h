// Fixtures for tests of the panel's server: `openr panel`, and a run that the test plays itself.
#pragma once

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "cli/install_paths.h"
#include "openr/live/live_folder.h"
#include "runtime/base/temp_folder.h"
#include "tests/openr/program_run.h"
#include "tests/openr/web_client.h"

namespace openr_host {

// Every test has a folder of sockets of its own.
class PanelTest : public ::testing::Test {
 protected:
  PanelTest() { setenv("XDG_RUNTIME_DIR", folder_.path().c_str(), 1); }
  ~PanelTest() override { unsetenv("XDG_RUNTIME_DIR"); }

  void SetUp() override {
    if (!std::filesystem::exists(PanelLibrary()))
      GTEST_SKIP() << "this openr was built without libwebsockets";
  }

  // Reads port and token from the address that the server has printed.
  void ReadAddress(const std::string& text) {
    std::smatch match;
    ASSERT_TRUE(std::regex_search(
        text, match, std::regex("panel: http://127\\.0\\.0\\.1:(\\d+)/\\?token=([0-9a-f]{32})\n")))
        << text;
    port_ = std::stoi(match[1]);
    token_ = match[2];
  }

  Handshake Known(const std::string& run = "") const {
    return {.protocol = "openr." + token_, .query = run.empty() ? "" : "?run=" + run};
  }

  const TempFolder folder_;
  int port_ = 0;
  std::string token_;
};

// A run whose socket the test serves.
class FakeRun {
 public:
  explicit FakeRun(const std::string& name) : path_(LiveSocketPath(name)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path_.c_str(), sizeof address.sun_path - 1);
    EXPECT_EQ(bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(listen(listener_, 16), 0);
  }
  ~FakeRun() {
    Close();
    close(listener_);
    unlink(path_.c_str());
  }
  FakeRun(const FakeRun&) = delete;
  FakeRun& operator=(const FakeRun&) = delete;

  // "name.123"
  std::string id() const { return std::filesystem::path(path_).filename(); }

  // Waits for a client, with which the functions below speak from now on.
  void Accept() {
    client_ = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    ASSERT_GE(client_, 0);
    clients_.push_back(client_);
    received_.clear();
  }
  // Returns the next line of the client, without its end; "" when the client has gone.
  std::string Line() {
    for (;;) {
      const size_t end = received_.find('\n');
      if (end != std::string::npos) {
        const std::string line = received_.substr(0, end);
        received_.erase(0, end + 1);
        return line;
      }
      char buffer[64 << 10];
      const ssize_t n = recv(client_, buffer, sizeof buffer, 0);
      if (n <= 0) return "";
      received_.append(buffer, static_cast<size_t>(n));
    }
  }
  // Sends lines.  Returns false when the client has gone.
  bool Write(const std::string& text) {
    for (size_t sent = 0; sent < text.size();) {
      const ssize_t n = send(client_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
      if (n <= 0) return false;
      sent += static_cast<size_t>(n);
    }
    return true;
  }
  // Closes the connections to all clients.
  void Close() {
    for (const int client : clients_) close(client);
    clients_.clear();
  }

 private:
  const std::string path_;
  const int listener_ = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  int client_ = -1;
  std::vector<int> clients_;
  std::string received_;
};

}  // namespace openr_host

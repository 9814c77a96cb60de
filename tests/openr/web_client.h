// A small client of HTTP and WebSockets (RFC 6455) for tests of the panel's server.
#pragma once

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace openr_host {

// A TCP connection to a port of 127.0.0.1.  Waits two minutes at most.
class TcpClient {
 public:
  explicit TcpClient(int port) : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    is_good_ = connect(socket_, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  ~TcpClient() { close(socket_); }
  TcpClient(const TcpClient&) = delete;
  TcpClient& operator=(const TcpClient&) = delete;

  void Write(const std::string& bytes) {
    for (size_t sent = 0; is_good_ && sent < bytes.size();) {
      const ssize_t n = send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (n <= 0) is_good_ = false;
      if (n > 0) sent += static_cast<size_t>(n);
    }
  }
  // Waits until `count` bytes have come.  Returns fewer if the connection has ended.
  std::string Read(size_t count) {
    while (received_.size() < count && Receive()) {
    }
    return Take(std::min(count, received_.size()));
  }
  // Returns all until `end`, with it; all there is if the connection has ended.
  std::string ReadUntil(const std::string& end) {
    size_t at = 0;
    while ((at = received_.find(end)) == std::string::npos && Receive()) {
    }
    return Take(at == std::string::npos ? received_.size() : at + end.size());
  }

 private:
  bool Receive() {
    pollfd wanted = {socket_, POLLIN, 0};
    if (!is_good_ || poll(&wanted, 1, 120'000) <= 0) return false;
    char buffer[64 << 10];
    const ssize_t n = recv(socket_, buffer, sizeof buffer, 0);
    if (n > 0) received_.append(buffer, static_cast<size_t>(n));
    return n > 0;
  }
  std::string Take(size_t count) {
    std::string taken = received_.substr(0, count);
    received_.erase(0, count);
    return taken;
  }

  const int socket_;
  bool is_good_ = false;
  std::string received_;
};

// Sends a request of HTTP and returns the whole answer.
inline std::string Http(int port, const std::string& path, const std::string& host = "",
                        const std::string& method = "GET") {
  TcpClient client(port);
  client.Write(method + " " + path +
               " HTTP/1.1\r\nHost: " + (host.empty() ? "127.0.0.1:" + std::to_string(port) : host) +
               "\r\nConnection: close\r\n\r\n");
  return client.Read(SIZE_MAX);
}

// Headers with which a WebSocket begins.
struct Handshake {
  std::string protocol;  // subprotocol
  std::string query = "";
  std::string origin = "";  // "": that of the server; "-": none
  std::string host = "";    // "": that of the server
  std::string path = "/ws";
};

class WebSocketClient {
 public:
  using Json = nlohmann::ordered_json;

  WebSocketClient(int port, const Handshake& handshake) : client_(port) {
    const std::string own = "127.0.0.1:" + std::to_string(port);
    const std::string origin = handshake.origin.empty() ? "http://" + own : handshake.origin;
    client_.Write("GET " + handshake.path + handshake.query +
                  " HTTP/1.1\r\nHost: " + (handshake.host.empty() ? own : handshake.host) +
                  "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                  "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n" +
                  (origin == "-" ? "" : "Origin: " + origin + "\r\n") +
                  (handshake.protocol.empty()
                       ? ""
                       : "Sec-WebSocket-Protocol: " + handshake.protocol + "\r\n") +
                  "\r\n");
    answer_ = client_.ReadUntil("\r\n\r\n");
  }

  // The server's answer to the handshake, up to the empty line.
  const std::string& answer() const { return answer_; }
  bool is_open() const { return answer_.find(" 101 ") != std::string::npos; }

  static constexpr int kText = 1, kBinary = 2, kClose = 8;

  static constexpr int kContinuation = 0;

  // Sends a message, or a part of one that `is_last` does not end.
  void Send(const std::string& payload, int opcode = kText, bool is_last = true) {
    std::string frame = {static_cast<char>((is_last ? 0x80 : 0) | opcode)};
    const size_t size = payload.size();
    const int bytes = size < 126 ? 0 : size < 65536 ? 2 : 8;
    frame += static_cast<char>(0x80 | (bytes == 0 ? size : bytes == 2 ? 126 : 127));
    for (int i = bytes - 1; i >= 0; --i) frame += static_cast<char>(size >> (8 * i) & 255);
    // A mask of zeros, which leaves the payload as it is.
    client_.Write(frame + std::string(4, '\0') + payload);
  }

  // Returns the next text; "close CODE" for a frame that closes, "(lost)" without one.
  std::string Receive() {
    const std::string head = client_.Read(2);
    if (head.size() < 2) return "(lost)";
    const int opcode = head[0] & 15;
    size_t size = head[1] & 127;
    if (size >= 126) {
      const std::string more = client_.Read(size == 126 ? 2 : 8);
      size = 0;
      for (const char c : more) size = size << 8 | static_cast<unsigned char>(c);
    }
    const std::string payload = client_.Read(size);
    if (opcode != kClose) return payload;
    if (payload.size() < 2) return "close";
    close_reason_ = payload.substr(2);
    const int code =
        static_cast<unsigned char>(payload[0]) << 8 | static_cast<unsigned char>(payload[1]);
    return "close " + std::to_string(code);
  }

  // The reason in the frame that has closed; "" before Receive() has returned it.
  const std::string& close_reason() const { return close_reason_; }

  Json Ask(const Json& request) {
    Send(request.dump());
    return Json::parse(Receive(), nullptr, false);
  }

 private:
  TcpClient client_;
  std::string answer_, close_reason_;
};

}  // namespace openr_host

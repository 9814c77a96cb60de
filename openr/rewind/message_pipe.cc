#include "openr/rewind/message_pipe.h"

#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <system_error>
#include <vector>

namespace openr_host {
namespace {

bool ReceiveBytes(int socket, void* bytes, size_t size) {
  auto* at = static_cast<char*>(bytes);
  while (size > 0) {
    const ssize_t count = recv(socket, at, size, 0);
    if (count == 0 || (count < 0 && errno != EINTR)) return false;
    if (count < 0) continue;
    at += count;
    size -= static_cast<size_t>(count);
  }
  return true;
}

}  // namespace

SocketPair::SocketPair() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    throw std::system_error(errno, std::generic_category(), "socketpair");
  first = ends[0];
  second = ends[1];
}

bool SendMessage(int socket, const nlohmann::json& message) {
  std::vector<uint8_t> bytes(sizeof(uint64_t));
  nlohmann::json::to_cbor(message, bytes);
  const uint64_t size = bytes.size() - sizeof size;
  std::memcpy(bytes.data(), &size, sizeof size);
  for (size_t sent = 0; sent < bytes.size();) {
    const ssize_t count = send(socket, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR) return false;
    if (count > 0) sent += static_cast<size_t>(count);
  }
  return true;
}

std::optional<nlohmann::json> ReceiveMessage(int socket, int timeout_ms) {
  pollfd waited = {socket, POLLIN, 0};
  int ready;
  do {
    ready = poll(&waited, 1, timeout_ms);
  } while (ready < 0 && errno == EINTR);
  uint64_t size = 0;
  if (ready <= 0 || !ReceiveBytes(socket, &size, sizeof size)) return {};
  std::vector<uint8_t> bytes(size);
  if (!ReceiveBytes(socket, bytes.data(), size)) return {};
  return nlohmann::json::from_cbor(bytes);
}

}  // namespace openr_host

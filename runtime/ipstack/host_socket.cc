#include "runtime/ipstack/host_socket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

namespace openr_host {
namespace {

sockaddr_in ToSockaddr(NetAddress address) {
  sockaddr_in result{};
  result.sin_family = AF_INET;
  result.sin_addr.s_addr = htonl(address.ip);
  result.sin_port = htons(address.port);
  return result;
}

NetAddress FromSockaddr(const sockaddr_in& address) {
  return {ntohl(address.sin_addr.s_addr), ntohs(address.sin_port)};
}

const sockaddr* Generic(const sockaddr_in* address) {
  return reinterpret_cast<const sockaddr*>(address);
}

void SetOption(int fd, int level, int option) {
  const int on = 1;
  // Ignores an error of setsockopt(), because the socket also works without the option that is set
  // here.
  setsockopt(fd, level, option, &on, sizeof on);
}

}  // namespace

void Fd::Reset() {
  if (fd_ >= 0) close(fd_);
  fd_ = -1;
}

NetError NetErrorOf(int error) {
  switch (error) {
    case 0:
      return NetError::kNone;
    case EPIPE:
      return NetError::kClosed;
    case ECONNRESET:
    case ECONNABORTED:
      return NetError::kReset;
    case ETIMEDOUT:
      return NetError::kTimeout;
    case EADDRINUSE:
      return NetError::kAddressInUse;
    case EADDRNOTAVAIL:
    case EINVAL:
      return NetError::kBadAddress;
    case ECONNREFUSED:
      return NetError::kRefused;
    case EHOSTUNREACH:
    case EHOSTDOWN:
      return NetError::kHostUnreachable;
    case ENETUNREACH:
    case ENETDOWN:
      return NetError::kNetworkUnreachable;
    case EMSGSIZE:
      return NetError::kTooLong;
    default:
      return NetError::kFailed;
  }
}

Fd OpenSocket(NetProtocol protocol) {
  const int type = protocol == NetProtocol::kTcp ? SOCK_STREAM : SOCK_DGRAM;
  Fd fd(socket(AF_INET, type | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  // Switches Nagle's algorithm off, because a remote control sends small packets, which must not
  // wait for each other.
  if (fd.valid() && protocol == NetProtocol::kTcp) SetOption(fd.get(), IPPROTO_TCP, TCP_NODELAY);
  return fd;
}

int BindSocket(const Fd& fd, NetAddress local) {
  const sockaddr_in address = ToSockaddr(local);
  return bind(fd.get(), Generic(&address), sizeof address) == 0 ? 0 : errno;
}

int ListenOn(const Fd& fd, NetAddress local, int backlog) {
  // Sets SO_REUSEADDR, so that the port can be bound even while connections of an earlier run are
  // in state TIME_WAIT.
  SetOption(fd.get(), SOL_SOCKET, SO_REUSEADDR);
  if (const int error = BindSocket(fd, local)) return error;
  return listen(fd.get(), backlog) == 0 ? 0 : errno;
}

int ConnectTo(const Fd& fd, NetAddress remote) {
  const sockaddr_in address = ToSockaddr(remote);
  return connect(fd.get(), Generic(&address), sizeof address) == 0 ? 0 : errno;
}

int ConnectResult(const Fd& fd) {
  pollfd waiting{fd.get(), POLLOUT, 0};
  if (poll(&waiting, 1, 0) == 0) return EINPROGRESS;
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(fd.get(), SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

Fd AcceptFrom(const Fd& listener, NetAddress* remote) {
  // Calls poll() before accept(), because usually no connection waits.  Then accept() costs more
  // than poll(), because accept() creates a socket before it finds that no connection waits.
  pollfd waiting{listener.get(), POLLIN, 0};
  if (poll(&waiting, 1, 0) == 0) {
    errno = EAGAIN;
    return Fd();
  }
  sockaddr_in address{};
  socklen_t size = sizeof address;
  Fd fd(accept4(listener.get(), reinterpret_cast<sockaddr*>(&address), &size,
                SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (fd.valid()) SetOption(fd.get(), IPPROTO_TCP, TCP_NODELAY);
  *remote = FromSockaddr(address);
  return fd;
}

int64_t SendBytes(const Fd& fd, const void* data, size_t size) {
  return send(fd.get(), data, size, MSG_NOSIGNAL);
}

int64_t SendDatagram(const Fd& fd, NetAddress remote, const void* data, size_t size) {
  const sockaddr_in address = ToSockaddr(remote);
  return sendto(fd.get(), data, size, MSG_NOSIGNAL, Generic(&address), sizeof address);
}

int64_t ReceiveBytes(const Fd& fd, size_t size_max, std::string* bytes, NetAddress* remote) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  bytes->resize(size_max);
  const int64_t count =
      recvfrom(fd.get(), bytes->data(), size_max, 0, reinterpret_cast<sockaddr*>(&address), &size);
  const int error = errno;
  bytes->resize(count < 0 ? 0 : static_cast<size_t>(count));
  if (remote != nullptr) *remote = FromSockaddr(address);
  errno = error;
  return count;
}

void EndStream(const Fd& fd) { shutdown(fd.get(), SHUT_WR); }

void ResetOnClose(const Fd& fd) {
  const linger at_once{1, 0};
  setsockopt(fd.get(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
}

uint16_t PortOf(const Fd& fd) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  if (getsockname(fd.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  return ntohs(address.sin_port);
}

}  // namespace openr_host

#include "openr/remote/tcp_stream.h"

#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace openr::remote {
namespace {

[[noreturn]] void ThrowUnreachable(const Address& address, int error,
                                   std::chrono::milliseconds timeout) {
  if (error == ECONNREFUSED) {
    throw Error(ErrorCode::kUnreachable, address.Text() + ": no program listens there",
                "is 'openr run' running, and is this the port it printed? If it has ended, its "
                "last line says why");
  }
  if (error == ETIMEDOUT) {
    throw Error(ErrorCode::kUnreachable,
                fmt::format("{}: no connection within {} ms", address.Text(), timeout.count()),
                "the address is not that of the robot, or too many clients wait for it");
  }
  throw Error(ErrorCode::kUnreachable,
              fmt::format("{}: cannot be reached: {}", address.Text(), std::strerror(error)),
              "are host and port those of the robot?");
}

}  // namespace

TcpStream::TcpStream(const Address& address, std::chrono::milliseconds timeout) {
  const Clock::time_point deadline = Clock::now() + timeout;
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const int problem =
      getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &hints, &found);
  if (problem != 0) {
    throw Error(ErrorCode::kAddress,
                fmt::format("{}: no address of '{}' is known ({})", address.Text(), address.host,
                            gai_strerror(problem)),
                "this machine is 127.0.0.1");
  }
  // Makes a non-blocking socket, because connect() must give up at the deadline.
  socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  int error = socket_ < 0 || connect(socket_, found->ai_addr, found->ai_addrlen) != 0 ? errno : 0;
  freeaddrinfo(found);
  if (error == EINPROGRESS) error = WaitForConnection(deadline);
  if (error != 0) {
    if (socket_ >= 0) close(socket_);
    ThrowUnreachable(address, error, timeout);
  }
  // Switches Nagle's algorithm off, because requests are small and must leave at once.
  const int on = 1;
  setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

TcpStream::~TcpStream() { close(socket_); }

bool TcpStream::WaitFor(short events, Clock::time_point deadline) const {
  for (;;) {
    // Rounds the remaining time up to whole milliseconds.  If 0.5 ms became 0 ms, poll() would not
    // wait, and this loop would call poll() again and again until the deadline.
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
    const auto left_ms = std::clamp<int64_t>(left.count(), 0, 1'000'000'000);
    pollfd wanted{socket_, events, 0};
    const int ready = poll(&wanted, 1, static_cast<int>(left_ms));
    if (ready > 0) return true;
    if (ready == 0 && left_ms < 1'000'000'000) return false;
    // Returns true after an error of poll(), as if the socket were ready.  If the socket has an
    // error, the next call of the caller on this socket reports the error.
    if (ready < 0 && errno != EINTR) return true;
  }
}

int TcpStream::WaitForConnection(Clock::time_point deadline) const {
  if (!WaitFor(POLLOUT, deadline)) return ETIMEDOUT;
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(socket_, SOL_SOCKET, SO_ERROR, &error, &size);
  return error;
}

TcpStream::Result TcpStream::Lost(int error) {
  why_lost_ = error == 0 ? "the robot closed it" : std::strerror(error);
  return Result::kLost;
}

TcpStream::Result TcpStream::Send(const uint8_t* bytes, size_t size, Clock::time_point deadline) {
  for (size_t sent = 0; sent < size;) {
    const ssize_t n = send(socket_, bytes + sent, size - sent, MSG_NOSIGNAL);
    if (n > 0) {
      sent += static_cast<size_t>(n);
    } else if (errno == EAGAIN) {
      if (!WaitFor(POLLOUT, deadline)) return Result::kTimeout;
    } else if (errno != EINTR) {
      return Lost(errno);
    }
  }
  return Result::kGood;
}

TcpStream::Result TcpStream::Receive(uint8_t* bytes, size_t capacity, Clock::time_point deadline,
                                     size_t* count) {
  for (;;) {
    const ssize_t n = recv(socket_, bytes, capacity, 0);
    if (n > 0) {
      *count = static_cast<size_t>(n);
      return Result::kGood;
    }
    if (n == 0) return Lost(0);
    if (errno == EAGAIN) {
      if (!WaitFor(POLLIN, deadline)) return Result::kTimeout;
    } else if (errno != EINTR) {
      return Lost(errno);
    }
  }
}

}  // namespace openr::remote

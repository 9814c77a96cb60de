// Functions for the host's IPv4 sockets.  All sockets are non-blocking and closed on exec.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "runtime/ipstack/network.h"

namespace openr_host {

// The owner of a file descriptor; the descriptor is -1 if the Fd owns none.
class Fd {
 public:
  Fd() = default;
  explicit Fd(int fd) : fd_(fd) {}
  ~Fd() { Reset(); }
  Fd(Fd&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Fd& operator=(Fd&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }

  int get() const { return fd_; }
  bool valid() const { return fd_ >= 0; }
  void Reset();

 private:
  int fd_ = -1;
};

// Converts an errno to an error of the stack.
NetError NetErrorOf(int error);

// Opens a socket.  On failure returns an invalid Fd and sets errno.
Fd OpenSocket(NetProtocol protocol);

// BindSocket() binds a socket, ListenOn() listens on a socket, ConnectTo() connects a socket.  Each
// of them returns 0 or an errno.
int BindSocket(const Fd& fd, NetAddress local);
int ListenOn(const Fd& fd, NetAddress local, int backlog);  // also binds the socket to `local`
// Returns EINPROGRESS if the connection takes time; then ConnectResult() returns the result.
int ConnectTo(const Fd& fd, NetAddress remote);

// Asks whether `fd` is connected after ConnectTo(): returns EINPROGRESS while the connection is
// being established, then 0 or an errno.
int ConnectResult(const Fd& fd);

// Accepts the next connection to `listener`.  If no connection waits, or on an error, returns an
// invalid Fd and sets errno.
Fd AcceptFrom(const Fd& listener, NetAddress* remote);

// SendBytes() sends bytes to the connected peer, SendDatagram() sends them as a datagram to
// `remote`. Both return the number of bytes sent, or -1 with errno set.
int64_t SendBytes(const Fd& fd, const void* data, size_t size);
int64_t SendDatagram(const Fd& fd, NetAddress remote, const void* data, size_t size);
// Receives at most `size_max` bytes into `bytes`, which gets the size of the bytes that have
// arrived.  Stores the sender's address in `*remote` unless `remote` is null.  Returns their
// number, or -1 with errno set.
int64_t ReceiveBytes(const Fd& fd, size_t size_max, std::string* bytes,
                     NetAddress* remote = nullptr);

void EndStream(const Fd& fd);     // the peer reads an end of the stream
void ResetOnClose(const Fd& fd);  // the peer sees a broken connection when the socket is closed
uint16_t PortOf(const Fd& fd);    // the local port; 0: not bound

}  // namespace openr_host

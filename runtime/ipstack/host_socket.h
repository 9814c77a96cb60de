// Functions for the host's IPv4 sockets.  All sockets are non-blocking and closed on exec.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "runtime/ipstack/network.h"

namespace openr_host {

// The owner of a file descriptor; the descriptor is -1 if the Fd owns no descriptor.
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

// Converts an errno of the host to the error that a Network reports to the network stack.
NetError NetErrorOf(int error);

// Opens a socket.  On failure returns an invalid Fd and sets errno.
Fd OpenSocket(NetProtocol protocol);

// Binds a socket to `local`.  Returns 0 or an errno.
int BindSocket(const Fd& fd, NetAddress local);
// Binds a socket to `local` and listens on it.  Returns 0 or an errno.
int ListenOn(const Fd& fd, NetAddress local, int backlog);
// Connects a socket to `remote`.  Returns 0 or an errno.  The errno EINPROGRESS means that the
// connection takes time; then ConnectResult() returns the result.
int ConnectTo(const Fd& fd, NetAddress remote);

// Returns the result of ConnectTo() for the socket `fd`: EINPROGRESS while the connection is being
// established, then 0 or an errno.
int ConnectResult(const Fd& fd);

// Accepts the next connection to `listener`.  If no connection waits, or on an error, returns an
// invalid Fd and sets errno.
Fd AcceptFrom(const Fd& listener, NetAddress* remote);

// Sends bytes to the connected peer.  Returns the number of bytes sent, or -1 with errno set.
int64_t SendBytes(const Fd& fd, const void* data, size_t size);
// Sends bytes as a datagram to `remote`.  Returns the number of bytes sent, or -1 with errno set.
int64_t SendDatagram(const Fd& fd, NetAddress remote, const void* data, size_t size);
// Receives at most `size_max` bytes into `bytes`, whose size becomes the number of received bytes.
// Stores the sender's address in `*remote` unless `remote` is null.  Returns the number of received
// bytes, or -1 with errno set.
int64_t ReceiveBytes(const Fd& fd, size_t size_max, std::string* bytes,
                     NetAddress* remote = nullptr);

void EndStream(const Fd& fd);     // tells the peer that no more bytes follow
void ResetOnClose(const Fd& fd);  // lets the peer see a broken connection when the socket is closed
uint16_t PortOf(const Fd& fd);    // returns the local port; 0 if the socket is not bound

}  // namespace openr_host

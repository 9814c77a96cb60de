// Thin wrappers of the host's IPv4 sockets: never blocking, closed on exec.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include "runtime/ipstack/network.h"

namespace openr_host {

// Owns a file descriptor; -1 is none.
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

// What `error` (an errno) means to the stack.
NetError NetErrorOf(int error);

// Invalid, with errno set, when there is none to be had.
Fd OpenSocket(NetProtocol protocol);

// All return 0 or an errno.
int BindSocket(const Fd& fd, NetAddress local);
int ListenOn(const Fd& fd, NetAddress local, int backlog);  // binds as well
int ConnectTo(const Fd& fd, NetAddress remote);             // EINPROGRESS: see ConnectResult()

// EINPROGRESS while it is not decided.
int ConnectResult(const Fd& fd);

// The next connection; invalid, with errno set, when there is none.
Fd AcceptFrom(const Fd& listener, NetAddress* remote);

// Bytes, or -1 with errno set.
int64_t SendBytes(const Fd& fd, const void* data, size_t size);
int64_t SendDatagram(const Fd& fd, NetAddress remote, const void* data, size_t size);
// At most `size_max` bytes into `bytes`, which gets the size of what came.
int64_t ReceiveBytes(const Fd& fd, size_t size_max, std::string* bytes,
                     NetAddress* remote = nullptr);

void EndStream(const Fd& fd);     // the peer reads to an end
void ResetOnClose(const Fd& fd);  // the peer sees it broken when it is closed
uint16_t PortOf(const Fd& fd);    // local one; 0 when not bound

}  // namespace openr_host

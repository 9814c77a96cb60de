// TcpStream, which sends and receives the bytes of a Connection.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "openr/remote/address.h"
#include "openr/remote/error.h"

namespace openr::remote {

using Clock = std::chrono::steady_clock;

// A TCP connection.  Its functions wait at most until a deadline.
class TcpStream {
 public:
  // Connects to `address` within `timeout`.  Throws Error (kAddress, kUnreachable).
  TcpStream(const Address& address, std::chrono::milliseconds timeout);
  ~TcpStream();
  TcpStream(const TcpStream&) = delete;
  TcpStream& operator=(const TcpStream&) = delete;

  enum class Result { kGood, kTimeout, kLost };

  // Sends all of `bytes`.  Returns kTimeout if not all of them were sent by `deadline`, and kLost
  // if the connection was lost.
  Result Send(const uint8_t* bytes, size_t size, Clock::time_point deadline);

  // Waits for bytes and reads up to `capacity` of them.  Sets `*count` to the number of bytes read.
  // With a deadline in the past, reads only the bytes that have arrived already.
  Result Receive(uint8_t* bytes, size_t capacity, Clock::time_point deadline, size_t* count);

  // Returns the reason why the connection was lost.  Called after a function has returned kLost.
  const std::string& why_lost() const { return why_lost_; }
  int descriptor() const { return socket_; }

 private:
  bool WaitFor(short events, Clock::time_point deadline) const;
  // Waits until the connection is made; returns 0, or an errno after an error.
  int WaitForConnection(Clock::time_point deadline) const;
  // Stores the reason why the connection was lost, for why_lost(), and returns kLost.  `error` is
  // an errno; 0: the other end has closed the connection.
  Result Lost(int error);

  int socket_ = -1;
  std::string why_lost_;
};

}  // namespace openr::remote

// Error, the only exception that openr::remote, the client library, throws.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

namespace openr::remote {

enum class ErrorCode {
  kAddress,  // the text is no address, or the IP address of the named host cannot be found
  // No connection was made: no program listens at the address, or no program answers in time.
  kUnreachable,
  kTimeout,      // a connection exists, but the robot does not answer or accept bytes in time
  kLost,         // the connection to the robot has ended
  kProtocol,     // the bytes that arrived do not follow the protocol of the remote control
  kRefused,      // the robot refuses the request; status() and text() say why
  kNoDevice,     // the robot has no device with this name
  kFileChanged,  // the file on the stick changed while it was downloaded
};

// Thrown by all functions of the client library openr::remote that can fail.  what() returns
// text(), followed by "; " and advice() if advice() is not "".
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& text, const std::string& advice = "");
  // Makes an error of the kind kRefused.  `status` is an RcStatus, `frame` the frame number in the
  // answer, `text` the robot's own words.
  Error(int status, uint32_t frame, const std::string& text);

  ErrorCode code() const { return code_; }
  const std::string& text() const { return text_; }  // description of the error
  // Returns what the user can do to avoid the error; "" if text() says it already.
  const std::string& advice() const { return advice_; }
  // Returns the RcStatus (RemoteProtocol.h) of a refusal; 0 (rcOK) if the robot has not refused.
  int status() const { return status_; }
  // Returns the frame number in the answer by which the robot refused.
  uint32_t frame() const { return frame_; }

  // Returns whether the connection can still be used after this error.  If it cannot, the caller
  // must make a new connection.
  bool IsConnectionUsable() const;

 private:
  const ErrorCode code_;
  const std::string text_, advice_;
  const int status_ = 0;
  const uint32_t frame_ = 0xffffffff;
};

}  // namespace openr::remote

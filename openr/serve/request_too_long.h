// RequestTooLong, the exception that RequestPipe throws if a request has too many bytes.
#pragma once

#include <stdexcept>

namespace openr_host {

// Thrown when a request is too long to be received.  The pipe cannot be used any more, because the
// bytes of the request are still in it.
class RequestTooLong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace openr_host

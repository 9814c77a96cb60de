// RequestTooLong, an exception of RequestPipe.
#pragma once

#include <stdexcept>

namespace openr_host {

// A request that is too long to be received, so that the bytes behind it cannot be understood.
class RequestTooLong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace openr_host

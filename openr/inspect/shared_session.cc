#include "openr/inspect/shared_session.h"

#include <cerrno>
#include <cstdio>
#include <utility>

namespace openr_host {

void SharedSession::NoteLostText(int error) {
  if (!std::exchange(is_text_lost, true)) lost_errno = error;
}

bool SharedSession::FlushText() {
  errno = 0;
  const bool is_flushed = std::fflush(stdout) == 0;
  const int error = errno;  // errno is read before ferror(), which may change it
  if (!is_flushed || std::ferror(stdout) != 0) NoteLostText(error);
  std::fflush(nullptr);
  return !is_text_lost;
}

}  // namespace openr_host

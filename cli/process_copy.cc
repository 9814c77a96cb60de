#include "cli/process_copy.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace openr_host {

ProcessCopy StartCopy(const std::function<void(int answers)>& work) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    throw std::runtime_error(
        fmt::format("no pipe to a copy of this process: {}", std::strerror(errno)));
  }
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) {
    const int error = errno;
    close(ends[0]);
    close(ends[1]);
    throw std::runtime_error(fmt::format("cannot fork: {}", std::strerror(error)));
  }
  if (child == 0) {
    close(ends[0]);
    work(ends[1]);
    std::fflush(nullptr);
    _exit(0);  // not exit(), because only the original process must run exit handlers
  }
  close(ends[1]);
  return {child, ends[0]};
}

std::string ReadToEnd(int descriptor, std::FILE* echo, const std::function<void()>& while_waiting) {
  constexpr int kPauseMs = 200;  // time between two calls of `while_waiting`
  std::string text;
  char buffer[8192];
  for (;;) {
    if (while_waiting) {
      while_waiting();
      pollfd wanted = {descriptor, POLLIN, 0};
      if (poll(&wanted, 1, kPauseMs) <= 0) continue;
    }
    const ssize_t count = read(descriptor, buffer, sizeof buffer);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return text;
    text.append(buffer, static_cast<size_t>(count));
    if (echo != nullptr) std::fwrite(buffer, 1, static_cast<size_t>(count), echo);
  }
}

int WaitForEnd(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace openr_host

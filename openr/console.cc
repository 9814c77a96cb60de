#include "openr/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace openr_host {

void WriteAll(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    text.remove_prefix(static_cast<size_t>(written));
  }
}

Console::Console(const std::string& file) {
  int target = STDERR_FILENO;
  if (!file.empty()) {
    target = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (target < 0) throw std::runtime_error(file + ": cannot be written: " + std::strerror(errno));
  }
  std::fflush(stdout);
  saved_ = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
  dup2(target, STDOUT_FILENO);
  if (!file.empty()) close(target);
  // Lines of objects and of the system come in the order they were written.
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
}

Console::~Console() {
  std::fflush(stdout);
  if (saved_ < 0) return;
  dup2(saved_, STDOUT_FILENO);
  close(saved_);
}

void Console::Print(std::string_view text) {
  std::fflush(stdout);
  WriteAll(STDOUT_FILENO, text);
}

void Console::Answer(std::string_view text) { WriteAll(saved_, text); }

}  // namespace openr_host

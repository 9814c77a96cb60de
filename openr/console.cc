#include "openr/console.h"

#include <fcntl.h>
#include <stdio_ext.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace openr_host {
namespace {

// Whether what was printed last through the system had no end of line.
bool g_is_open_line = false;

}  // namespace

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
  EndConsoleLine();
  if (saved_ < 0) return;
  dup2(saved_, STDOUT_FILENO);
  close(saved_);
}

void Console::Print(std::string_view text) {
  std::fflush(stdout);
  WriteAll(STDOUT_FILENO, text);
  if (!text.empty()) g_is_open_line = text.back() != '\n';
}

void Console::Answer(std::string_view text) { WriteAll(saved_, text); }

// What objects print without the system waits in the C library's buffer until its line ends.
void EndConsoleLine() {
  const char* const end = stdout->_IO_write_ptr;
  if (__fpending(stdout) > 0) g_is_open_line = end[-1] != '\n';
  std::fflush(stdout);
  if (std::exchange(g_is_open_line, false)) WriteAll(STDOUT_FILENO, "\n");
}

}  // namespace openr_host

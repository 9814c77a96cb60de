#include "cli/console.h"

#include <fcntl.h>
#include <stdio_ext.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <utility>

#include "cli/growing_file.h"
#include "cli/output_file.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"

namespace openr_host {
namespace {

// True if the last text on the console did not end with a newline, so that EndConsoleLine() must
// print the newline.
bool g_is_open_line = false;

// The errno of the first failed write to the console; 0 if no write has failed.
int g_error = 0;

// Makes the console lead to /dev/null after a failed write.  So later writes succeed: an error of
// this computer, such as a full disk, must not change what objects do.
void RedirectConsoleToNull(int error) {
  if (std::exchange(g_error, error) != 0) return;
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  close(nowhere);
  std::clearerr(stdout);
  std::fflush(stdout);
}

void WriteConsole(std::string_view text) {
  ClearProgressLine();
  const int error = WriteAll(STDOUT_FILENO, text);
  if (error != 0) RedirectConsoleToNull(error);
}

// Writes out the buffer of the C library, in which the text of objects waits until its line ends.
void FlushConsole() {
  if (__fpending(stdout) > 0) ClearProgressLine();
  errno = 0;
  const bool is_flushed = std::fflush(stdout) == 0;
  const int error = errno != 0 ? errno : EIO;  // errno is read before ferror(), which may change it
  if (!is_flushed || std::ferror(stdout) != 0) RedirectConsoleToNull(error);
}

}  // namespace

Console::Console(const std::string& file) : file_(file) {
  std::string problem;
  const int target = file.empty() ? STDERR_FILENO : OpenGrowingFile(file, &problem);
  if (target < 0) throw std::runtime_error(problem);
  g_error = 0;
  std::fflush(stdout);
  saved_ = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  SetStandardOutput(saved_);
  dup2(target, STDOUT_FILENO);
  if (!file.empty()) close(target);
  // Uses line buffering, so that a line that an object prints with printf() is shown at once, and
  // before any line that the program prints later.
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
}

Console::~Console() {
  EndConsoleLine();
  if (saved_ < 0) return;
  dup2(saved_, STDOUT_FILENO);
  SetStandardOutput(STDOUT_FILENO);
  close(saved_);
}

void Console::Print(std::string_view text) {
  FlushConsole();
  WriteConsole(text);
  if (!text.empty()) g_is_open_line = text.back() != '\n';
}

std::string Console::Problem() const {
  return file_.empty() || g_error == 0 ? "" : WriteErrorText(file_, g_error);
}

void EndConsoleLine() {
  const char* const end = stdout->_IO_write_ptr;
  if (__fpending(stdout) > 0) g_is_open_line = end[-1] != '\n';
  FlushConsole();
  if (std::exchange(g_is_open_line, false)) WriteConsole("\n");
}

}  // namespace openr_host

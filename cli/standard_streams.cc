#include "cli/standard_streams.h"

#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <unistd.h>

#include <cerrno>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

#include "cli/exit_code.h"
#include "cli/output_file.h"
#include "cli/progress_line.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

int g_standard_output = STDOUT_FILENO;
int g_output_error = 0;  // errno of the first failed write to standard output
bool g_has_failed = false;
bool g_is_told = false;  // true: the failed write has been reported to the user

// Opens /dev/null for each closed descriptor from 0 to 2. open() returns the lowest closed
// descriptor, so it returns the descriptor that the loop has reached.
void OpenClosedDescriptors() {
  // The mode in which /dev/null is opened for each of the descriptors 0 to 2.  Descriptor 1 is
  // opened for reading only, so that writing to it fails.
  constexpr int kModes[] = {O_RDONLY, O_RDONLY, O_WRONLY};
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    if (open("/dev/null", kModes[descriptor]) != descriptor)
      _exit(1);  // an error cannot be printed without streams
  }
}

// Replaces stderr by a stream whose writes always succeed.  fmt::print() throws when a stream
// fails, and a run must not end because nobody reads its messages.
void KeepErrorStreamGood() {
  cookie_io_functions_t functions = {};
  functions.write = [](void*, const char* text, size_t size) {
    ClearProgressLine();
    WriteAll(STDERR_FILENO, {text, size});
    return static_cast<ssize_t>(size);
  };
  FILE* const stream = fopencookie(nullptr, "w", functions);
  if (stream == nullptr) return;
  setvbuf(stream, nullptr, _IONBF, 0);
  stderr = stream;
}

[[noreturn]] void Fail(int error) {
  NoteLostAnswer(error);
  if (error == EPIPE) throw ReaderGone(OutputErrorText(error));
  g_is_told = true;
  throw std::runtime_error(OutputErrorText(error));
}

// Writes out the text in the buffers of std::cout and stdout.  If that fails, returns false and
// keeps the error for FinishStandardOutput().
bool FlushStreams() {
  errno = 0;
  std::cout.flush();  // sets errno if it fails
  const bool is_flushed = std::fflush(stdout) == 0;
  const int error = errno;  // errno is read before ferror(), which may change it
  const bool is_written = is_flushed && std::ferror(stdout) == 0;
  if (!is_written) NoteLostAnswer(error);
  return is_written;
}

}  // namespace

void PrepareStandardStreams() {
  OpenClosedDescriptors();
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);  // this signal is sent when a file gets longer than ulimit -f allows
  KeepErrorStreamGood();
}

int StandardOutput() { return g_standard_output; }

void SetStandardOutput(int descriptor) { g_standard_output = descriptor; }

std::string OutputErrorText(int error) {
  return error != 0 ? WriteErrorText("standard output", error)
                    : "standard output: cannot be written whole";
}

void NoteLostAnswer(int error) {
  if (!std::exchange(g_has_failed, true)) g_output_error = error;
}

void PrintAnswer(std::string_view text) {
  const std::string harmless = TerminalText(std::string(text));
  // Asks for the terminal only if the two texts differ, because a system call for each part of a
  // long answer would take time.
  const bool is_shown = harmless != text && isatty(g_standard_output) == 1;
  PrintAnswerWithCodes(is_shown ? std::string_view(harmless) : text);
}

void PrintAnswerWithCodes(std::string_view text) {
  // Does not write to stdout if a run has given descriptor 1, to which stdout writes, to the
  // robot's console.  The answer of the command then goes to g_standard_output, another descriptor
  // of the standard output with which the program was started.
  if (g_standard_output != STDOUT_FILENO) {
    const int error = WriteAll(g_standard_output, text);
    if (error != 0) Fail(error);
    return;
  }
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) Fail(errno);
}

void FlushAnswer() {
  if (g_standard_output == STDOUT_FILENO && !FlushStreams()) Fail(g_output_error);
}

int FinishStandardOutput(int exit_code, const char* program) {
  if (FlushStreams() && !g_has_failed) return exit_code;
  if (g_output_error == EPIPE) return kExitReaderGone;
  if (!g_is_told)
    std::fprintf(stderr, "%s: %s\n", program, OutputErrorText(g_output_error).c_str());
  return exit_code == kExitGood ? kExitWrong : exit_code;
}

}  // namespace openr_host

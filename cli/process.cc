#include "cli/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>

#include "cli/output_file.h"
#include "cli/process_copy.h"
#include "runtime/base/assert.h"
#include "runtime/base/program_start.h"

extern char** environ;

namespace openr_host {
namespace {

// Returns the environment for a child process: texts "NAME=value", sorted by name.
std::vector<std::string> ChildEnvironment(const ProcessOptions& options) {
  std::map<std::string, std::string> values;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    const std::string text = *entry;
    const size_t equals = text.find('=');
    if (equals != std::string::npos) values[text.substr(0, equals)] = text.substr(equals + 1);
  }
  for (const auto& [name, value] : options.environment) {
    if (value.empty()) {
      values.erase(name);
    } else {
      values[name] = value;
    }
  }
  std::vector<std::string> environment;
  for (const auto& [name, value] : values) environment.push_back(name + "=" + value);
  return environment;
}

// A pipe between this process and a child.  The destructor closes both ends.
class Pipe {
 public:
  Pipe() = default;
  ~Pipe() {
    CloseReader();
    CloseWriter();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  // Creates the pipe.  Returns false and sets errno when the process has no descriptors left.
  bool Open() { return pipe2(ends_, O_CLOEXEC) == 0; }
  int reader() const { return ends_[0]; }
  int writer() const { return ends_[1]; }
  void CloseReader() { Close(&ends_[0]); }
  void CloseWriter() { Close(&ends_[1]); }

 private:
  static void Close(int* end) {
    if (*end >= 0) close(*end);
    *end = -1;
  }

  int ends_[2] = {-1, -1};
};

// Starts the program `arguments` as a child process.  `in` and `out` become the standard streams of
// the child if `options` ask for it.  Returns an errno, or 0.
int Spawn(const std::vector<std::string>& arguments, const ProcessOptions& options, const Pipe& in,
          const Pipe& out, pid_t* child) {
  ProgramStart program(arguments);
  if (options.has_no_input) program.OpenNull(STDIN_FILENO, O_RDONLY);
  if (options.input) program.Give(in.reader(), STDIN_FILENO);
  if (options.captures_out) program.Give(out.writer(), STDOUT_FILENO);
  if (options.captures_error) program.Give(out.writer(), STDERR_FILENO);
  if (!options.folder.empty()) program.EnterFolder(options.folder);
  program.SetEnvironment(ChildEnvironment(options));
  return program.Start(child);
}

// Writes `text` to a child.  The child may end without reading it, so SIGPIPE is ignored during the
// write.
void WriteInput(int descriptor, const std::string& text) {
  const auto previous = signal(SIGPIPE, SIG_IGN);
  WriteAll(descriptor, text);
  signal(SIGPIPE, previous);
}

}  // namespace

ProcessResult RunProcess(const std::vector<std::string>& arguments, const ProcessOptions& options) {
  ASSERT(!arguments.empty());
  ASSERT(!options.input || !options.has_no_input);
  ProcessResult result;
  Pipe in, out;
  const bool captures = options.captures_error || options.captures_out;
  if ((captures && !out.Open()) || (options.input && !in.Open())) {
    result.start_error = std::strerror(errno);
    return result;
  }
  pid_t child = 0;
  const int error = Spawn(arguments, options, in, out, &child);
  if (error != 0) {
    result.status = 127;
    result.start_error = fmt::format("{}: {}", arguments[0], std::strerror(error));
    return result;
  }
  // Closes this process's copies of the two descriptors that the child uses.  Then, if the child
  // ends, WriteInput() fails and ReadToEnd() returns, because no process has these ends of the
  // pipes any more.
  in.CloseReader();
  out.CloseWriter();
  if (options.input) WriteInput(in.writer(), *options.input);
  in.CloseWriter();
  if (captures) {
    result.output =
        ReadToEnd(out.reader(), options.echoes ? stderr : nullptr, options.while_waiting);
  }
  const int status = WaitForEnd(child);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

bool HasProgram(const std::string& name) {
  if (name.find('/') != std::string::npos) return access(name.c_str(), X_OK) == 0;
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder + "/" + name).c_str(), X_OK) == 0) return true;
  }
  return false;
}

}  // namespace openr_host

#include "cli/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
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

std::vector<char*> Pointers(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

// Sets attributes that give a child process the default actions of SIGPIPE and SIGXFSZ.  This
// program ignores both signals, and the child would inherit that, but other programs expect that
// these signals end them.
void MakeAttributes(posix_spawnattr_t* attributes) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGPIPE);
  sigaddset(&signals, SIGXFSZ);
  posix_spawnattr_init(attributes);
  posix_spawnattr_setsigdefault(attributes, &signals);
  posix_spawnattr_setflags(attributes, POSIX_SPAWN_SETSIGDEF);
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

// Starts the program `arguments` as a child process.  `in` and `out` become its standard streams if
// `options` ask for it.  Returns an errno, or 0.
int Spawn(const std::vector<std::string>& arguments, const ProcessOptions& options, const Pipe& in,
          const Pipe& out, pid_t* child) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (options.has_no_input)
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  if (options.input) posix_spawn_file_actions_adddup2(&actions, in.reader(), STDIN_FILENO);
  if (options.captures_out) posix_spawn_file_actions_adddup2(&actions, out.writer(), STDOUT_FILENO);
  if (options.captures_error)
    posix_spawn_file_actions_adddup2(&actions, out.writer(), STDERR_FILENO);
  if (!options.folder.empty())
    posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
  const std::vector<std::string> environment = ChildEnvironment(options);
  posix_spawnattr_t attributes;
  MakeAttributes(&attributes);
  const int error = posix_spawnp(child, arguments[0].c_str(), &actions, &attributes,
                                 Pointers(arguments).data(), Pointers(environment).data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
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
    result.not_found = std::strerror(errno);
    return result;
  }
  pid_t child = 0;
  const int error = Spawn(arguments, options, in, out, &child);
  if (error != 0) {
    result.status = 127;
    result.not_found = fmt::format("{}: {}", arguments[0], std::strerror(error));
    return result;
  }
  // Closes this process's copies of the pipe ends that the child uses.  Then only the child holds
  // them, so reading from the pipe ends when the child ends.
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

#include "openr/panel/panel_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <vector>

#include "cli/install_paths.h"
#include "cli/process_copy.h"

namespace openr_host {
namespace {

// Number that the reading end of a pipe gets as a descriptor of the panel's server.  The server
// sees by this pipe when its run ends.
constexpr int kPipeInServer = 3;

// Makes this process the server of the panel, and does not return.  Calls only functions that are
// allowed after fork().
[[noreturn]] void BecomeServer(const char* program, int pipe, char* const* arguments) {
  // Gives the server a terminal session of its own (see setsid(2)), so that Ctrl-C and the end of
  // the run's terminal do not reach the server.
  setsid();
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int nowhere = open("/dev/null", O_RDWR);
  dup2(nowhere, STDIN_FILENO);
  dup2(nowhere, STDOUT_FILENO);
  // Clears the close-on-exec flag of the pipe, so that the server can read it.  If the pipe already
  // has the wanted descriptor, dup2() does nothing and so does not clear this flag.
  if (pipe == kPipeInServer) {
    fcntl(pipe, F_SETFD, 0);
  } else {
    dup2(pipe, kPipeInServer);
  }
  close_range(kPipeInServer + 1, ~0u, 0);
  execv(program, arguments);
  execv("/proc/self/exe", arguments);  // runs the program even if a new build has removed its file
  _exit(127);
}

// Returns the command line `openr panel ...` with which a run starts the server of the panel.
std::vector<std::string> WordsOf(const PanelOptions& options) {
  std::vector<std::string> words = {"openr",  "panel",
                                    "--run",  options.run,
                                    "--port", std::to_string(options.port),
                                    "--fd",   std::to_string(kPipeInServer)};
  const ListenOptions& listen = options.listen;
  if (!listen.is_on()) return words;
  words.insert(words.end(),
               {"--listen", listen.address, "--token-file", listen.token_file, "--listen-rc-port",
                std::to_string(listen.rc_port), "--robots", std::to_string(options.robots)});
  if (listen.allows_controllers) words.push_back("--allow-uploads");
  return words;
}

}  // namespace

PanelProcess::PanelProcess(const PanelOptions& options) {
  int ends[2];
  const auto warn = [] {
    fmt::print(stderr, "openr: no panel: it cannot be started: {}\n", std::strerror(errno));
  };
  if (pipe2(ends, O_CLOEXEC) != 0) {
    warn();
    return;
  }
  std::vector<std::string> words = WordsOf(options);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::string program = ProgramFile();
  const pid_t child = fork();
  if (child == 0) {
    // Forks again and ends, so that the server is not a child of the run.  So the run need not wait
    // for the end of the server, and no zombie is left.
    if (fork() == 0) {
      close(ends[1]);
      BecomeServer(program.c_str(), ends[0], arguments.data());
    }
    _exit(0);
  }
  close(ends[0]);
  if (child < 0) {
    warn();
    close(ends[1]);
    return;
  }
  WaitForEnd(child);
  pipe_ = ends[1];
}

PanelProcess::~PanelProcess() {
  if (pipe_ >= 0) close(pipe_);
}

bool HasPanel() {
  return !PanelFolder().empty() && std::filesystem::path(PanelLibrary()).is_absolute();
}

}  // namespace openr_host

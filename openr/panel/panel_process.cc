#include "openr/panel/panel_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <vector>

#include "cli/install_paths.h"
#include "cli/print_plain.h"
#include "cli/process_copy.h"
#include "runtime/base/program_start.h"

namespace openr_host {
namespace {

// The descriptor under which the panel's server has the reading end of a pipe.  By this pipe the
// server sees when its run ends.
constexpr int kPipeInServer = 3;

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
  const auto warn = [](const std::string& why) {
    PrintPlain(stderr, "openr: no panel: it cannot be started: {}\n", why);
  };
  if (pipe2(ends, O_CLOEXEC) != 0) {
    warn(std::strerror(errno));
    return;
  }
  ProgramStart server(WordsOf(options));
  // Gives the server a terminal session of its own, so that Ctrl-C and the end of the run's
  // terminal do not reach the server.
  server.LeaveSession();
  server.UnblockSignals();
  server.OpenNull(STDIN_FILENO, O_RDWR);
  server.Give(STDIN_FILENO, STDOUT_FILENO);
  server.Give(ends[0], kPipeInServer);
  server.CloseFrom(kPipeInServer + 1);
  const std::string program = ProgramFile();
  const std::string running = "/proc/self/exe";  // this program, even if a new build has removed it
  const std::string problem = StartThroughCopy([&] {
    pid_t process = 0;
    const int error = server.Start(program, &process);
    return error == 0 ? 0 : server.Start(running, &process);
  });
  close(ends[0]);
  if (!problem.empty()) {
    warn(problem);
    close(ends[1]);
    return;
  }
  pipe_ = ends[1];
}

PanelProcess::~PanelProcess() {
  if (pipe_ >= 0) close(pipe_);
}

bool HasPanel() {
  return !PanelFolder().empty() && std::filesystem::path(PanelLibrary()).is_absolute();
}

}  // namespace openr_host

// The command openr serve: executes a run for another program, which sends requests through a pipe.
// The Python module openr_host uses it.
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/serve/command_table.h"
#include "openr/serve/request_pipe.h"
#include "openr/serve/run_server.h"
#include "openr/simulation/sanitizer_start.h"

namespace openr_host {
namespace {

int RunServe() {
  // Ignores Ctrl-C, because the program that drives the run decides what Ctrl-C in its terminal
  // means.
  signal(SIGINT, SIG_IGN);
  const Console console("");  // keeps the text that objects print separate from the answers
  RequestPipe pipe(STDIN_FILENO, StandardOutput());
  auto server = std::make_unique<RunServer>(&pipe);
  const int exit_code = server->Serve();
  const bool is_copy = server->is_copy();
  server.reset();
  if (!is_copy) return exit_code;
  // Writes out all streams, because _exit() does not do so.
  std::fflush(nullptr);
  // Ends this process, which is a copy of another process (fork), without exit handlers.  If the
  // user has set LP_NUM_THREADS (main.cc), Mesa, a library that draws pictures, may have had
  // threads in the other process.  This copy does not have the threads, and the exit handler of
  // Mesa would wait for them.
  _exit(exit_code);
}

}  // namespace

void AddServeCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "serve",
      "Makes a run and does what commands on standard input say, for the Python module openr_host "
      "(docs/python.md)");
  auto describes = std::make_shared<bool>(false);
  command->add_flag("--describe", *describes, "Print the commands and their parameters as JSON");
  auto stick = std::make_shared<std::string>();
  command->add_option("--stick", *stick,
                      "The stick that \"start\" will name; needed if its objects were built with "
                      "--sanitize");
  command->callback([describes, stick, exit_code] {
    if (*describes) {
      PrintAnswer(JsonText(DescribeRunCommands(), 2) + "\n");
      return;
    }
    StartWithSanitizerOf(*stick);
    *exit_code = RunServe();
  });
}

}  // namespace openr_host

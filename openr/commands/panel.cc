// The command openr panel: serves the web page with which people watch and drive a run.
#include "openr/panel/panel.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "cli/exit_code.h"
#include "openr/commands/commands.h"
#include "openr/commands/listen_flags.h"

namespace openr_host {

void AddPanelCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "panel", "Serves the web panel for the runs of this computer, until Ctrl-C");
  auto options = std::make_shared<PanelOptions>();
  command
      ->add_option("--port", options->port,
                   "Port of 127.0.0.1, or of --listen, or the next free one; 0: any")
      ->capture_default_str();
  command->add_option("--run", options->run,
                      "Name or process id of the run that the page shows first; without it the "
                      "only run there is");
  AddListenFlags(command, &options->listen);
  command
      ->add_option("--robots", options->robots, "How many robots' remote controls --listen opens")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  // Adds the flag that openr run gives to the server that it starts (PanelProcess).  The flag is
  // hidden, because it is not for users.
  command->add_option("--fd", options->run_pipe, "Descriptor whose end of file ends the server")
      ->group("");
  command->callback([options, exit_code] {
    ServePanel(*options);
    *exit_code = kExitGood;
  });
}

}  // namespace openr_host

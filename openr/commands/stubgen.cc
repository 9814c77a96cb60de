#include "kit/stubgen.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"

namespace openr_host {

void AddStubgenCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("stubgen", "Writes def.h, entry.h and the stub of a stub.cfg");
  auto options = std::make_shared<StubgenOptions>();
  command->add_option("FILE", options->file,
                      "stub.cfg to read (default, and for '-': standard input)");
  command->add_option("-o,--output", options->folder, "Folder to write to")
      ->check(IsFolder())
      ->capture_default_str();
  command->callback(
      [options, exit_code] { *exit_code = RunStubgen(*options, std::cin, std::cout, std::cerr); });
}

}  // namespace openr_host

// openr: runs software for Sony's AIBO on a PC.  Start reading here.
//
// A command is a file of commands/: it describes its flags, and a function that does the work.
// `openr run` puts a Simulation together (simulation.h), a Runner runs it frame by frame
// (runner.h), and what happened becomes a report (report.h).
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <iostream>

#include "openr/commands/commands.h"
#include "openr/exit_code.h"

int main(int argc, char** argv) {
  using namespace openr_host;
  CLI::App app{"Runs OPEN-R objects of Sony's AIBO on a PC, with a simulated body."};
  app.name("openr");
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "Help of all commands");
  int exit_code = kExitGood;
  AddRunCommand(&app, &exit_code);
  AddRcCommand(&app, &exit_code);
  AddGraphCommand(&app, &exit_code);
  AddMtnCommand(&app, &exit_code);
  AddStubgenCommand(&app, &exit_code);
  AddVersionCommand(&app, &exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error, std::cout, std::cerr) == 0 ? kExitGood : kExitCommandLine;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "openr: %s\n", error.what());
    return kExitWrong;
  }
  return exit_code;
}

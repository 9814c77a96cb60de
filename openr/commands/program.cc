// Builds the command line of the program, and prints the error when a command fails.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <system_error>

#include "cli/exit_code.h"
#include "cli/output_file.h"
#include "cli/standard_streams.h"
#include "openr/commands/command_line.h"
#include "openr/commands/commands.h"

namespace openr_host {
namespace {

void AddCommands(CLI::App* app, int* exit_code) {
  app->name("openr");
  app->require_subcommand(1);
  app->set_help_all_flag("--help-all", "Help of all commands");
  AddRunCommand(app, exit_code);
  AddJoinCommand(app, exit_code);
  AddTopCommand(app, exit_code);
  AddPokeCommand(app, exit_code);
  AddAttachCommand(app, exit_code);
  AddPanelCommand(app, exit_code);
  AddRcCommand(app, exit_code);
  AddGraphCommand(app, exit_code);
  AddMtnCommand(app, exit_code);
  AddLogCommand(app, exit_code);
  AddTraceCommand(app, exit_code);
  AddReplayCommand(app, exit_code);
  AddExploreCommand(app, exit_code);
  AddBuildCommand(app, exit_code);
  AddNewCommand(app, exit_code);
  AddControllerCommand(app, exit_code);
  AddCheckCommand(app, exit_code);
  AddModelCommand(app, exit_code);
  AddStickCommand(app, exit_code);
  AddStubgenCommand(app, exit_code);
  AddHelpCommand(app, exit_code);
  AddVersionCommand(app, exit_code);
}

// Prints the error `why` on standard error.  With `as_json`, because the user gave --json, also
// prints it as a JSON object on standard output.
void TellFailure(const std::string& why, bool as_json) {
  std::fprintf(stderr, "openr: %s\n", why.c_str());
  if (!as_json) return;
  // replaces bytes that are not UTF-8
  const auto replace = nlohmann::json::error_handler_t::replace;
  std::printf("%s\n", nlohmann::json{{"error", why}}.dump(-1, ' ', false, replace).c_str());
}

// Prints the help or the version, which CLI11 reports as an `error` with exit code 0.
int PrintAskedFor(const CLI::App& app, const CLI::ParseError& error) {
  std::ostringstream text;
  const int exit_code = app.exit(error, text, text);
  try {
    PrintAnswer(text.str());
    return exit_code;
  } catch (const std::exception& failure) {
    TellFailure(failure.what(), false);
    return kExitWrong;
  }
}

}  // namespace

int RunProgram(int argc, char** argv) {
  CLI::App app{"Runs OPEN-R objects of Sony's AIBO on a PC, with a simulated body."};
  int exit_code = kExitGood;
  AddCommands(&app, &exit_code);
  const bool as_json = std::any_of(argv, argv + argc,
                                   [](const char* word) { return word == std::string("--json"); });
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return PrintAskedFor(app, error);
    TellFailure(ExplainCommandLine(app, error), as_json);
    std::fprintf(stderr, "'%s' tells more\n", HelpWords(app).c_str());
    return kExitCommandLine;
  } catch (const std::filesystem::filesystem_error& error) {
    TellFailure(Explain(error), as_json);
    return kExitWrong;
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) {  // fmt::print() has thrown, because stdout cannot be written
      NoteLostAnswer(error.code().value());
    } else {
      TellFailure(error.what(), as_json);
    }
    return kExitWrong;
  } catch (const std::exception& error) {
    TellFailure(error.what(), as_json);
    return kExitWrong;
  }
  return exit_code;
}

}  // namespace openr_host

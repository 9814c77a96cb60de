// Builds the command line of the program, and prints the error when a command fails.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#include "cli/exit_code.h"
#include "cli/output_file.h"
#include "cli/standard_streams.h"
#include "openr/commands/command_line.h"
#include "openr/commands/commands.h"

namespace openr_host {
namespace {

struct Command {
  std::string_view name;
  void (*add)(CLI::App* app, int* exit_code);
};

constexpr Command kCommands[] = {
    {"run", &AddRunCommand},         {"join", &AddJoinCommand},
    {"top", &AddTopCommand},         {"poke", &AddPokeCommand},
    {"attach", &AddAttachCommand},   {"panel", &AddPanelCommand},
    {"rc", &AddRcCommand},           {"graph", &AddGraphCommand},
    {"mtn", &AddMtnCommand},         {"log", &AddLogCommand},
    {"trace", &AddTraceCommand},     {"replay", &AddReplayCommand},
    {"explore", &AddExploreCommand}, {"build", &AddBuildCommand},
    {"new", &AddNewCommand},         {"controller", &AddControllerCommand},
    {"check", &AddCheckCommand},     {"model", &AddModelCommand},
    {"stick", &AddStickCommand},     {"stubgen", &AddStubgenCommand},
    {"plot", &AddPlotCommand},       {"help", &AddHelpCommand},
    {"version", &AddVersionCommand},
};

// Adds the command `wanted`, the first word of the command line, to `app`.  Adds all commands if
// `wanted` is "" or no command, or if it tells of the others.  To describe the flags of all
// commands takes a fifth of the start of the program.
void AddCommands(CLI::App* app, int* exit_code, std::string_view wanted) {
  app->name("openr");
  app->require_subcommand(1);
  app->set_help_all_flag("--help-all", "Help of all commands");
  const auto is_wanted = [wanted](const Command& command) { return command.name == wanted; };
  const bool has_one =
      wanted != "help" && std::any_of(std::begin(kCommands), std::end(kCommands), is_wanted);
  for (const Command& command : kCommands) {
    if (!has_one || is_wanted(command)) command.add(app, exit_code);
  }
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
  const auto has_word = [&](std::string_view wanted) {
    return std::any_of(argv, argv + argc, [&](const char* word) { return word == wanted; });
  };
  AddCommands(&app, &exit_code, argc > 1 && !has_word("--help-all") ? argv[1] : "");
  const bool as_json = has_word("--json");
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

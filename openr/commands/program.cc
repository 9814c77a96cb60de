// Builds the command line of the program, and prints the error when a command fails.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iterator>
#include <new>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>

#include "cli/colour.h"
#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/standard_streams.h"
#include "openr/commands/command_examples.h"
#include "openr/commands/command_line.h"
#include "openr/commands/commands.h"
#include "runtime/base/terminal_text.h"

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
    {"plot", &AddPlotCommand},       {"trace", &AddTraceCommand},
    {"replay", &AddReplayCommand},   {"explore", &AddExploreCommand},
    {"build", &AddBuildCommand},     {"coverage", &AddCoverageCommand},
    {"new", &AddNewCommand},         {"controller", &AddControllerCommand},
    {"check", &AddCheckCommand},     {"model", &AddModelCommand},
    {"stick", &AddStickCommand},     {"stubgen", &AddStubgenCommand},
    {"serve", &AddServeCommand},     {"help", &AddHelpCommand},
    {"version", &AddVersionCommand}, {"completion", &AddCompletionCommand},
    {"man", &AddManCommand},         {"emon", &AddEmonCommand},
    {"editor", &AddEditorCommand},
};

// Prints the error `why` on standard error, without control bytes, because `why` may quote a file
// or an answer of another program.  With `as_json`, because the user gave --json, also prints it as
// a JSON object on standard output.
void PrintFailure(const std::string& why, bool as_json) {
  const std::string name = Coloured(Colour::kError, "openr:", HasColours(STDERR_FILENO));
  std::fprintf(stderr, "%s %s\n", name.c_str(), TerminalText(why).c_str());
  if (!as_json) return;
  std::printf("%s\n", JsonText(nlohmann::json{{"error", why}}).c_str());
}

// Prints the help or the version that the user has asked for, and returns the exit code.  CLI11
// reports such a request by throwing `error`, an exception with exit code 0.
int PrintAskedFor(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  std::ostringstream text;
  const int exit_code = app.exit(error, text, text);
  const bool is_help = error.get_name() == "CallForHelp";
  try {
    PrintAnswerWithCodes(ForTerminal(is_help ? HelpAskedFor(app, argc, argv) : text.str()));
    return exit_code;
  } catch (const ReaderGone&) {
    return kExitReaderGone;
  } catch (const std::exception& failure) {
    PrintFailure(failure.what(), false);
    return kExitWrong;
  }
}

}  // namespace

// Adds only the command `wanted` to `app` if possible, because the program needs a fifth of its
// start time to add all commands.
void DescribeProgram(CLI::App* app, int* exit_code, std::string_view wanted) {
  app->name("openr");
  app->formatter(MakeHelpFormatter());
  app->require_subcommand(1);
  app->set_help_all_flag("--help-all", "Help of all commands");
  const bool tells_of_all = wanted == "help" || wanted == "completion" || wanted == "man";
  const auto is_wanted = [wanted](const Command& command) { return command.name == wanted; };
  const bool has_one =
      !tells_of_all && std::any_of(std::begin(kCommands), std::end(kCommands), is_wanted);
  for (const Command& command : kCommands) {
    if (!has_one || is_wanted(command)) command.add(app, exit_code);
  }
  AddExamples(app);
}

int RunProgram(int argc, char** argv) {
  CLI::App app{"Runs OPEN-R objects of Sony's AIBO on a PC, with a simulated body."};
  int exit_code = kExitGood;
  const auto has_word = [&](std::string_view wanted) {
    return std::any_of(argv, argv + argc, [&](const char* word) { return word == wanted; });
  };
  // Describes all commands for --help-all, and not only the one that the user has called.
  DescribeProgram(&app, &exit_code, argc > 1 && !has_word("--help-all") ? argv[1] : "");
  const bool as_json = has_word("--json");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return PrintAskedFor(app, error, argc, argv);
    PrintFailure(ExplainCommandLine(app, error), as_json);
    PrintPlain(stderr, "'{}' tells more\n", HelpWords(app));
    return kExitCommandLine;
  } catch (const ReaderGone&) {
    return kExitReaderGone;
  } catch (const std::filesystem::filesystem_error& error) {
    PrintFailure(Explain(error), as_json);
    return kExitWrong;
  } catch (const std::system_error& error) {
    // If standard output has an error, fmt::print() has thrown `error`, because the answer of the
    // command could not be written.  So NoteLostAnswer() reports that the answer is lost.
    if (std::ferror(stdout) != 0) {
      NoteLostAnswer(error.code().value());
    } else {
      PrintFailure(error.what(), as_json);
    }
    return kExitWrong;
  } catch (const std::bad_alloc&) {
    PrintFailure(
        "no memory: this computer gives this process no more; end other programs, or raise the "
        "limit of memory (ulimit -a shows it)",
        as_json);
    return kExitWrong;
  } catch (const std::exception& error) {
    PrintFailure(error.what(), as_json);
    return kExitWrong;
  }
  return exit_code;
}

}  // namespace openr_host

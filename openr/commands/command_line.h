// Explains errors in the program's command line.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

namespace openr_host {

// Returns one line about a wrong command line: the mistake, and what the user may have meant. `app`
// is the whole program; `error` is the exception that app.parse() has thrown.
std::string ExplainCommandLine(const CLI::App& app, const CLI::ParseError& error);

// Returns the formatter of all help texts.  In the help text about a command, the line "Usage:"
// also shows the positionals of the commands above this command, such as HOST in "openr rc HOST
// move", because a call without these positionals fails.
std::shared_ptr<CLI::FormatterBase> MakeHelpFormatter();

// Returns the help text `help` as it is printed: with bold headings if standard output is a
// terminal.
std::string ForTerminal(const std::string& help);

// Returns the help text that a user with the command line `argv` asks for by --help.
std::string HelpAskedFor(const CLI::App& app, int argc, char** argv);

// Returns the words that the user must type to get help about the command on the command line, such
// as "openr help run".
std::string HelpWords(const CLI::App& app);

}  // namespace openr_host

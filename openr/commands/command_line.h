// Explains errors in the program's command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace openr_host {

// Returns one line about a wrong command line: the mistake, and what the user may have meant. `app`
// is the whole program; `error` is the exception that app.parse() has thrown.
std::string ExplainCommandLine(const CLI::App& app, const CLI::ParseError& error);

// Returns the help text `help` as it is printed: with bold headings if standard output is a
// terminal.
std::string ForTerminal(const std::string& help);

// Returns the words that the user must type to get help about the command on the command line, such
// as "openr help run".
std::string HelpWords(const CLI::App& app);

}  // namespace openr_host

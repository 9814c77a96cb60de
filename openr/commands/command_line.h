// Explains errors in the program's command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace openr_host {

// Returns one line: what is wrong with the command line, and what the user may have meant.  `app`
// is the whole program; `error` is what app.parse() threw.
std::string ExplainCommandLine(const CLI::App& app, const CLI::ParseError& error);

// Returns what to type for help about the command on the command line, such as "openr help run".
std::string HelpWords(const CLI::App& app);

}  // namespace openr_host

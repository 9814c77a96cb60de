// Explains errors in the program's command line, and finds the words that ask for help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace openr_host {

// Returns a line that says what is wrong and what may have been meant.  `app` is the whole program;
// parsing its command line threw `error`.
std::string ExplainCommandLine(const CLI::App& app, const CLI::ParseError& error);

// Returns the words that ask for help about the command that was chosen: "openr help run".
std::string HelpWords(const CLI::App& app);

}  // namespace openr_host

// What the program says about its own command line: what is wrong with it, and help.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace openr_host {

// What is wrong, and what may have been meant, in one line.  `app` is the whole program, `error`
// what parsing it threw.
std::string ExplainCommandLine(const CLI::App& app, const CLI::ParseError& error);

// The words to ask for help about the command that was chosen: "openr help run".
std::string HelpWords(const CLI::App& app);

}  // namespace openr_host

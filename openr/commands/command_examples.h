// Examples for the help of each command.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace openr_host {

// Returns the examples of a command; each example is a line for a shell.  `path` names the command
// without "openr", such as "rc mtn play"; "" is the program itself.  Returns an empty list if the
// command has no examples.
std::vector<std::string> ExamplesOf(const std::string& path);

// Adds the examples to the help of `app`, the whole program, and of all commands in it.
void AddExamples(CLI::App* app);

}  // namespace openr_host

// Splits and quotes command lines in the way of a shell.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// Returns `text` as one word of a command line; in quotes if it has blanks or other special
// characters.
std::string ShellWord(const std::string& text);

// Returns the words of a command line, without quotes and backslashes.  Variables are not expanded.
std::vector<std::string> SplitShellWords(const std::string& command);

}  // namespace openr_host

// Command lines as a shell reads them.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// `text` as one word of a command: in quotes if it has blanks or the like.
std::string ShellWord(const std::string& text);

// The words of a command without variables, with quotes and backslashes taken off.
std::vector<std::string> SplitShellWords(const std::string& command);

}  // namespace openr_host

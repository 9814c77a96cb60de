// Makes text of files and of other programs harmless for a terminal.  A terminal obeys control
// bytes in a text: it could move its cursor, change its title or type text for the user.
#pragma once

#include <string>

namespace openr_host {

// Returns `text` with '?' in place of each control byte except newlines, tabs, and the carriage
// return of a line that ends as on the robot ("\r\n").  The control characters U+0080 to U+009F,
// two bytes each in UTF-8, count as control bytes, because terminals obey them, too.
std::string TerminalText(std::string text);

// Returns what TerminalText() returns, but with '?' also in place of newlines, for text that is
// part of one line.
std::string TerminalLine(std::string text);

}  // namespace openr_host

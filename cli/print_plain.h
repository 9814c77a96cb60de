// Prints text for people.  Such text may have words of files, objects, recordings and other
// computers in it, and a terminal obeys the control bytes of such words (terminal_text.h).
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace openr_host {

// Prints TerminalText(text) on `stream`: with '?' in place of control bytes.  So `text` cannot have
// colours.  Throws std::system_error if `stream` cannot be written, as
// fmt::print() does; stderr can always be written (standard_streams.h).
void PrintPlainText(std::FILE* stream, std::string text);

// Prints what fmt::format() returns, as PrintPlainText() does.
template <typename... T>
void PrintPlain(std::FILE* stream, fmt::format_string<T...> format, T&&... values) {
  PrintPlainText(stream, fmt::format(format, std::forward<T>(values)...));
}

// Prints what fmt::format() returns on standard output, as a part of the command's answer.
template <typename... T>
void PrintPlain(fmt::format_string<T...> format, T&&... values) {
  PrintPlainText(stdout, fmt::format(format, std::forward<T>(values)...));
}

}  // namespace openr_host

// Functions that return whether a character is a blank, a digit or a letter.  They accept only
// ASCII characters, while the functions of <cctype> depend on the host's locale.  So the parsers of
// the robot's text files use these functions.
#pragma once

namespace openr_host {

constexpr bool IsBlank(char c) { return c == ' ' || c == '\t'; }
constexpr bool IsDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool IsHexDigit(char c) {
  return IsDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

}  // namespace openr_host

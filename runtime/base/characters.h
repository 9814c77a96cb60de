// Functions that return whether a character is a blank, a digit or a letter.  The parsers of the
// robot's text files use these functions and not those of <cctype>, because these functions accept
// only ASCII characters, whatever the host's locale.
#pragma once

namespace openr_host {

constexpr bool IsBlank(char c) { return c == ' ' || c == '\t'; }
constexpr bool IsDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool IsHexDigit(char c) {
  return IsDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
}

}  // namespace openr_host

#include "cli/colour.h"

#include <unistd.h>

#include <cstdlib>

namespace openr_host {
namespace {

// Returns the numbers that select `colour` in the terminal's escape sequence "select graphic
// rendition" (ECMA-48, 8.3.117).
const char* CodeOf(Colour colour) {
  switch (colour) {
    case Colour::kBold:
      return "1";
    case Colour::kError:
      return "1;31";
    case Colour::kWarning:
      return "1;33";
    default:
      return "1;36";
  }
}

bool IsSet(const char* name) {
  const char* const value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

}  // namespace

bool HasColours(int descriptor) {
  const char* const terminal = std::getenv("TERM");
  const bool is_dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return !is_dumb && !IsSet("NO_COLOR") && isatty(descriptor) != 0;
}

std::string Coloured(Colour colour, std::string_view text, bool is_on) {
  if (!is_on || text.empty()) return std::string(text);
  return std::string("\x1b[") + CodeOf(colour) + "m" + std::string(text) + "\x1b[0m";
}

}  // namespace openr_host

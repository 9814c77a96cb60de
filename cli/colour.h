// Colours text that the program prints on a terminal.
#pragma once

#include <string>
#include <string_view>

namespace openr_host {

enum class Colour { kBold, kError, kWarning, kNote };

// Returns whether text on `descriptor` may have colours: it is a terminal, and the user has not
// asked for plain text with the environment variable NO_COLOR (no-color.org) or TERM=dumb.
bool HasColours(int descriptor);

// Returns `text` between the escape sequences that switch the colour on and off.  Returns `text`
// itself if `is_on` is false.
std::string Coloured(Colour colour, std::string_view text, bool is_on);

}  // namespace openr_host

// The inputs that every robot has: typed text (`type`), messages to observers (`send`), and the
// shutdown (`shutdown`).
#pragma once

#include <string>
#include <string_view>

namespace openr_host {

class System;

// Adds the kinds of inputs that begin with `type`, `send` and `shutdown` to System::inputs().
void AddSystemInputs(System* system);

// Adds the input `type TEXT`, which types `text` on the terminal of `robot`.  Returns "", or the
// reason why the input was refused, for example because the programs of the robot have not read the
// text that was typed before (ConsoleInput::kUnreadMax).
std::string TypeText(System* system, int robot, std::string_view text);

// Reads one value of a message from `word` and appends its bytes, little-endian and without
// padding, to `bytes`.  The forms of `word` are "5" (an int), "1.5" (a double), "float:1.5",
// "byte:7", "short:7", "long:7" (8 bytes), "hex:00ff", and "\"text\"" (the characters between the
// quotes).  Returns "" or the error.
std::string ReadMessageValue(std::string_view word, std::string* bytes);

}  // namespace openr_host

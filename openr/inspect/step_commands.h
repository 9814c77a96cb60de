// The commands of the prompt of openr replay --step, as the user types them.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// The help text for the prompt of openr replay --step, one line for each command.
inline constexpr char kStepHelp[] =
    "step [N]             N messages forward (s)\n"
    "back [N]             N messages back (b)\n"
    "goto N | goto TIME   to message N, as traces and differences number them, or to a time:\n"
    "                     goto 1.25s; goto 0 is the start (g)\n"
    "run                  to the next break, difference or the end (r)\n"
    "break object NAME | break service TEXT | break state OBJECT TEXT | break finding\n"
    "break when QUANTITY OP VALUE\n"
    "                     where it begins to hold: break when robots[0].pitch_deg > 10\n"
    "breaks, delete N     shows breaks, removes one\n"
    "print queue | waiting | objects | joints | findings | hash | message | QUANTITY (p)\n"
    "quit (q)\n";

// The first words of the commands, which the Tab key completes at the prompt of openr replay
// --step.
inline const std::vector<std::string> kStepCommands = {"step",   "back",   "goto",  "run",  "break",
                                                       "breaks", "delete", "print", "help", "quit"};

}  // namespace openr_host

// Exit codes of the commands.
#pragma once

namespace openr_host {

constexpr int kExitGood = 0;
constexpr int kExitWrong = 1;        // the input or the run is wrong
constexpr int kExitCommandLine = 2;  // the command line is wrong

}  // namespace openr_host

// Exit codes of the commands of the program openr.
#pragma once

namespace openr_host {

constexpr int kExitGood = 0;
constexpr int kExitWrong = 1;        // an error in the input or in the run
constexpr int kExitCommandLine = 2;  // an error in the command line

}  // namespace openr_host

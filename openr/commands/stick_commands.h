// The subcommands of `openr stick` for the Memory Stick of a real robot.
#pragma once

#include <CLI/CLI.hpp>

namespace openr_host {

void AddStickCheck(CLI::App* stick, int* exit_code);
void AddStickNew(CLI::App* stick, int* exit_code);
void AddStickWlan(CLI::App* stick, int* exit_code);

}  // namespace openr_host

// The commands below `openr stick` that are about a stick for a real robot.
#pragma once

#include <CLI/CLI.hpp>

namespace openr_host {

void AddStickCheck(CLI::App* stick, int* exit_code);
void AddStickNew(CLI::App* stick, int* exit_code);
void AddStickWlan(CLI::App* stick, int* exit_code);

}  // namespace openr_host

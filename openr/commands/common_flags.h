// Flags that several commands share.
#pragma once

#include <CLI/CLI.hpp>

#include "openr/simulation.h"

namespace openr_host {

// --stick, --robot, --world, --seed.
void AddCommonFlags(CLI::App* command, SimulationOptions* options);

}  // namespace openr_host

// Flags that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

#include "cli/input_file.h"
#include "openr/simulation/simulation.h"

namespace openr_host {

// Adds --stick, --robot, --world and --seed.
void AddCommonFlags(CLI::App* command, SimulationOptions* options);

// Add --battery and --cost, for commands that run robots.
void AddBatteryFlag(CLI::App* command, SimulationOptions* options);
void AddCostFlag(CLI::App* command, SimulationOptions* options);

// Adds a flag that takes a duration such as "20s".  `take` is called with microseconds if the flag
// is given.
CLI::Option* AddDurationFlag(CLI::App* command, const std::string& name,
                             const std::function<void(int64_t us)>& take,
                             const std::string& description);

// Adds a flag that stores a duration in a variable, whose present value is the default.
CLI::Option* AddDurationFlag(CLI::App* command, const std::string& name, int64_t* us,
                             const std::string& description);

// Refuses values that are not whole numbers of 64 bits.
CLI::Validator IsCount();

// Refuses files that cannot be written, before the command begins.
CLI::Validator IsWritable();

// Refuses files that cannot be read, before the command begins.  The error is "FLAG FILE: reason".
CLI::Validator IsReadable(const std::string& flag, const std::string& kind,
                          const std::string& extension);
CLI::Validator IsReadable(const std::string& flag, const InputKind& kind);

// Throws the error of IsReadable() for `file` with the reason `problem`; does nothing if `problem`
// is "".
void RefuseInput(const std::string& flag, const std::string& file, const std::string& problem);

// Refuses folders that can be neither created nor written to.
CLI::Validator IsFolder();

}  // namespace openr_host

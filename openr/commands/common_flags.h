// Flags that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

#include "cli/input_file.h"
#include "openr/simulation/simulation.h"

namespace openr_host {

// --stick, --robot, --world, --seed.
void AddCommonFlags(CLI::App* command, SimulationOptions* options);

// --battery and --cost of commands that run robots.
void AddBatteryFlag(CLI::App* command, SimulationOptions* options);
void AddCostFlag(CLI::App* command, SimulationOptions* options);

// A flag that takes a duration as people write it.  `take` gets microseconds, and only when the
// flag is given.
CLI::Option* AddDurationFlag(CLI::App* command, const std::string& name,
                             const std::function<void(int64_t us)>& take,
                             const std::string& description);

// The same for a variable, whose value is the default.
CLI::Option* AddDurationFlag(CLI::App* command, const std::string& name, int64_t* us,
                             const std::string& description);

// Refuses what is not a whole number of 64 bits.
CLI::Validator IsCount();

// Refuses files that cannot be written, before the command begins.
CLI::Validator IsWritable();

// Refuses files that cannot be read, before the command begins, as "FLAG FILE: reason".
CLI::Validator IsReadable(const std::string& flag, const std::string& kind,
                          const std::string& extension);
CLI::Validator IsReadable(const std::string& flag, const InputKind& kind);

// Throws what IsReadable() does for a file with this problem; "": there is none.
void RefuseInput(const std::string& flag, const std::string& file, const std::string& problem);

// Refuses folders that can be neither made nor written into.
CLI::Validator IsFolder();

}  // namespace openr_host

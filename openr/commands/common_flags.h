// Flags that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>

#include "cli/input_file.h"
#include "openr/simulation/simulation.h"

namespace openr_host {

// Name of the type of --world's value in CLI11.  The help shows this name, and DescribeCommands()
// recognises by this name that the value of a flag is a world.
inline constexpr char kWorldType[] = "WORLD";

// Adds the flags of all commands that load the objects of a stick: --stick, --robot, --world and
// --seed.
void AddCommonFlags(CLI::App* command, SimulationOptions* options);

// Adds the flags of commands that run several robots: --robots and --together.  Also allows several
// --stick flags.  Must be called after AddCommonFlags().
void AddRobotsFlags(CLI::App* command, SimulationOptions* options);
// Throws CLI::ValidationError if flags about several robots contradict each other.
void CheckRobots(const SimulationOptions& options);

// Adds --battery, which says how full the battery of the robots is, and whether it drains.  All
// commands that run robots have this flag.
void AddBatteryFlag(CLI::App* command, SimulationOptions* options);
// Adds --cost, which names the file of the cost model.  All commands that run robots have this
// flag.
void AddCostFlag(CLI::App* command, SimulationOptions* options);

// Adds the flag --images to `command`.  The value of the flag names the source of the pictures that
// the cameras of the robots see.
void AddImagesFlag(CLI::App* command, SimulationOptions* options);

// Adds a flag that takes a duration such as "20s".  If the user gives the flag, `take` is called
// with the duration in microseconds.
CLI::Option* AddDurationFlag(CLI::App* command, const std::string& name,
                             const std::function<void(int64_t us)>& take,
                             const std::string& description);

// Adds a flag that stores a duration in `*us`.  The default of the flag is the value that `*us` has
// when this function is called.
CLI::Option* AddDurationFlag(CLI::App* command, const std::string& name, int64_t* us,
                             const std::string& description);

// Returns the rate that `text`, the value of --rate, means: seconds of virtual time per second of
// real time; 0 for "max".  Throws CLI::ValidationError if `text` is no rate.
double RateOf(const std::string& text);

// Returns a check of a flag's value: it accepts only whole numbers from 0 to 2^64 - 1.
CLI::Validator IsCount();

// Returns a check of a flag's value: it refuses files that cannot be written.  The user then sees
// the error before the command does its work.
CLI::Validator IsWritable();

// Returns a check of the flag `flag`: it refuses files that cannot be read, with the error "FLAG
// FILE: reason".  If the user names a folder, the reason says what to give instead: a file of this
// `kind`, such as "placement file", with this `extension`, such as ".cfg".
CLI::Validator IsReadable(const std::string& flag, const std::string& kind,
                          const std::string& extension);
CLI::Validator IsReadable(const std::string& flag, const InputKind& kind);

// Throws CLI::ParseError with the text "FLAG FILE: `problem`", which says why `file`, the value of
// `flag`, cannot be used.  Does nothing if `problem` is "".
void RefuseInput(const std::string& flag, const std::string& file, const std::string& problem);

// Returns a check of a flag's value: it refuses folders that can be neither created nor written to.
CLI::Validator IsFolder();

}  // namespace openr_host

// Functions that several commands share, for motion files and for charts that the user names in the
// command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "MtnFile.h"

namespace openr_host {

// Reads the motion file `file`.  Throws std::runtime_error "FILE: reason" if the file cannot be
// read or is no motion.
MtnFile ReadMotion(const std::string& file);

// Adds the option -o, which names the file for a chart.  The option refuses names that do not end
// in .svg or .png, and files that cannot be written.
CLI::Option* AddChartOption(CLI::App* command, std::string* file);

}  // namespace openr_host

// The subcommands of openr mtn that write files: plot, from-csv and oda.
#pragma once

#include <CLI/CLI.hpp>

namespace openr_host {

// These functions add the commands plot, from-csv and oda to the command openr mtn.
void AddMtnPlotCommand(CLI::App* mtn, int* exit_code);
void AddMtnFromCsvCommand(CLI::App* mtn, int* exit_code);
void AddMtnOdaCommand(CLI::App* mtn, int* exit_code);

}  // namespace openr_host

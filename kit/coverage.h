// The command `openr coverage`: shows which lines of the user's sources were executed by runs.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace openr_host {

struct CoverageOptions {
  std::string folder;    // folder that was built with openr build --coverage
  std::string work;      // folder for private copies, as in BuildOptions
  std::string lcov;      // file to write in the format of lcov; "": none
  bool is_json = false;  // true: prints JSON
  bool resets = false;   // true: forgets the counts of earlier runs, and shows no counts
};

// Counts of executions of the lines with code: path of the source, number of the line, count.
using LineCounts = std::map<std::string, std::map<int, uint64_t>>;

// Adds the counts in `json` to `counts`.  `json` is the output of gcov --json-format, with one JSON
// document per line.  Throws std::runtime_error if `json` is not such output.
void AddGcovCounts(const std::string& json, LineCounts* counts);

// Returns the numbers of the lines that were not executed, with neighbours joined: "3, 7-9".  Lines
// without code between two such lines do not separate them.
std::string LinesNotRun(const std::map<int, uint64_t>& lines);

// Prints which lines were executed or, with `resets`, deletes the counts of earlier runs.  Returns
// the exit code.  Throws std::runtime_error if the folder was not built with --coverage, or if no
// run has left counts.
int ShowCoverage(const CoverageOptions& options);

}  // namespace openr_host

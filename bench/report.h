// The report of a bench: a table for people, and JSON for programs.
#pragma once

#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/machine.h"

namespace openr_host {

// Returns the line with the names of the table's columns.
std::string TableHead();

// Returns the lines of a row.  Its variants have the median of the rounds, the best round, and the
// ratio to the floor.  A limit is "met" if the medians meet it, "best met" if only the best rounds
// do, and else "missed".
std::string TableOf(const RowTimes& times);

// Writes all figures to the file `path`.
void WriteJson(const std::string& path, const Machine& machine,
               const std::vector<DogMemory>& memory, const std::vector<RowTimes>& rows);

}  // namespace openr_host

// Checks of each table that openr plot can read.
#pragma once

#include "openr/data/table.h"

namespace openr_host {

// Stops the process if a quantity of `table` has not as many times as values.  Then draws all
// quantities, as `openr plot` does, if this build has charts.
void DrawFuzzedTable(const Table& table);

}  // namespace openr_host

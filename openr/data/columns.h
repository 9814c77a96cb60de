// Columns: the quantities of a run that are written to a log, each with a name and a function to
// read it.
#pragma once

#include <string>
#include <vector>

#include "openr/explore/quantity.h"

namespace openr_host {

struct Column {
  std::string name;
  Quantity read;
};

// Returns a column for each quantity of the run that is a number.
std::vector<Column> ColumnsOf(const RunView& view);

// Appends a number with at most nine digits to `text`.  Appends nothing for NaN, because NaN means
// that there is no value.
void AppendNumber(double value, std::string* text);

}  // namespace openr_host

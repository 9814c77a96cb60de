// Columns: the quantities of a run that are logged, each with a name and a function to read it.
#pragma once

#include <string>
#include <vector>

#include "openr/explore/quantity.h"

namespace openr_host {

struct Column {
  std::string name;
  Quantity read;
};

// Returns the columns of all quantities that are numbers.
std::vector<Column> ColumnsOf(const RunView& view);

// Appends a number with nine digits at most; "" for NaN, which means that there is no value.
void AppendNumber(double value, std::string* text);

}  // namespace openr_host

#include "openr/data/columns.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace openr_host {

std::vector<Column> ColumnsOf(const RunView& view) {
  std::vector<Column> columns;
  for (const std::string& name : NumbersOf(view))
    columns.push_back({name, FindQuantity(name, view)});
  return columns;
}

void AppendNumber(double value, std::string* text) {
  if (!std::isnan(value)) fmt::format_to(std::back_inserter(*text), "{:.9g}", value);
}

}  // namespace openr_host

// Makes charts of tables: a panel for each quantity, or for each joint with its three angles.
#pragma once

#include <string>
#include <vector>

#include "openr/chart/chart.h"
#include "openr/data/table.h"

namespace openr_host {

struct PlotRequest {
  // The quantities to draw: a name, the end of a name behind a dot ("LF_j1"), or a pattern with *
  // ("sensor.*").  None: all joints.
  std::vector<std::string> wanted;
  double from_s = 0, until_s = 1e300;
  std::string title, subtitle;
};

// Returns the chart.  The angles of a joint, commanded, measured and of the body, share a panel
// unless one of them is asked for by its whole name.  Throws std::runtime_error when the table has
// nothing of that name, or no values in that time.
chart::Chart ChartOf(const Table& table, const PlotRequest& request);

}  // namespace openr_host

// Makes charts of tables.  A chart has a panel (a diagram) for each quantity, or a panel for each
// joint with its commanded angle, its measured angle and its angle on the simulated body.
#pragma once

#include <string>
#include <vector>

#include "openr/chart/chart.h"
#include "openr/data/table.h"

namespace openr_host {

struct PlotRequest {
  // The quantities to draw.  Each text is the name of a quantity, the part of such a name after a
  // dot ("LF_j1"), or a pattern for names with * ("sensor.*").  An empty list means all joints.
  std::vector<std::string> wanted;
  double from_s = 0, until_s = 1e300;
  std::string title, subtitle;
};

// Returns the chart of the quantities that `request` asks for.  A joint has three angles: the
// commanded angle, the measured angle, and its angle on the simulated body.  They share a panel.
// If the request has the whole name of an angle, such as "measured.LF_j1", this angle gets a panel
// of its own.  Throws std::runtime_error when the table has no quantity with a wanted name, or no
// values in the wanted time.
chart::Chart ChartOf(const Table& table, const PlotRequest& request);

}  // namespace openr_host

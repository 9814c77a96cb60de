// Charts of logs and motions: one panel for each joint.
#pragma once

#include <string>
#include <vector>

#include "MtnFile.h"
#include "openr/chart/chart.h"
#include "openr/motion/log_compare.h"

namespace openr_host {

// Returns the chart of all groups of a log.  `times_ms` are those of its records.
chart::Chart ChartOf(const LogFile& log, const std::vector<double>& times_ms,
                     const std::string& title);

// One side of a comparison.
struct ComparedSide {
  JointTraces traces;
  std::string label;  // text in the legend
};

// Two sides of a comparison, A and B.
struct Comparison {
  std::string title;
  ComparedSide a, b;
  JointTraces commanded;  // drawn behind the curves of A and B; empty: not drawn
  const RobotConstants* robot = nullptr;
  std::vector<JointDifference> differences;
};

// Returns the chart of a comparison, with lag and error of each joint.
chart::Chart ChartOf(const Comparison& comparison);

// Returns the chart of a motion file: the way of each joint, and marks at the key frames.
chart::Chart ChartOf(const MtnFile& motion, const std::string& title);

}  // namespace openr_host

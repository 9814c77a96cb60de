// Charts of motions and of the logs of motions: one diagram for each joint.
#pragma once

#include <string>
#include <vector>

#include "MtnFile.h"
#include "openr/chart/chart.h"
#include "openr/motion/log_compare.h"

namespace openr_host {

// Returns the chart of all groups of positions in the log of a motion: commanded, measured and
// simulated positions.  `times_ms` are the times of the log's records.
chart::Chart ChartOf(const LogFile& log, const std::vector<double>& times_ms,
                     const std::string& title);

// The positions of one motion in a comparison, and the label of its curves.
struct ComparedSide {
  JointTraces traces;
  std::string label;  // name of the motion in the legend
};

// Two motions to compare, A and B.
struct Comparison {
  std::string title;
  ComparedSide a, b;
  // Positions that the joints were commanded to take.  Their curves are drawn first, so that the
  // curves of the motions A and B lie on top of them.  Empty: these curves are not drawn.
  JointTraces commanded;
  const RobotConstants* robot = nullptr;
  std::vector<JointDifference> differences;
};

// Returns the chart of a comparison of two motions, with the lag and the error of each joint.
chart::Chart ChartOf(const Comparison& comparison);

// Returns the chart of a motion file: the position of each joint over time, with marks at the key
// frames.
chart::Chart ChartOf(const MtnFile& motion, const std::string& title);

}  // namespace openr_host

#include "openr/motion/log_charts.h"

#include <fmt/format.h>

#include "RobotDescription.h"
#include "openr/motion/mtn_csv.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

using chart::Chart;
using chart::Look;
using chart::Panel;

constexpr double kDegPerMicroradian = Degrees(1e-6);

chart::Curve CurveOf(const JointTraces& traces, size_t joint, Look look, const std::string& label) {
  return {look, label, traces.times_ms, traces.deg[joint]};
}

Chart EmptyChart(const std::string& title, const std::string& subtitle) {
  Chart chart;
  chart.title = title;
  chart.subtitle = subtitle;
  chart.x_label = "time since the first key frame [ms]";
  chart.y_label = "joint angle [degrees]";
  return chart;
}

Look LookOf(LogGroup group) {
  if (group == LogGroup::kCommanded) return Look::kReference;
  return group == LogGroup::kMeasured ? Look::kFirst : Look::kSecond;
}

// Returns the name of the joint that has this locator on a robot of any design.  Returns the
// locator itself if no design has such a joint.
std::string NameOfJoint(const std::string& locator) {
  for (const char* const design : {"ERS-210", "ERS-7"}) {
    const RobotConstants* const robot = FindRobot(design);
    const int joint = FindJoint(robot, locator.c_str());
    if (joint >= 0) return robot->joints[joint].name;
    const int plunger = FindPlunger(robot, locator.c_str());
    if (plunger >= 0) return robot->plungers[plunger].title;
  }
  return locator;
}

}  // namespace

Chart ChartOf(const LogFile& log, const std::vector<double>& times_ms, const std::string& title) {
  Chart chart =
      EmptyChart(title, fmt::format("{}, {} records", log.robot->design, log.records.size()));
  const std::vector<const JointConstants*> joints = LoggedJoints(*log.robot);
  for (const JointConstants* const joint : joints) chart.panels.push_back({joint->name, "", {}});
  for (const LogGroup group : {LogGroup::kCommanded, LogGroup::kMeasured, LogGroup::kSimulated}) {
    const JointTraces traces = TracesOf(log, times_ms, group);
    if (traces.times_ms.empty()) continue;
    for (size_t j = 0; j < joints.size(); ++j)
      chart.panels[j].curves.push_back(CurveOf(traces, j, LookOf(group), NameOf(group)));
  }
  return chart;
}

Chart ChartOf(const Comparison& comparison) {
  Chart chart = EmptyChart(comparison.title,
                           fmt::format("lag: how much later \"{}\" is than \"{}\"; RMS: of their "
                                       "difference",
                                       comparison.b.label, comparison.a.label));
  const std::vector<const JointConstants*> joints = LoggedJoints(*comparison.robot);
  for (size_t j = 0; j < joints.size(); ++j) {
    const JointDifference& difference = comparison.differences[j];
    const std::string lag =
        difference.lag_ms ? fmt::format("lag {} ms, ", Rounded(*difference.lag_ms, 1)) : "";
    Panel panel{joints[j]->name, fmt::format("{}RMS {:.2f} deg", lag, difference.rms_deg), {}};
    if (!comparison.commanded.times_ms.empty())
      panel.curves.push_back(CurveOf(comparison.commanded, j, Look::kReference, "commanded"));
    const ComparedSide& a = comparison.a;
    const ComparedSide& b = comparison.b;
    panel.curves.push_back(CurveOf(a.traces, j, Look::kFirst, a.label));
    panel.curves.push_back(CurveOf(b.traces, j, Look::kSecond, b.label));
    chart.panels.push_back(panel);
  }
  return chart;
}

Chart ChartOf(const MtnFile& motion, const std::string& title) {
  Chart chart = EmptyChart(title, fmt::format("\"{}\" for {}, {} key frames, {:.3f} s",
                                              motion.Name(), motion.DesignLabel(),
                                              motion.NumKeyFrames(), motion.DurationMs() / 1000.0));
  for (int j = 0; j < motion.NumJoints(); ++j) {
    const bool is_ear = HasTwoPositions(motion.Locator(j));
    chart::Curve way{Look::kFirst, "angle", {}, {}};
    for (int k = 0; k < motion.NumKeyFrames(); ++k) {
      way.x.push_back(motion.TimeMs(k));
      const int32_t angle = motion.Angle(k, j);
      way.y.push_back(is_ear ? (angle == 0 ? 0 : 1) : angle * kDegPerMicroradian);
    }
    const chart::Curve marks{Look::kMarks, "key frames", way.x, way.y};
    chart.panels.push_back(
        {NameOfJoint(motion.Locator(j)), is_ear ? "0 off, 1 on" : "", {way, marks}});
  }
  return chart;
}

}  // namespace openr_host

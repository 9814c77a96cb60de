#include "openr/data/table_chart.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "openr/data/quantity_unit.h"
#include "runtime/base/spelling.h"

namespace openr_host {
namespace {

using chart::Chart;
using chart::Curve;
using chart::Look;

constexpr size_t kNowhere = std::string::npos;
constexpr size_t kPanelsMax = 60;
// Largest time and largest value that a chart shows.  Points with larger numbers are left out,
// because the span of an axis with much larger numbers would not be finite.
constexpr double kDrawnMax = 1e100;

// A group of quantities with one angle of each joint, such as the measured angle.  One panel of the
// chart shows one joint, with its angles from all groups.
struct AngleGroup {
  const char* begin;  // prefix of the names of the quantities in the group
  Look look;
  const char* label;
};
constexpr AngleGroup kAngleGroups[] = {{"command.", Look::kReference, "commanded"},
                                       {"measured.", Look::kFirst, "measured"},
                                       {"joint.", Look::kSecond, "of the body"}};

const AngleGroup* AngleGroupOf(const std::string& name) {
  for (const AngleGroup& group : kAngleGroups) {
    const size_t at = name.find(group.begin);
    if (at == 0 || (at != kNowhere && name[at - 1] == '.')) return &group;
  }
  return nullptr;
}

// Returns the title of the chart's panel for the quantity `name`: the name without the prefix of
// its group.
std::string PanelOf(const std::string& name) {
  const AngleGroup* const group = AngleGroupOf(name);
  if (group == nullptr) return name;
  std::string panel = name;
  return panel.erase(panel.find(group->begin), std::string(group->begin).size());
}

// Returns whether `wanted`, a name or a pattern with '*', means the quantity `name`.  The parts of
// the name before a dot may be left out, so 'RF_j*' means all joint angles of the leg RF.
bool IsLike(const std::string& name, const std::string& wanted) {
  std::string pattern;
  for (const char c : wanted) {
    // Only '*' has a special meaning in `wanted`.  So '[', as in robots[1].x_m, and '?' get a '\',
    // because fnmatch() gives them a meaning, too.
    if (c == '[' || c == '?') pattern += '\\';
    pattern += c;
  }
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0 ||
         fnmatch(("*." + pattern).c_str(), name.c_str(), 0) == 0;
}

// The unit of the quantities in kAngleGroups, whose names do not end with the unit.
constexpr QuantityUnit kAngle{"deg", 1, 4};

// Returns the part of `series` in the time that `request` asks for, as a curve.  Leaves out points
// that cannot be drawn, because their time or value is NaN or has a size above kDrawnMax.  If this
// part has more than `points_max` points, divides the time into intervals and keeps only the lowest
// and the highest point of each interval.  So no peak is lost.
Curve CurveOf(const Series& series, const PlotRequest& request, size_t points_max) {
  Curve curve;
  for (size_t i = 0; i < series.values.size(); ++i) {
    if (series.time_s[i] < request.from_s || series.time_s[i] > request.until_s) continue;
    if (!(std::abs(series.time_s[i]) <= kDrawnMax && std::abs(series.values[i]) <= kDrawnMax))
      continue;
    curve.x.push_back(series.time_s[i]);
    curve.y.push_back(series.values[i]);
  }
  const size_t count = curve.x.size();
  if (count <= points_max) return curve;
  Curve thin;
  const size_t stretch = 2 * count / points_max + 1;
  for (size_t begin = 0; begin < count; begin += stretch) {
    const auto first = curve.y.begin() + static_cast<ptrdiff_t>(begin);
    const auto last = curve.y.begin() + static_cast<ptrdiff_t>(std::min(begin + stretch, count));
    const auto [low, high] = std::minmax_element(first, last);
    // Adds the lowest and the highest point of the interval in the order of their times, because
    // the curve is drawn from left to right.
    for (const auto point : {std::min(low, high), std::max(low, high)}) {
      thin.x.push_back(curve.x[static_cast<size_t>(point - curve.y.begin())]);
      thin.y.push_back(*point);
    }
  }
  return thin;
}

class ChartMaker {
 public:
  ChartMaker(const Table& table, const PlotRequest& request) : table_(table), request_(request) {}

  Chart Make() {
    chart_.title = request_.title;
    chart_.subtitle = request_.subtitle;
    chart_.x_label = "virtual time [s]";
    if (request_.wanted.empty()) ChooseJoints();
    for (const std::string& name : request_.wanted) Choose(name);
    if (panels_.size() > kPanelsMax) {
      throw std::runtime_error(fmt::format("{} panels do not fit into one chart, {} do; name fewer",
                                           panels_.size(), kPanelsMax));
    }
    LayOut();
    for (const ChosenPanel& chosen : panels_) AddPanel(chosen);
    const bool is_empty =
        std::all_of(chart_.panels.begin(), chart_.panels.end(), [](const chart::Panel& panel) {
          return std::all_of(panel.curves.begin(), panel.curves.end(),
                             [](const Curve& curve) { return curve.x.empty(); });
        });
    if (is_empty) throw std::runtime_error(EmptyChartText());
    return chart_;
  }

 private:
  // A panel of the chart, and the quantities that are drawn in this panel.
  struct ChosenPanel {
    std::string title;
    std::vector<const Series*> series;
  };

  // Returns the reason why there is no value to draw in the chart.
  std::string EmptyChartText() const {
    const bool has_values =
        std::any_of(table_.series.begin(), table_.series.end(),
                    [](const Series& series) { return !series.values.empty(); });
    return has_values ? "there are no values in this time, or only numbers above 1e100"
                      : "has names of quantities, but no values";
  }

  void ChooseJoints() {
    for (const Series& series : table_.series) {
      if (AngleGroupOf(series.name) != nullptr) Add(PanelOf(series.name), &series);
    }
    if (panels_.empty())
      throw std::runtime_error("there are no joints in it; name what to draw, --list shows it");
  }

  void Choose(const std::string& wanted) {
    for (const Series& series : table_.series) {
      if (series.name == wanted) return Add(wanted, &series);
    }
    const size_t before = panels_.size();
    bool has_found = false;
    for (const Series& series : table_.series) {
      if (!IsLike(series.name, wanted)) continue;
      has_found = true;
      Add(PanelOf(series.name), &series, before);
    }
    if (!has_found) throw std::runtime_error(NoValuesText(wanted));
  }

  std::string NoValuesText(const std::string& wanted) const {
    std::vector<std::string> known;
    for (const Series& series : table_.series) {
      known.push_back(series.name);
      known.push_back(PanelOf(series.name));
    }
    return fmt::format("there is no '{}' in it{}; --list shows what there is", wanted,
                       DidYouMean(wanted, known));
  }

  // Adds a quantity to the panel with the title `title`.  Looks for this panel only among the
  // panels from number `first` on.  If there is no such panel, makes a new one at the end.
  void Add(const std::string& title, const Series* series, size_t first = 0) {
    const auto panel =
        std::find_if(panels_.begin() + static_cast<ptrdiff_t>(first), panels_.end(),
                     [&](const ChosenPanel& chosen) { return chosen.title == title; });
    if (panel == panels_.end()) {
      panels_.push_back({title, {series}});
    } else {
      panel->series.push_back(series);
    }
  }

  // If the chart has at most four panels, puts them below each other in one column and makes them
  // larger.  More panels stay in several columns, because one column would be too high.
  void LayOut() {
    if (panels_.size() > 4) return;
    chart_.columns = 1;
    chart_.plot_width = 760;
    chart_.plot_height = panels_.size() == 1 ? 300 : 150;
  }

  void AddPanel(const ChosenPanel& chosen) {
    const std::string& name = chosen.series.front()->name;
    const QuantityUnit unit = AngleGroupOf(name) != nullptr ? kAngle : UnitOfQuantity(name);
    chart::Panel panel{chosen.title, unit.text, {}, unit.span_min};
    for (const Series* const series : chosen.series) {
      panel.curves.push_back(
          CurveOf(*series, request_, static_cast<size_t>(4 * chart_.plot_width)));
      for (double& value : panel.curves.back().y) value *= unit.factor;
      const AngleGroup* const group = AngleGroupOf(series->name);
      // Gives the curve no label for the legend if the whole name of the quantity is the title of
      // the chart's panel, because the title then says which curve it is.
      if (group == nullptr || chosen.title == series->name) continue;
      panel.curves.back().look = group->look;
      panel.curves.back().label = group->label;
    }
    // Sorts the curves by their look, so that the legend lists "commanded" before "measured" and
    // "of the body".  The legend lists the labels in the order of the curves.
    std::stable_sort(panel.curves.begin(), panel.curves.end(),
                     [](const Curve& a, const Curve& b) { return a.look < b.look; });
    chart_.panels.push_back(std::move(panel));
  }

  const Table& table_;
  const PlotRequest& request_;
  std::vector<ChosenPanel> panels_;
  Chart chart_;
};

}  // namespace

Chart ChartOf(const Table& table, const PlotRequest& request) {
  return ChartMaker(table, request).Make();
}

}  // namespace openr_host

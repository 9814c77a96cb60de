// Chart: a picture of one or several diagrams with curves, described as plain data.  The diagrams
// are called panels and stand in rows and columns.
#pragma once

#include <string>
#include <vector>

namespace openr_host::chart {

// The look of a curve.  The looks differ in width and dashes, so that they can be told apart
// without colour.
enum class Look {
  kReference,  // a wide pale line, drawn below the other curves
  kFirst,      // a solid line
  kSecond,     // a dashed line
  kMarks,      // small circles without a line
};

struct Curve {
  Look look = Look::kFirst;
  // Name of the curve in the legend.  If several curves have the same label, the legend shows this
  // label only once.
  std::string label;
  std::vector<double> x, y;  // coordinates of the points of the curve, in ascending order of x
};

struct Panel {
  std::string title;
  std::string note;  // short text to the right of `title`
  std::vector<Curve> curves;
  double y_span_min = 0;  // smallest span of the vertical axis; 0: uses Chart::y_span_min
};

struct Chart {
  std::string title;
  std::string subtitle;
  std::string x_label, y_label;  // labels of the two axes, which all diagrams share, with units
  int columns = 3;               // number of diagrams in a row; >= 1
  // Smallest span of a vertical axis, in the unit of the axis, so that small noise does not fill
  // the plot.
  double y_span_min = 4;
  double plot_width = 320, plot_height = 128;  // size of the plot in a diagram, in points
  std::vector<Panel> panels;                   // the diagrams of the picture, row by row
};

enum class FileType { kSvg, kPng };

// The type of the function openr_draw_chart(), which openr finds by its name in libopenr_chart.so.
// The function draws the chart and sets `bytes` to the content of a file of the type `type`.  If
// drawing fails, it sets `error` to the reason.
using DrawChartFunction = void(const Chart& chart, FileType type, std::string* bytes,
                               std::string* error);
constexpr char kDrawChartName[] = "openr_draw_chart";

// Returns the reason why a chart cannot be written to `file`, such as a name that does not end in
// .svg or .png; "" if the name is good.
std::string ChartNameProblem(const std::string& file);

// Draws the chart and writes it to `file`.  Returns "", or the reason why the chart cannot be drawn
// or written.  The first call loads libopenr_chart.so and Cairo.
std::string WriteChart(const Chart& chart, const std::string& file);

}  // namespace openr_host::chart

// Draws a chart with Cairo.  This file becomes the library libopenr_chart.so, of which the program
// openr calls only the function openr_draw_chart() (chart.h).
#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "openr/chart/chart.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host::chart {
namespace {

// Sizes in the drawing of a chart, in units of the picture; a unit is one point in an SVG file.
constexpr double kMargin = 24;
constexpr double kTickRoom = 40;  // width to the left of each plot, for the numbers at its axis
constexpr double kColumnGap = 22, kRowGap = 14;
constexpr double kTitleRoom = 22;  // height above each plot, for the title of its diagram
constexpr double kHeadRoom = 76;   // height above the first row of diagrams
constexpr double kAxisLabelRoom = 22;
constexpr double kFootRoom = 52;   // height below the last row of diagrams
constexpr double kPngScale = 1.5;  // pixels per unit of a picture in a PNG file

// Largest number of characters that Shortened() keeps of a text.  Shortened() does not measure
// longer texts, because no space in a chart is wide enough for them.
constexpr size_t kShownMax = 400;

struct Rgb {
  double r, g, b;
};
constexpr Rgb kBackground{1, 1, 1}, kPlotBackground{0.975, 0.978, 0.982}, kGrid{0.88, 0.89, 0.90},
    kFrame{0.62, 0.64, 0.67}, kInk{0.13, 0.15, 0.18}, kPaleInk{0.38, 0.41, 0.45};
// Colours of curves: grey, and two colours of the palette of Okabe and Ito, which people with any
// colour vision can tell apart.
constexpr Rgb kGrey{0.66, 0.68, 0.71}, kBlue{0.0, 0.40, 0.64}, kVermilion{0.80, 0.32, 0.0};

struct Rect {
  double x, y, width, height;
};

struct Span {
  double low, high;
};

// The numbers that are printed along an axis: `first`, `first` + `step`, and so on to the end of
// the axis.
struct Ticks {
  double first, step;
  int decimals;
};

// Returns the numbers to print along an axis whose values reach from span.low to span.high:
// multiples of a step that is 1, 2 or 5 times a power of ten.  The step is at least 1/`count` of
// the axis.
Ticks TicksOf(const Span& span, int count) {
  const double rough = (span.high - span.low) / count;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= rough) step = factor * power;
  }
  // Subtracts 1e-6 before rounding up, because a rounding error in the quotient could otherwise
  // leave out the number at the beginning of the axis.
  return {std::ceil(span.low / step - 1e-6) * step, step,
          std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)))};
}

// Returns `span`, made wider if it is so small that the numbers along its axis would not differ.
Span Readable(const Span& span) {
  const double least = std::max(1e-9, 1e-12 * std::max(std::abs(span.low), std::abs(span.high)));
  if (span.high - span.low >= least) return span;
  return {span.low - least / 2, span.high + least / 2};
}

void Widen(const std::vector<double>& values, Span* span) {
  for (const double value : values) {
    span->low = std::min(span->low, value);
    span->high = std::max(span->high, value);
  }
}

// Returns `text` with '?' in place of all bytes except printable ASCII.  Cairo refuses text that is
// not UTF-8, and a chart shows names from motion files, which may have any bytes.
std::string Printable(std::string text) {
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text;
}

// Returns the first and the last characters of `text`, `kept` in all, and dots in place of the
// others.
std::string WithoutMiddle(const std::string& text, size_t kept) {
  if (kept >= text.size()) return text;
  return text.substr(0, kept / 2) + "..." + text.substr(text.size() - (kept - kept / 2));
}

class Painter {
 public:
  Painter(const Chart& chart, cairo_t* cairo) : chart_(chart), cairo_(cairo) {
    bool is_first = true;
    for (const Panel& panel : chart.panels) {
      for (const Curve& curve : panel.curves) {
        if (curve.x.empty()) continue;
        if (is_first) x_span_ = {curve.x.front(), curve.x.front()};
        is_first = false;
        Widen(curve.x, &x_span_);
      }
    }
    if (x_span_.high <= x_span_.low) x_span_.high = x_span_.low + 1;
    x_span_ = Readable(x_span_);
  }

  void Draw() {
    const double width = WidthOf(chart_), height = HeightOf(chart_);
    Colour(kBackground);
    cairo_paint(cairo_);
    Text(kMargin, kMargin + 14, Shortened(chart_.title, 17, true, width - 2 * kMargin), 17, true,
         kInk);
    Text(kMargin, kMargin + 34, Shortened(chart_.subtitle, 11.5, false, width - 2 * kMargin), 11.5,
         false, kPaleInk);
    DrawLegend(width);
    const int count = static_cast<int>(chart_.panels.size());
    for (int i = 0; i < count; ++i) {
      const bool is_lowest = i + chart_.columns >= count;
      DrawPanel(chart_.panels[static_cast<size_t>(i)], PlotOf(i), is_lowest);
    }
    Text(width / 2, height - kMargin + 6, chart_.x_label, 12, false, kInk, 0.5);
    cairo_save(cairo_);
    cairo_translate(cairo_, kMargin + 4, (kHeadRoom + height - kFootRoom + kMargin) / 2);
    cairo_rotate(cairo_, -kPi / 2);
    Text(0, 0, chart_.y_label, 12, false, kInk, 0.5);
    cairo_restore(cairo_);
  }

  static double WidthOf(const Chart& chart) {
    const int columns = std::min(chart.columns, static_cast<int>(chart.panels.size()));
    return 2 * kMargin + kAxisLabelRoom + columns * (kTickRoom + chart.plot_width) +
           (columns - 1) * kColumnGap;
  }
  static double HeightOf(const Chart& chart) {
    const int count = static_cast<int>(chart.panels.size());
    const int rows = (count + chart.columns - 1) / chart.columns;
    return kMargin + kHeadRoom + rows * (kTitleRoom + chart.plot_height) + (rows - 1) * kRowGap +
           kFootRoom;
  }

 private:
  Rect PlotOf(int index) const {
    const int column = index % chart_.columns, row = index / chart_.columns;
    return {kMargin + kAxisLabelRoom + kTickRoom +
                column * (kTickRoom + chart_.plot_width + kColumnGap),
            kMargin + kHeadRoom + kTitleRoom + row * (kTitleRoom + chart_.plot_height + kRowGap),
            chart_.plot_width, chart_.plot_height};
  }

  // Returns the range of the vertical axis of a panel of the chart: the range of the panel's
  // values, with some space above and below.
  Span YSpanOf(const Panel& panel) const {
    Span span{1e300, -1e300};
    for (const Curve& curve : panel.curves) Widen(curve.y, &span);
    const double span_min = panel.y_span_min > 0 ? panel.y_span_min : chart_.y_span_min;
    if (span.low > span.high) return {-span_min / 2, span_min / 2};
    const double room =
        std::max(0.06 * (span.high - span.low), (span_min - (span.high - span.low)) / 2);
    return Readable({span.low - room, span.high + room});
  }

  void DrawPanel(const Panel& panel, const Rect& plot, bool is_lowest) {
    const Span y_span = YSpanOf(panel);
    const double room = plot.width - WidthOfText(panel.note, 10.5, false) - 8;
    Text(plot.x, plot.y - 6, Shortened(panel.title, 12, true, room), 12, true, kInk);
    Text(plot.x + plot.width, plot.y - 6, panel.note, 10.5, false, kPaleInk, 1);
    Colour(kPlotBackground);
    cairo_rectangle(cairo_, plot.x, plot.y, plot.width, plot.height);
    cairo_fill(cairo_);
    DrawGrid(plot, y_span, is_lowest);
    cairo_save(cairo_);
    cairo_rectangle(cairo_, plot.x, plot.y, plot.width, plot.height);
    cairo_clip(cairo_);
    // Draws the curves with the look kReference first, because their lines are wide and would
    // otherwise cover the other curves.
    for (const Look look : {Look::kReference, Look::kFirst, Look::kSecond, Look::kMarks}) {
      for (const Curve& curve : panel.curves) {
        if (curve.look == look) DrawCurve(curve, plot, y_span);
      }
    }
    cairo_restore(cairo_);
    Colour(kFrame);
    cairo_set_line_width(cairo_, 0.8);
    cairo_rectangle(cairo_, plot.x, plot.y, plot.width, plot.height);
    cairo_stroke(cairo_);
  }

  void DrawGrid(const Rect& plot, const Span& y_span, bool is_lowest) {
    cairo_set_line_width(cairo_, 0.8);
    const Ticks x = TicksOf(x_span_, 6);
    for (double value = x.first; value <= x_span_.high + 1e-6 * x.step; value += x.step) {
      const double at = XOf(value, plot);
      Line(at, plot.y, at, plot.y + plot.height);
      if (is_lowest) {
        Text(at, plot.y + plot.height + 14, Number(value, x.decimals), 10.5, false, kPaleInk, 0.5);
      }
    }
    const Ticks y = TicksOf(y_span, 5);
    for (double value = y.first; value <= y_span.high + 1e-6 * y.step; value += y.step) {
      const double at = YOf(value, plot, y_span);
      Line(plot.x, at, plot.x + plot.width, at);
      Text(plot.x - 5, at + 3.5, Number(value, y.decimals), 10.5, false, kPaleInk, 1);
    }
  }

  void DrawCurve(const Curve& curve, const Rect& plot, const Span& y_span) {
    SetLook(curve.look);
    for (size_t i = 0; i < curve.x.size(); ++i) {
      const double x = XOf(curve.x[i], plot), y = YOf(curve.y[i], plot, y_span);
      if (curve.look == Look::kMarks) {
        cairo_arc(cairo_, x, y, 1.8, 0, 2 * kPi);
        cairo_fill(cairo_);
      } else if (i == 0) {
        cairo_move_to(cairo_, x, y);
      } else {
        cairo_line_to(cairo_, x, y);
      }
    }
    cairo_stroke(cairo_);
    cairo_set_dash(cairo_, nullptr, 0, 0);
  }

  // Draws the legend at the right end of the space above the diagrams.  For each label, draws a
  // short line or a mark, which looks like the curves with this label, and the label itself.
  void DrawLegend(double width) {
    std::vector<const Curve*> entries;
    for (const Panel& panel : chart_.panels) {
      for (const Curve& curve : panel.curves) {
        const bool is_known = std::any_of(entries.begin(), entries.end(), [&](const Curve* entry) {
          return entry->label == curve.label;
        });
        if (!curve.label.empty() && !is_known) entries.push_back(&curve);
      }
    }
    double right = width - kMargin;
    const double y = kMargin + 58;
    std::reverse(entries.begin(), entries.end());
    const double room = (width - 2 * kMargin) / static_cast<double>(entries.size()) - 62;
    for (const Curve* const entry : entries) {
      const std::string label = Shortened(entry->label, 12, false, room);
      right -= WidthOfText(label, 12, false);
      Text(right, y + 4, label, 12, false, kInk);
      right -= 8;
      SetLook(entry->look);
      if (entry->look == Look::kMarks) {
        cairo_arc(cairo_, right - 8, y, 2.4, 0, 2 * kPi);
        cairo_fill(cairo_);
      } else {
        cairo_move_to(cairo_, right - 34, y);
        cairo_line_to(cairo_, right, y);
        cairo_stroke(cairo_);
      }
      cairo_set_dash(cairo_, nullptr, 0, 0);
      right -= 34 + 20;
    }
  }

  void SetLook(Look look) {
    const double dashes[] = {5, 3};
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_width(cairo_, look == Look::kReference ? 3.6 : 1.5);
    cairo_set_dash(cairo_, dashes, look == Look::kSecond ? 2 : 0, 0);
    Colour(look == Look::kReference ? kGrey : look == Look::kSecond ? kVermilion : kBlue);
  }

  double XOf(double value, const Rect& plot) const {
    return plot.x + plot.width * (value - x_span_.low) / (x_span_.high - x_span_.low);
  }
  static double YOf(double value, const Rect& plot, const Span& span) {
    return plot.y + plot.height * (span.high - value) / (span.high - span.low);
  }

  void Line(double x0, double y0, double x1, double y1) {
    Colour(kGrid);
    cairo_move_to(cairo_, x0, y0);
    cairo_line_to(cairo_, x1, y1);
    cairo_stroke(cairo_);
  }

  void Colour(const Rgb& colour) { cairo_set_source_rgb(cairo_, colour.r, colour.g, colour.b); }

  double WidthOfText(const std::string& text, double size, bool is_bold) {
    SetFont(size, is_bold);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, Printable(text).c_str(), &extents);
    return extents.x_advance;
  }

  // Returns `text`.  If `text` is wider than `room`, replaces its middle part by dots.
  std::string Shortened(const std::string& text, double size, bool is_bold, double room) {
    size_t kept = std::min(text.size(), kShownMax);
    std::string shortened = WithoutMiddle(text, kept);
    while (kept > 1 && WidthOfText(shortened, size, is_bold) > room)
      shortened = WithoutMiddle(text, --kept);
    return shortened;
  }

  void SetFont(double size, bool is_bold) {
    cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                           is_bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, size);
  }

  // Draws a text with its base line at the height y.  With `anchor` 0 the text begins at x; with
  // 0.5 its middle is at x; with 1 its end is at x.
  void Text(double x, double y, const std::string& text, double size, bool is_bold,
            const Rgb& colour, double anchor = 0) {
    const double width = WidthOfText(text, size, is_bold);
    Colour(colour);
    cairo_move_to(cairo_, x - anchor * width, y);
    cairo_show_text(cairo_, Printable(text).c_str());
    // Deletes Cairo's current point, which is now at the end of the text.  Otherwise cairo_arc(),
    // which draws the circles of a curve, would begin with a line from this point.
    cairo_new_path(cairo_);
  }

  static std::string Number(double value, int decimals) {
    char text[128];  // large enough: a number up to 1e100 has at most 101 digits before the point
    std::snprintf(text, sizeof text, "%.*f", decimals, value == 0 ? 0.0 : value);
    return text;
  }

  const Chart& chart_;
  cairo_t* const cairo_;
  Span x_span_{0, 1};
};

cairo_status_t Append(void* bytes, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

void ThrowIfBad(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS) throw std::runtime_error(cairo_status_to_string(status));
}

void DrawTo(cairo_surface_t* surface, double scale, const Chart& chart) {
  const std::unique_ptr<cairo_t, void (*)(cairo_t*)> cairo(cairo_create(surface), &cairo_destroy);
  cairo_scale(cairo.get(), scale, scale);
  Painter(chart, cairo.get()).Draw();
  ThrowIfBad(cairo_status(cairo.get()));
}

using Surface = std::unique_ptr<cairo_surface_t, void (*)(cairo_surface_t*)>;

std::string ToSvg(const Chart& chart) {
  std::string bytes;
  const Surface surface(cairo_svg_surface_create_for_stream(
                            &Append, &bytes, Painter::WidthOf(chart), Painter::HeightOf(chart)),
                        &cairo_surface_destroy);
  DrawTo(surface.get(), 1, chart);
  cairo_surface_finish(surface.get());
  ThrowIfBad(cairo_surface_status(surface.get()));
  return bytes;
}

std::string ToPng(const Chart& chart) {
  const Surface surface(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                 static_cast<int>(kPngScale * Painter::WidthOf(chart)),
                                 static_cast<int>(kPngScale * Painter::HeightOf(chart))),
      &cairo_surface_destroy);
  DrawTo(surface.get(), kPngScale, chart);
  std::string bytes;
  ThrowIfBad(cairo_surface_write_to_png_stream(surface.get(), &Append, &bytes));
  return bytes;
}

}  // namespace

extern "C" __attribute__((visibility("default"))) void openr_draw_chart(const Chart& chart,
                                                                        FileType type,
                                                                        std::string* bytes,
                                                                        std::string* error) {
  try {
    *bytes = type == FileType::kSvg ? ToSvg(chart) : ToPng(chart);
  } catch (const std::exception& e) {
    *error = e.what();
  }
}

}  // namespace openr_host::chart

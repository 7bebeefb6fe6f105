#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/plots/axes.h"
#include "sim/plots/chart_series.h"
#include "sim/plots/labels.h"
#include "sim/plots/layout.h"
#include "sim/plots/text_size.h"
#include "sim/plots/tips.h"

namespace csgsim::plots {

namespace {

constexpr double between_panels = 24;
constexpr double mark_size = 9;
constexpr double small_mark_size = 5;
constexpr std::size_t many_points = 60;  ///< a series with more points has small marks
constexpr double longest_label = 220;
constexpr std::size_t numbers_in_key = 24;

double panel_height(std::size_t panels) { return panels == 1 ? 360 : panels == 2 ? 230 : 170; }

/// A panel's place in the picture, and the values that its axes span.
struct Panel {
  Box area;
  Extent x;
  Extent y;

  [[nodiscard]] Pixel at(const Point& point) const {
    return {area.left + x.fraction_along(point.x) * (area.right - area.left),
            area.bottom - y.fraction_along(point.y) * (area.bottom - area.top)};
  }
};

bool is_finite(const Point& point) { return std::isfinite(point.x) && std::isfinite(point.y); }

Extent x_extent(const Chart& chart) {
  if (chart.x.is_names) return {-0.5, static_cast<double>(std::max<std::size_t>(chart.x.ticks.size(), 1)) - 0.5};
  std::vector<double> values;
  for (const Tick& tick : chart.x.ticks) values.push_back(tick.value);
  for (const Series& series : chart.series) {
    if (series.trace == Trace::level) continue;
    for (const Point& point : series.points) {
      if (is_finite(point)) values.push_back(point.x);
    }
  }
  return make_extent(values, chart.x.scale, Begin::at_values);
}

Extent y_extent(const Chart& chart, std::size_t panel) {
  std::vector<double> values;
  for (const Series& series : chart.series) {
    if (series.panel != panel || series.trace == Trace::upright) continue;
    for (const Point& point : series.points) {
      if (is_finite(point)) values.push_back(point.y);
    }
  }
  // Bars and marks above names are compared by height, so the axis starts at 0.
  return make_extent(values, chart.panels[panel].scale, chart.x.is_names ? Begin::at_zero : Begin::near_zero);
}

std::vector<Panel> panels_of(const Chart& chart) {
  const double height = panel_height(chart.panels.size());
  std::vector<Panel> panels;
  double left = 0;
  for (std::size_t i = 0; i < chart.panels.size(); ++i) {
    const double top = title_height + static_cast<double>(i) * (height + between_panels);
    panels.push_back({{0, top, plot_width - right_margin, top + height}, x_extent(chart), y_extent(chart, i)});
    const std::vector<Tick> ticks = make_y_ticks(chart.panels[i], panels.back().y, height);
    left = std::max(left, y_axis_width(chart.panels[i], ticks, height));
  }
  for (Panel& panel : panels) panel.area.left = left;
  return panels;
}

/// The marks, lines and labels of one panel.
class PanelContent {
 public:
  PanelContent(const Chart& chart, const Panel& panel)
      : chart_(chart), panel_(panel), surroundings_{inside(panel.area), {}, {}} {}

  /// Adds a series. `more` is added to the size of the marks, in pixels.
  void add(Drawing& drawing, const Series& series, const palette::Look& look, double more) {
    const double size = series.is_background || series.points.size() > many_points ? small_mark_size : mark_size + more;
    const std::vector<Pixel> pixels = pixels_of(series, size);
    if (pixels.empty()) return;
    if (series.trace == Trace::steps) add_line(drawing, steps_of(pixels), look);
    if (series.trace == Trace::line) add_line(drawing, pixels, look);
    for (const Point& point : series.points) {
      if (!is_finite(point)) continue;
      const std::string tip = tip_text(chart_, series, point);
      if (series.trace == Trace::level || series.trace == Trace::upright) return add_line(drawing, pixels, look, tip);
      const Pixel at = panel_.at(point);
      drawing.marks.push_back({at, look.mark, look.colour, size, tip});
      surroundings_.boxes.push_back(square_around(at, size / 2));
    }
  }

  /// Adds the labels. The key holds the texts of labels that were replaced by a number.
  void add_labels(Drawing& drawing, std::vector<KeyEntry>& key, const std::string& table) const {
    std::vector<LabelRequest> requests;
    requests.reserve(labels_.size());
    for (const Label& label : labels_) requests.push_back({label.at, text_width(label.text), label.mark / 2});
    const std::vector<PlacedLabel> placed = place_labels(requests, surroundings_);
    for (const PlacedLabel& label : placed) {
      const std::string& text = labels_[label.request].text;
      if (label.leader) drawing.lines.push_back({{label.leader->from, label.leader->to}, palette::leader});
      drawing.texts.push_back({label.number ? std::to_string(*label.number) : text,
                               {(label.box.left + label.box.right) / 2, (label.box.top + label.box.bottom) / 2},
                               Anchor::centre});
      if (label.number && *label.number <= numbers_in_key) key.push_back({fmt::format("{}: {}", *label.number, text)});
    }
    const auto shown = static_cast<std::size_t>(std::ranges::count_if(
        placed, [](const PlacedLabel& label) { return !label.number || *label.number <= numbers_in_key; }));
    if (shown < labels_.size()) key.push_back({fmt::format("{} more labels in {}", labels_.size() - shown, table)});
  }

 private:
  struct Label {
    Pixel at;
    std::string text;
    double mark = 0;  ///< size in pixels of the largest mark at this place
  };

  static Box inside(const Box& area) { return {area.left + 2, area.top + 2, area.right - 2, area.bottom - 2}; }

  std::vector<Pixel> pixels_of(const Series& series, double mark) {
    std::vector<Pixel> pixels;
    for (const Point& point : series.points) {
      if (!is_finite(point)) continue;
      const Pixel at = panel_.at(point);
      if (series.trace == Trace::level) return {{panel_.area.left, at.y}, {panel_.area.right, at.y}};
      if (series.trace == Trace::upright) return {{at.x, panel_.area.top}, {at.x, panel_.area.bottom}};
      pixels.push_back(at);
      if (!point.label.empty()) add_label(at, shorten(point.label, longest_label), mark);
    }
    return pixels;
  }

  /// Corners of the steps; a single point extends to the right edge.
  [[nodiscard]] std::vector<Pixel> steps_of(const std::vector<Pixel>& pixels) const {
    std::vector<Pixel> corners;
    corners.reserve(2 * pixels.size());
    for (const Pixel& at : pixels) {
      if (!corners.empty()) corners.push_back({at.x, corners.back().y});
      corners.push_back(at);
    }
    const bool goes_left = pixels.back().x < pixels.front().x;
    corners.push_back({goes_left ? panel_.area.left : panel_.area.right, pixels.back().y});
    return corners;
  }

  /// Merges the labels of points at the same place into one text.
  void add_label(const Pixel& at, std::string text, double mark) {
    const auto same = std::ranges::find_if(
        labels_, [&](const Label& label) { return boxes_overlap(square_around(label.at, 1), square_around(at, 0.5)); });
    if (same == labels_.end()) {
      labels_.push_back({at, std::move(text), mark});
      return;
    }
    same->mark = std::max(same->mark, mark);
    const std::string together = same->text + ", " + text;
    if (same->text != text && text_width(together) <= longest_label) same->text = together;
  }

  void add_line(Drawing& drawing, const std::vector<Pixel>& pixels, const palette::Look& look,
                const std::string& tip = "") {
    if (pixels.size() < 2) return;
    drawing.lines.push_back({pixels, look.colour, 2, look.dash, tip});
    for (std::size_t i = 1; i < pixels.size(); ++i) surroundings_.segments.push_back({pixels[i - 1], pixels[i]});
  }

  const Chart& chart_;
  const Panel& panel_;
  Surroundings surroundings_;
  std::vector<Label> labels_;
};

/// Series that are drawn first get larger marks, so that they remain visible below later ones.
double mark_growth(const SeriesLooks& looks, std::size_t series) {
  constexpr double step = 2;
  constexpr std::size_t steps = 3;
  if (looks.looks[series].colour == palette::background.colour) return 0;
  const auto later = static_cast<std::size_t>(std::count_if(
      looks.looks.begin() + static_cast<std::ptrdiff_t>(series), looks.looks.end(), [&](const palette::Look& look) {
        return look.colour != looks.looks[series].colour && look.colour != palette::background.colour;
      }));
  return step * static_cast<double>(std::min(steps, later));
}

/// Background series first, then those without a colour, then the others.
std::vector<std::size_t> drawing_order(const Chart& chart, const SeriesLooks& looks) {
  std::vector<std::size_t> order;
  for (const bool coloured : {false, true}) {
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
      if ((looks.looks[i].colour != palette::background.colour) == coloured) order.push_back(i);
    }
  }
  return order;
}

}  // namespace

Drawing lay_out(const Chart& chart) {
  Drawing drawing{plot_width, 0, {}, {}, {}, {}};
  SeriesLooks looks = series_looks(chart);
  const std::vector<Panel> panels = panels_of(chart);
  add_title(drawing, chart.title);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const Panel& panel = panels[i];
    add_grid(drawing, make_x_ticks(chart.x, panel.x), panel.x,
             make_y_ticks(chart.panels[i], panel.y, panel.area.bottom - panel.area.top), panel.y, panel.area);
    add_y_axis(drawing, chart.panels[i], panel.y, panel.area);
    PanelContent content(chart, panel);
    for (const std::size_t s : drawing_order(chart, looks)) {
      if (chart.series[s].panel == i) content.add(drawing, chart.series[s], looks.looks[s], mark_growth(looks, s));
    }
    content.add_labels(drawing, looks.key, chart.table);
  }
  const double bottom = add_x_axis(drawing, chart.x, panels.back().x, panels.back().area);
  drawing.height = add_key(drawing, looks.key, side_margin, plot_width - side_margin, bottom) + side_margin;
  return drawing;
}

}  // namespace csgsim::plots

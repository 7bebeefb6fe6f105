#include "sim/report/plot_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <variant>
#include <vector>

#include "sim/plots/common_looks.h"
#include "sim/plots/palette.h"
#include "sim/report/html.h"
#include "sim/report/number_text.h"
#include "sim/report/scale.h"
#include "sim/report/table_html.h"

namespace csgsim::report {

namespace {

/// A picture's pixels, where a window is at least so wide.
struct Layout {
  const char* name;
  double width;
  double height;
  unsigned x_ticks;
};

constexpr Layout layouts[] = {{"wide", 620, 340, 8}, {"narrow", 350, 300, 6}};
constexpr unsigned y_ticks = 6;
constexpr double character = 7.4;  ///< pixels, of text of 13 pixels
constexpr double line = 18;        ///< pixels

struct Place {
  double x;
  double y;
};

struct Frame {
  double left;
  double top;
  double right;
  double bottom;
};

std::vector<double> values_of(std::span<const Series> series, double Point::*member) {
  std::vector<double> values;
  for (const Series& one : series)
    for (const Point& point : one.points) values.push_back(point.*member);
  return values;
}

/// Bytes that do not go on a character: an estimate of how wide a text is.
double width_of(const std::string& text) {
  const auto characters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xc0) != 0x80; });
  return character * static_cast<double>(characters);
}

double widest(const std::vector<Tick>& ticks) {
  double width = 0;
  for (const Tick& tick : ticks) width = std::max(width, width_of(tick.text));
  return width;
}

/// With as many ticks as leave room between their texts.
Scale x_scale(const Axis& axis, const std::vector<double>& values, unsigned most_ticks, double room) {
  constexpr double gap = 14;
  Scale scale(axis, values, most_ticks);
  while (most_ticks > 1 && static_cast<double>(scale.ticks().size()) * (widest(scale.ticks()) + gap) > room)
    scale = Scale(axis, values, --most_ticks);
  return scale;
}

std::string value_text(const Axis& axis, double value) {
  return axis.names.empty() ? number_text(value) : axis.names.at(static_cast<std::size_t>(value));
}

std::string tip_of(const Plot& plot, const Series& series, const Point& point) {
  const std::string label = point.label.empty() || point.label == series.name ? "" : ", " + point.label;
  return fmt::format("{}{}: {} {}, {} {}", series.name, label, plot.x.title, value_text(plot.x, point.x), plot.y.title,
                     value_text(plot.y, point.y));
}

/// Colours come round again with other dashes and marks.
std::size_t form_of(std::size_t index) {
  return (index + index / plots::palette::most_series) % plots::palette::most_series;
}

std::string style_of(std::size_t index) {
  return fmt::format("s{} d{}", index % plots::palette::most_series, form_of(index));
}

/// The place of a line's look.
std::size_t look_of(const Plot& plot, std::size_t index, const plots::Looks& looks) {
  const auto known = looks.find(plot.series[index].name);
  return known == looks.end() ? index : known->second;
}

/// What joins points at these places of the picture.
std::string trace_path(plots::Trace trace, const std::vector<Place>& places, const Frame& frame) {
  if (trace == plots::Trace::marks) return "";
  if (trace == plots::Trace::level)
    return fmt::format("M{:.1f} {:.1f}H{:.1f}", frame.left, places.front().y, frame.right);
  if (trace == plots::Trace::upright)
    return fmt::format("M{:.1f} {:.1f}V{:.1f}", places.front().x, frame.top, frame.bottom);
  std::string path = fmt::format("M{:.1f} {:.1f}", places.front().x, places.front().y);
  const bool is_steps = trace == plots::Trace::steps;
  for (std::size_t i = 1; i < places.size(); ++i)
    path += is_steps ? fmt::format("H{:.1f}V{:.1f}", places[i].x, places[i].y)
                     : fmt::format("L{:.1f} {:.1f}", places[i].x, places[i].y);
  const bool goes_left = places.back().x < places.front().x;
  if (is_steps) path += fmt::format("H{:.1f}", goes_left ? frame.left : frame.right);
  return path;
}

/// The title below an axis, in two lines where one is too long.
std::string title_svg(const std::string& title, const Frame& frame) {
  std::size_t cut = title.size();
  if (width_of(title) > frame.right) {
    cut = title.rfind(' ', title.size() / 2);
    if (cut == std::string::npos) cut = title.size();
  }
  const double middle = std::max((frame.left + frame.right) / 2, width_of(title.substr(0, cut)) / 2);
  const auto text = [&](const std::string& words, double y) {
    return fmt::format("<text class=of x={:.1f} y={:.1f} text-anchor=middle>{}</text>", middle, y, html_text(words));
  };
  const double y = frame.bottom + 2.2 * line;
  return cut == title.size() ? text(title, y) : text(title.substr(0, cut), y) + text(title.substr(cut + 1), y + line);
}

std::string grid_svg(const Plot& plot, const Scale& x, const Scale& y, const Frame& frame) {
  std::string svg;
  for (const Tick& tick : y.ticks()) {
    const double at = frame.bottom - tick.at * (frame.bottom - frame.top);
    svg +=
        fmt::format("<path class=grid d=\"M{:.1f} {:.1f}H{:.1f}\"/><text x={:.1f} y={:.1f} text-anchor=end>{}</text>",
                    frame.left, at, frame.right, frame.left - 8, at + 4.5, html_text(tick.text));
  }
  for (const Tick& tick : x.ticks()) {
    const double at = frame.left + tick.at * (frame.right - frame.left);
    svg += fmt::format(
        "<path class=grid d=\"M{:.1f} {:.1f}V{:.1f}\"/><text x={:.1f} y={:.1f} text-anchor=middle>{}</text>", at,
        frame.top, frame.bottom, at, frame.bottom + line, html_text(tick.text));
  }
  svg += fmt::format("<path class=axis d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\"/>", frame.left, frame.top, frame.bottom,
                     frame.right);
  svg += fmt::format("<text class=of x=2 y={:.1f}>{}</text>", frame.top - 12, html_text(plot.y.title));
  return svg + title_svg(plot.x.title, frame);
}

std::string series_svg(const Plot& plot, const Series& series, std::size_t look, const Scale& x, const Scale& y,
                       const Frame& frame) {
  std::vector<Place> places;
  std::string points;
  for (const Point& point : series.points) {
    const double px = frame.left + x.at(point.x) * (frame.right - frame.left);
    const double py = frame.bottom - y.at(point.y) * (frame.bottom - frame.top);
    places.push_back({px, py});
    points += fmt::format("<g class=pt><title>{}</title><use href=\"#m{}\" x={:.1f} y={:.1f} /></g>",
                          html_text(tip_of(plot, series, point)), form_of(look), px, py);
  }
  const std::string path = places.empty() ? "" : trace_path(series.trace, places, frame);
  const std::string joined = path.empty() ? "" : fmt::format("<path class=line d=\"{}\"/>", path);
  return fmt::format("<g class=\"series {}\">{}{}</g>", style_of(look), joined, points);
}

std::string svg_of(const Plot& plot, const Layout& layout, const plots::Looks& looks) {
  const std::vector<double> xs = values_of(plot.series, &Point::x);
  const std::vector<double> ys = values_of(plot.series, &Point::y);
  const Scale y(plot.y, ys, y_ticks);
  Frame frame{widest(y.ticks()) + 14, 2 * line, layout.width - 16, layout.height - 3.6 * line};
  const Scale x = x_scale(plot.x, xs, layout.x_ticks, frame.right - frame.left);
  if (!x.ticks().empty()) frame.right = std::min(frame.right, layout.width - 6 - width_of(x.ticks().back().text) / 2);
  std::string svg = fmt::format(
      "<svg class=\"plot {}\" viewBox=\"0 0 {} {}\" role=img aria-label=\"{}: {} against {}; the values are in the "
      "table below it\">",
      layout.name, layout.width, layout.height, html_text(plot.title), html_text(plot.y.title),
      html_text(plot.x.title));
  svg += grid_svg(plot, x, y, frame);
  for (std::size_t i = 0; i < plot.series.size(); ++i)
    svg += series_svg(plot, plot.series[i], look_of(plot, i, looks), x, y, frame);
  return svg + "</svg>\n";
}

std::string legend_html(const Plot& plot, const plots::Looks& looks) {
  if (plot.series.size() < 2) return "";
  std::string html = "<ul class=legend>";
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const char* const stroke = plot.series[i].trace != plots::Trace::marks ? "<path class=line d=\"M2 8H38\"/>" : "";
    html += fmt::format(
        "<li><svg width=40 height=16 aria-hidden=true><g class=\"series {}\">{}<use href=\"#m{}\" x=20 y=8 "
        "/></g></svg>{}</li>",
        style_of(look_of(plot, i, looks)), stroke, form_of(look_of(plot, i, looks)), html_text(plot.series[i].name));
  }
  return html + "</ul>\n";
}

Table values_table(const Plot& plot) {
  const bool has_labels = std::any_of(plot.series.begin(), plot.series.end(), [](const Series& series) {
    return std::any_of(series.points.begin(), series.points.end(),
                       [](const Point& point) { return !point.label.empty(); });
  });
  Table table{"", {"", plot.x.title, plot.y.title}, {}};
  if (has_labels) table.columns.emplace_back("point");
  const auto value = [](const Axis& axis, double number) {
    return axis.names.empty() ? Cell{number} : Cell{axis.names.at(static_cast<std::size_t>(number))};
  };
  for (const Series& series : plot.series) {
    for (const Point& point : series.points) {
      Row row{{series.name}, value(plot.x, point.x), value(plot.y, point.y)};
      if (has_labels) row.push_back({point.label});
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace

std::string plot_html(const Plot& all, const std::string& id, const plots::Looks& looks) {
  Plot plot = all;
  if (plot.series.size() > most_series) plot.series.resize(most_series);
  std::string html =
      fmt::format("<figure class=plots id={}>\n<figcaption>{}</figcaption>\n", id, html_text(plot.title));
  if (all.series.size() > most_series)
    html += fmt::format("<p class=note>The first {} of {} lines; all are in the values below.</p>\n", most_series,
                        all.series.size());
  html += legend_html(plot, looks);
  for (const Layout& layout : layouts) html += svg_of(plot, layout, looks);
  return html + "<details><summary>The values of this plot</summary>\n" + table_html(values_table(all)) +
         "</details>\n</figure>\n";
}

plots::Looks page_looks(const Page& page) {
  std::vector<plots::Names> names;
  for (const Section& section : page.sections) {
    for (const Part& part : section.parts) {
      const auto* const plot = std::get_if<Plot>(&part);
      if (plot == nullptr) continue;
      plots::Names& shown = names.emplace_back();
      for (std::size_t i = 0; i < std::min(plot->series.size(), most_series); ++i)
        shown.push_back(plot->series[i].name);
    }
  }
  constexpr std::size_t colours = plots::palette::most_series;
  return plots::common_looks(names, colours, colours * colours);
}

}  // namespace csgsim::report

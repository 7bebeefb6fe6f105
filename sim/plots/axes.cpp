#include "sim/plots/axes.h"

#include <algorithm>

#include "sim/plots/text_size.h"

namespace csgsim::plots {

namespace {

constexpr double tick_length = 5;
constexpr double tick_gap = 4;          ///< pixels from a tick to its text
constexpr double tick_text_gap = 8;     ///< minimum number of pixels between two texts
constexpr double pixels_per_tick = 34;  ///< minimum vertical distance of ticks
constexpr unsigned max_x_ticks = 9;
constexpr double max_upright_width = 170;
constexpr double max_level_width = 150;

struct XTick {
  Pixel at;
  std::string text;
};

/// The texts of the ticks, horizontal or rotated.
std::vector<Text> tick_texts(const std::vector<XTick>& ticks, bool is_upright) {
  std::vector<std::string> words;
  words.reserve(ticks.size());
  for (const XTick& tick : ticks) words.push_back(tick.text);
  words = shorten(words, is_upright ? max_upright_width : max_level_width);
  std::vector<Text> texts;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    const double below = tick_length + tick_gap + (is_upright ? 0 : line_height / 2);
    texts.push_back(
        {words[i], {ticks[i].at.x, ticks[i].at.y + below}, is_upright ? Anchor::right : Anchor::centre, is_upright});
  }
  return texts;
}

/// The texts that fit in the picture without overlap, chosen from left to right.
std::vector<Text> fitting(const std::vector<Text>& texts, bool is_upright, double right_edge) {
  std::vector<Text> kept;
  double end = 0;
  for (const Text& text : texts) {
    const Box box = bounding_box(text);
    const double room = is_upright ? 0 : tick_text_gap;
    if (box.left < end || box.right > right_edge) continue;
    kept.push_back(text);
    end = box.right + room;
  }
  return kept;
}

}  // namespace

void add_title(Drawing& drawing, const std::string& title) {
  drawing.texts.push_back(
      {shorten(title, drawing.width - 2 * side_margin), {drawing.width / 2, title_height / 2}, Anchor::centre});
}

std::vector<Tick> make_y_ticks(const Axis& axis, const Extent& extent, double pixels) {
  return axis.ticks.empty() ? extent.ticks(std::max(3U, static_cast<unsigned>(pixels / pixels_per_tick)), axis.is_whole)
                            : axis.ticks;
}

std::vector<Tick> make_x_ticks(const Axis& axis, const Extent& extent) {
  return axis.ticks.empty() ? extent.ticks(max_x_ticks, axis.is_whole) : axis.ticks;
}

double add_x_axis(Drawing& drawing, const Axis& axis, const Extent& extent, const Box& area) {
  std::vector<XTick> ticks;
  for (const Tick& tick : make_x_ticks(axis, extent))
    ticks.push_back(
        {{area.left + extent.fraction_along(tick.value) * (area.right - area.left), area.bottom}, tick.text});
  std::ranges::stable_sort(ticks, {}, [](const XTick& tick) { return tick.at.x; });
  std::vector<Text> texts = fitting(tick_texts(ticks, false), false, drawing.width);
  if (axis.is_names && texts.size() < ticks.size()) texts = fitting(tick_texts(ticks, true), true, drawing.width);
  double bottom = area.bottom + tick_length + tick_gap;
  for (const XTick& tick : ticks)
    drawing.lines.push_back({{tick.at, {tick.at.x, tick.at.y + tick_length}}, palette::ink});
  for (Text& text : texts) {
    bottom = std::max(bottom, bounding_box(text).bottom);
    drawing.texts.push_back(std::move(text));
  }
  const double middle = (area.left + area.right) / 2;
  drawing.texts.push_back({shorten(axis.title, 2 * (drawing.width - side_margin - middle)),
                           {middle, bottom + 6 + line_height / 2},
                           Anchor::centre});
  return bottom + line_height + 14;
}

double y_axis_width(const Axis& axis, const std::vector<Tick>& ticks, double pixels) {
  const auto lines = static_cast<double>(split_lines(axis.title, pixels).size());
  double widest = 0;
  for (const Tick& tick : ticks) widest = std::max(widest, text_width(tick.text));
  return side_margin + lines * line_height + 10 + widest + tick_gap + tick_length;
}

void add_y_axis(Drawing& drawing, const Axis& axis, const Extent& extent, const Box& area) {
  for (const Tick& tick : make_y_ticks(axis, extent, area.bottom - area.top)) {
    const double y = area.bottom - extent.fraction_along(tick.value) * (area.bottom - area.top);
    drawing.lines.push_back({{{area.left - tick_length, y}, {area.left, y}}, palette::ink});
    drawing.texts.push_back({tick.text, {area.left - tick_length - tick_gap, y}, Anchor::right});
  }
  double x = side_margin + line_height / 2;
  for (const std::string& line : split_lines(axis.title, area.bottom - area.top)) {
    drawing.texts.push_back({line, {x, (area.top + area.bottom) / 2}, Anchor::centre, true});
    x += line_height;
  }
}

void add_grid(Drawing& drawing, const std::vector<Tick>& x_ticks, const Extent& x, const std::vector<Tick>& y_ticks,
              const Extent& y, const Box& area) {
  for (const Tick& tick : x_ticks) {
    const double at = area.left + x.fraction_along(tick.value) * (area.right - area.left);
    drawing.lines.push_back({{{at, area.top}, {at, area.bottom}}, palette::grid});
  }
  for (const Tick& tick : y_ticks) {
    const double at = area.bottom - y.fraction_along(tick.value) * (area.bottom - area.top);
    drawing.lines.push_back({{{area.left, at}, {area.right, at}}, palette::grid});
  }
  drawing.lines.push_back({{{area.left, area.top},
                            {area.right, area.top},
                            {area.right, area.bottom},
                            {area.left, area.bottom},
                            {area.left, area.top}},
                           palette::ink});
}

}  // namespace csgsim::plots

#include "sim/plots/svg.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <span>

#include "hw/base/markup.h"
#include "sim/plots/text_size.h"

namespace csgsim::plots {

namespace {

using palette::Mark;

/// Pixels, rounded to a hundredth.
std::string number(double pixels) { return fmt::format("{:.6g}", std::round(100 * pixels) / 100 + 0.0); }

std::string with_tip(const std::string& shape, const std::string& tip) {
  return tip.empty() ? shape : fmt::format("<g class=\"pt\"><title>{}</title>{}</g>", markup_text(tip), shape);
}

std::string fill_svg(const Fill& fill) {
  const Box& box = fill.box;
  return with_tip(fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>", number(box.left),
                              number(box.top), number(box.right - box.left), number(box.bottom - box.top), fill.colour),
                  fill.tip);
}

/// Converts the dash of a look, in half pixels, to a dash array.
std::string dash_svg(std::string_view dash) {
  if (dash.empty()) return "";
  std::string pixels;
  const char* const end = dash.data() + dash.size();
  for (const char* at = dash.data(); at < end; ++at) {
    unsigned halves = 0;
    at = std::from_chars(at, end, halves).ptr;
    pixels += fmt::format("{}{:g}", pixels.empty() ? "" : " ", halves / 2.0);
  }
  return fmt::format(" stroke-dasharray=\"{}\"", pixels);
}

std::string path_of(std::span<const Pixel> points) {
  std::string path;
  for (const Pixel& point : points) path += (path.empty() ? "M" : "L") + number(point.x) + " " + number(point.y);
  return path;
}

std::string line_svg(const Line& line) {
  const std::string width = line.width == 1 ? "" : fmt::format(" stroke-width=\"{}\"", number(line.width));
  return with_tip(
      fmt::format("<path d=\"{}\" stroke=\"{}\"{}{}/>", path_of(line.points), line.colour, width, dash_svg(line.dash)),
      line.tip);
}

constexpr std::array square{Pixel{-1, -1}, Pixel{1, -1}, Pixel{1, 1}, Pixel{-1, 1}};
constexpr std::array up{Pixel{0, -1.33}, Pixel{1.22, 0.89}, Pixel{-1.22, 0.89}};
constexpr std::array down{Pixel{0, 1.33}, Pixel{1.22, -0.89}, Pixel{-1.22, -0.89}};
constexpr std::array diamond{Pixel{0, -1.25}, Pixel{1.25, 0}, Pixel{0, 1.25}, Pixel{-1.25, 0}};
constexpr std::array pentagon{Pixel{0, 1.22}, Pixel{1.16, 0.38}, Pixel{0.72, -0.99}, Pixel{-0.72, -0.99},
                              Pixel{-1.16, 0.38}};

/// Corners of a mark relative to its centre, in units of half its size; empty for a round mark.
std::span<const Pixel> corners_of(Mark form) {
  switch (form) {
    case Mark::square:
    case Mark::box: return square;
    case Mark::up: return up;
    case Mark::down: return down;
    case Mark::diamond: return diamond;
    case Mark::pentagon: return pentagon;
    case Mark::disc:
    case Mark::ring: break;
  }
  return {};
}

std::string mark_svg(const plots::Mark& mark) {
  const bool is_hollow = mark.form == Mark::ring || mark.form == Mark::box;
  const std::string paint = is_hollow ? fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"", mark.colour)
                                      : fmt::format("fill=\"{}\"", mark.colour);
  const double half = mark.size / 2;
  std::vector<Pixel> corners;
  for (const Pixel& corner : corners_of(mark.form))
    corners.push_back({mark.at.x + half * corner.x, mark.at.y + half * corner.y});
  if (!corners.empty()) return with_tip(fmt::format("<path d=\"{}Z\" {}/>", path_of(corners), paint), mark.tip);
  return with_tip(fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>", number(mark.at.x), number(mark.at.y),
                              number(half), paint),
                  mark.tip);
}

std::string_view anchor_word(Anchor anchor) {
  switch (anchor) {
    case Anchor::left: return "start";
    case Anchor::centre: return "middle";
    case Anchor::right: return "end";
  }
  return "";
}

std::string text_svg(const Text& text) {
  constexpr double baseline = 0.325 * font_size;  ///< from the middle of the capitals down
  const std::string x = number(text.at.x);
  const std::string turn = text.is_upright ? fmt::format(" transform=\"rotate(-90 {} {})\"", x, number(text.at.y)) : "";
  return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" fill=\"{}\"{}>{}</text>", x,
                     number(text.at.y + baseline), anchor_word(text.anchor), text.colour, turn, markup_text(text.text));
}

template <class Item>
std::string group_svg(std::string_view attributes, const std::vector<Item>& items, std::string (*svg_of)(const Item&)) {
  std::string svg = fmt::format("<g {}>\n", attributes);
  for (const Item& item : items) svg += svg_of(item) + "\n";
  return svg + "</g>\n";
}

}  // namespace

std::string svg_element(const Drawing& drawing, std::string_view attributes) {
  const std::string width = number(drawing.width);
  const std::string height = number(drawing.height);
  return fmt::format("<svg {} viewBox=\"0 0 {} {}\">\n<rect width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", attributes,
                     width, height, width, height, palette::paper) +
         group_svg(fmt::format("class=\"fills\" stroke=\"{}\"", palette::ink), drawing.fills, fill_svg) +
         group_svg("class=\"lines\" fill=\"none\"", drawing.lines, line_svg) +
         group_svg("class=\"marks\"", drawing.marks, mark_svg) +
         group_svg(fmt::format("font-family=\"sans-serif\" font-size=\"{}\"", font_size), drawing.texts, text_svg) +
         "</svg>\n";
}

std::string svg_file(const Drawing& drawing) {
  return svg_element(drawing, fmt::format("xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\"",
                                          number(drawing.width), number(drawing.height)));
}

}  // namespace csgsim::plots

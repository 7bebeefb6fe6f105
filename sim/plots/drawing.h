// Geometric primitives of a plot: boxes, segments, lines, marks and texts with positions in pixels.
// Used by the layouts, and by the SVG and gnuplot writers.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/plots/palette.h"

namespace csgsim::plots {

/// A position in a picture: pixels from its left and top edges.
struct Pixel {
  double x = 0;
  double y = 0;

  bool operator==(const Pixel&) const = default;
};

struct Box {
  double left = 0;
  double top = 0;
  double right = 0;
  double bottom = 0;

  bool operator==(const Box&) const = default;
};

[[nodiscard]] bool boxes_overlap(const Box& one, const Box& other);
[[nodiscard]] bool is_within(const Box& inner, const Box& outer);
/// The square with centre `middle` and sides of 2 * half_side pixels.
[[nodiscard]] Box square_around(const Pixel& middle, double half_side);

/// A straight line between two points.
struct Segment {
  Pixel from;
  Pixel to;

  bool operator==(const Segment&) const = default;
};

/// Whether part of a segment lies inside a box.
[[nodiscard]] bool segment_meets_box(const Segment& segment, const Box& box);
[[nodiscard]] bool segments_cross(const Segment& one, const Segment& other);

struct Line {
  std::vector<Pixel> points;
  std::string_view colour;
  double width = 1;
  std::string_view dash{};  ///< format as in palette::Look
  std::string tip{};
};

struct Fill {
  Box box;
  std::string_view colour;
  std::string tip{};
};

struct Mark {
  Pixel at;
  palette::Mark form = palette::Mark::disc;
  std::string_view colour;
  double size = 8;  ///< diameter in pixels
  std::string tip{};
};

enum class Anchor : std::uint8_t { left, centre, right };

struct Text {
  std::string text;
  Pixel at;  ///< position of the anchor, at half the height of the line
  Anchor anchor = Anchor::left;
  bool is_upright = false;  ///< rotated by 90 degrees about `at`, read from bottom to top
  std::string_view colour = palette::ink;
};

/// Upper bound of the area that the text covers.
[[nodiscard]] Box bounding_box(const Text& text);

/// A picture ready to be drawn: fills below lines below marks below texts. File formats with tooltips show the tips.
struct Drawing {
  double width = 0;
  double height = 0;
  std::vector<Fill> fills;
  std::vector<Line> lines;
  std::vector<Mark> marks;
  std::vector<Text> texts;
};

}  // namespace csgsim::plots

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/plots/palette.h"

namespace csgsim::plots {

/// A place in a picture: pixels from its left and upper edges.
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

[[nodiscard]] bool overlap(const Box& one, const Box& other);
[[nodiscard]] bool is_within(const Box& inner, const Box& outer);
[[nodiscard]] Box around(const Pixel& middle, double half);

/// From one place straight to another.
struct Segment {
  Pixel from;
  Pixel to;

  bool operator==(const Segment&) const = default;
};

/// Whether some of a segment is inside of a box.
[[nodiscard]] bool meets(const Segment& segment, const Box& box);
[[nodiscard]] bool cross(const Segment& one, const Segment& other);

struct Line {
  std::vector<Pixel> points;
  std::string_view colour;
  double width = 1;
  std::string_view dash{};  ///< as palette::Look has it
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
  double size = 8;  ///< pixels across
  std::string tip{};
};

enum class Anchor : std::uint8_t { left, centre, right };

struct Text {
  std::string text;
  Pixel at;  ///< halfway up its line, at the anchor
  Anchor anchor = Anchor::left;
  bool is_upright = false;  ///< read from below, turned about `at`
  std::string_view colour = palette::ink;
};

/// What the text takes up, at most.
[[nodiscard]] Box box_of(const Text& text);

/// A picture ready to be drawn: fills below lines below marks below texts. What has a tip tells it where it is pointed
/// at, in files that can.
struct Drawing {
  double width = 0;
  double height = 0;
  std::vector<Fill> fills;
  std::vector<Line> lines;
  std::vector<Mark> marks;
  std::vector<Text> texts;
};

}  // namespace csgsim::plots

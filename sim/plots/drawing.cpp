#include "sim/plots/drawing.h"

#include <algorithm>

#include "sim/plots/text_size.h"

namespace csgsim::plots {

namespace {

/// Positive if c is to the left of the line from a to b.
double side(const Pixel& a, const Pixel& b, const Pixel& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

}  // namespace

bool boxes_overlap(const Box& one, const Box& other) {
  return one.left < other.right && other.left < one.right && one.top < other.bottom && other.top < one.bottom;
}

bool is_within(const Box& inner, const Box& outer) {
  return inner.left >= outer.left && inner.right <= outer.right && inner.top >= outer.top &&
         inner.bottom <= outer.bottom;
}

Box square_around(const Pixel& middle, double half_side) {
  return {middle.x - half_side, middle.y - half_side, middle.x + half_side, middle.y + half_side};
}

bool segment_meets_box(const Segment& segment, const Box& box) {
  // Liang-Barsky: clips the segment against each pair of edges.
  double begin = 0;
  double end = 1;
  const auto cut = [&](double from, double way, double low, double high) {
    if (way == 0) return from > low && from < high;
    const auto [first, last] = std::minmax({(low - from) / way, (high - from) / way});
    begin = std::max(begin, first);
    end = std::min(end, last);
    return begin < end;
  };
  if (segment.from == segment.to)
    return segment.from.x > box.left && segment.from.x < box.right && segment.from.y > box.top &&
           segment.from.y < box.bottom;
  return cut(segment.from.x, segment.to.x - segment.from.x, box.left, box.right) &&
         cut(segment.from.y, segment.to.y - segment.from.y, box.top, box.bottom);
}

bool segments_cross(const Segment& one, const Segment& other) {
  return side(one.from, one.to, other.from) * side(one.from, one.to, other.to) < 0 &&
         side(other.from, other.to, one.from) * side(other.from, other.to, one.to) < 0;
}

Box bounding_box(const Text& text) {
  const double width = text_width(text.text);
  const double before = text.anchor == Anchor::left ? 0 : text.anchor == Anchor::centre ? width / 2 : width;
  const double half_side = line_height / 2;
  if (text.is_upright)
    return {text.at.x - half_side, text.at.y - (width - before), text.at.x + half_side, text.at.y + before};
  return {text.at.x - before, text.at.y - half_side, text.at.x - before + width, text.at.y + half_side};
}

}  // namespace csgsim::plots

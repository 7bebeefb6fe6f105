#include "sim/software/convert/crossings.h"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>
#include <vector>

#include "sim/software/convert/near_points.h"
#include "sim/software/convert/seen.h"
#include "sim/software/convert/sides.h"

namespace csgsim::software::convert {

namespace {

using Point = ProjectionKernel::Point_2;

/// Finds intersections of the sides of an outline.
class Crossings {
 public:
  explicit Crossings(std::vector<glm::dvec3>& points) : points_(points) {}

  void find(const Outline& outline) {
    const PlaneProjection seen(points_, outline.outward);
    std::vector<Seg> segments;
    for (const Side& side : outline.sides) {
      const Side line{std::min(side[0], side[1]), std::max(side[0], side[1])};
      segments.push_back({line, seen(line[0]), seen(line[1])});
    }
    std::ranges::sort(segments, {}, &Seg::left);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      std::erase_if(open, [&](std::size_t other) { return segments[other].right() < segments[i].left(); });
      for (const std::size_t other : open) look_at(segments[i], segments[other]);
      open.push_back(i);
    }
  }

  /// The points on each line, sorted along it; lines run from the lower to the higher point index.
  [[nodiscard]] std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> points_by_line() {
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> lines;
    for (auto& [key, found] : found_) {
      std::sort(found.begin(), found.end());
      for (const PointAlong& one : found) {
        std::vector<std::uint32_t>& line = lines[key];
        if (line.empty() || line.back() != one.point) line.push_back(one.point);
      }
    }
    return lines;
  }

 private:
  struct Seg {
    Side line{};
    Point from;
    Point to;

    [[nodiscard]] double left() const { return std::min(from.x(), to.x()); }
    [[nodiscard]] double right() const { return std::max(from.x(), to.x()); }
  };

  void look_at(const Seg& one, const Seg& other) {
    if (one.line == other.line) return;
    if (std::max(one.from.y(), one.to.y()) < std::min(other.from.y(), other.to.y())) return;
    if (std::max(other.from.y(), other.to.y()) < std::min(one.from.y(), one.to.y())) return;
    for (const auto& [point, place] : {std::pair(other.line[0], other.from), std::pair(other.line[1], other.to)})
      add_if_on(one, point, place);
    for (const auto& [point, place] : {std::pair(one.line[0], one.from), std::pair(one.line[1], one.to)})
      add_if_on(other, point, place);
    const auto turn = [](const Seg& seg, const Point& place) {
      return static_cast<int>(CGAL::orientation(seg.from, seg.to, place));
    };
    if (turn(one, other.from) * turn(one, other.to) >= 0 || turn(other, one.from) * turn(other, one.to) >= 0) return;
    const double along_one = part_before(one, other);
    const double along_other = part_before(other, one);
    const auto added = static_cast<std::uint32_t>(points_.size());
    points_.push_back((at(one, along_one) + at(other, along_other)) / 2.0);
    found_[key_of(one.line)].push_back({along_one, added});
    found_[key_of(other.line)].push_back({along_other, added});
  }

  void add_if_on(const Seg& seg, std::uint32_t point, const Point& place) {
    if (point == seg.line[0] || point == seg.line[1]) return;
    if (!CGAL::are_strictly_ordered_along_line(seg.from, place, seg.to)) return;
    const ProjectionKernel::Vector_2 way = seg.to - seg.from;
    found_[key_of(seg.line)].push_back({((place - seg.from) * way) / way.squared_length(), point});
  }

  /// Fraction of a line before another line that crosses it; 0.5 if rounding makes them parallel.
  static double part_before(const Seg& line, const Seg& other) {
    const ProjectionKernel::Vector_2 across = other.to - other.from;
    const double start = CGAL::determinant(across, line.from - other.from);
    const double end = CGAL::determinant(across, line.to - other.from);
    return start == end ? 0.5 : std::clamp(start / (start - end), 0.0, 1.0);
  }

  [[nodiscard]] glm::dvec3 at(const Seg& seg, double along) const {
    return points_[seg.line[0]] + along * (points_[seg.line[1]] - points_[seg.line[0]]);
  }

  std::vector<glm::dvec3>& points_;
  std::unordered_map<std::uint64_t, std::vector<PointAlong>> found_;
};

}  // namespace

bool try_split_at_crossings(std::span<const std::size_t> outline_indices, Outlines& outlines) {
  Crossings crossings(outlines.points);
  for (const std::size_t one : outline_indices) crossings.find(outlines.outlines[one]);
  const PointsOnSides ends = crossings.points_by_line();
  for (Outline& outline : outlines.outlines) try_split_sides(ends, outline.sides);
  return !ends.empty();
}

}  // namespace csgsim::software::convert

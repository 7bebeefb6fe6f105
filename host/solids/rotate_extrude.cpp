#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "host/flat/parts.h"
#include "host/model/degrees.h"
#include "host/model/fragments.h"
#include "host/model/hypotenuse.h"
#include "host/solids/axis_parts.h"
#include "host/solids/extrusion.h"
#include "host/solids/limits.h"
#include "host/solids/side_lines.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

/// Corners closer to the axis than this, in units of the farthest corner's distance, are treated as on it.
constexpr double axis_tolerance = double_precision_tolerance;

/// Directions of the copies of the profile, counter-clockwise.
struct Turn {
  std::vector<double> angles;  ///< degrees, ascending; for a full turn the last direction equals the first
  bool is_full = false;

  [[nodiscard]] std::uint32_t segments() const { return static_cast<std::uint32_t>(angles.size()) - 1; }
};

/// The range of x, including 0. Throws InputError, with OpenSCAD's message, if the area is on both sides of the axis.
std::pair<double, double> x_range(const flat::Area& area) {
  double least = 0;
  double greatest = 0;
  for (const flat::Outline& outline : area.outlines) {
    for (const glm::dvec2& corner : outline) {
      least = std::min(least, corner.x);
      greatest = std::max(greatest, corner.x);
      if (greatest - least > greatest && greatest - least > std::abs(least)) {
        throw InputError(
            fmt::format("all points for rotate_extrude() must have the same X coordinate sign (range is {:.2f} -> "
                        "{:.2f}); move the "
                        "profile to one side of the Y axis, or cut it there",
                        least, greatest));
      }
    }
  }
  return {least, greatest};
}

/// The part of the area to the right of the axis; an area on the left is mirrored first.
flat::Area right_of_axis(const flat::Area& area, bool is_left, double radius) {
  flat::Area result = area;
  for (flat::Outline& outline : result.outlines) {
    for (glm::dvec2& corner : outline)
      corner.x = std::abs(corner.x) <= axis_tolerance * radius ? 0 : std::abs(corner.x);
    if (is_left) std::reverse(outline.begin(), outline.end());
  }
  return result;
}

Turn make_turn(const RotateExtrude& extrusion, double radius, bool is_left) {
  const double angle = extrusion.angle <= -360.0 || extrusion.angle > 360.0 ? 360.0 : extrusion.angle;
  const double around = model::fragments(radius, extrusion.facets);
  const auto count = static_cast<std::uint32_t>(std::max(around * std::abs(angle) / 360.0, 1.0));
  Turn turn;
  turn.is_full = angle == 360.0;
  // A full turn starts on the negative x axis.
  const double start = (turn.is_full ? 180.0 : 0.0) + (is_left ? 180.0 : 0.0);
  for (std::uint32_t i = 0; i <= count; ++i) turn.angles.push_back(start + i * angle / count);
  if (angle < 0.0) std::reverse(turn.angles.begin(), turn.angles.end());
  // Between two copies, straight sides pass the axis on the side where the copies are less than half a turn apart.
  const double wide = turn.angles.back() - turn.angles.front();
  if (count == 1 && wide >= 180.0) {
    if (wide == 180.0) return {};
    turn.angles = {turn.angles.back(), turn.angles.front() + 360.0};
  }
  return turn;
}

glm::dvec2 direction(double degrees) { return {model::cos_degrees(degrees), model::sin_degrees(degrees)}; }

/// Rotates convex parts of a profile about the axis.
class Lathe {
 public:
  Lathe(const flat::Area& area, Turn turn) : turn_(std::move(turn)), lines_(area) {
    for (const double angle : turn_.angles) directions_.push_back(direction(angle));
    if (turn_.is_full) directions_.back() = directions_.front();
  }

  std::vector<model::Polyhedron> operator()(const std::vector<flat::Outline>& parts) {
    for (const flat::Outline& part : parts) {
      for (std::uint32_t first = 0; first < turn_.segments();) {
        const std::uint32_t count = sweeps_convex(part) ? convex_run(first) : 1;
        piece(part, first, count);
        first += count;
      }
    }
    return std::move(pieces_);
  }

  /// Number of faces that operator() makes for the parts.
  std::size_t cost(const std::vector<flat::Outline>& parts) {
    std::size_t faces = 0;
    for (const flat::Outline& part : parts) {
      faces += turn_.segments() * (sweeps_convex(part) ? part.size() - 1 : part.size() + 2);
    }
    return faces;
  }

 private:
  /// Whether the part stays convex when rotated by any angle up to 180 degrees or by a full turn: one side is on the
  /// axis, and no other side faces the axis.
  bool sweeps_convex(const flat::Outline& part) {
    bool touches = false;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const glm::dvec2& a = part[i];
      const glm::dvec2& b = part[(i + 1) % part.size()];
      const bool is_on_axis = a.x == 0.0 && b.x == 0.0;
      touches = touches || is_on_axis;
      if (!is_on_axis && lines_(a, b).x < 0.0) return false;
    }
    return touches;
  }

  /// The number of segments from `first` on whose union is convex: a full turn, or at most half a turn.
  [[nodiscard]] std::uint32_t convex_run(std::uint32_t first) const {
    if (turn_.is_full) return turn_.segments();
    std::uint32_t count = 1;
    while (first + count < turn_.segments() && turn_.angles[first + count + 1] - turn_.angles[first] <= 180.0) ++count;
    return count;
  }

  void piece(const flat::Outline& part, std::uint32_t first, std::uint32_t count) {
    first_ = first;
    count_ = count;
    closed_ = turn_.is_full && count == turn_.segments();
    piece_ = {};
    rings_.clear();
    for (const glm::dvec2& corner : part) add_ring(corner);
    for (std::size_t i = 0; i < part.size(); ++i) add_sides(part, i, (i + 1) % part.size());
    if (!closed_) add_ends();
    pieces_.push_back(std::move(piece_));
    if (pieces_.size() > Limits{}.max_pieces) {
      throw InputError("rotate_extrude() needs more than " + std::to_string(Limits{}.max_pieces) +
                       " convex pieces; use fewer fragments ($fn, $fa or $fs)");
    }
  }

  /// Adds the points of a corner, one per direction; a corner on the axis has only one point.
  void add_ring(const glm::dvec2& corner) {
    std::vector<std::uint32_t> ring;
    for (std::uint32_t i = 0; i <= count_; ++i) {
      const bool is_first_again = closed_ && i == count_;
      if (i == 0 || (corner.x != 0.0 && !is_first_again)) {
        piece_.points.emplace_back(corner.x * directions_[first_ + i], corner.y);
      }
      ring.push_back(is_first_again ? ring.front() : static_cast<std::uint32_t>(piece_.points.size()) - 1);
    }
    rings_.push_back(std::move(ring));
  }

  void add_face(std::vector<std::uint32_t> corners, const glm::dvec4& plane) {
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    if (corners.front() == corners.back()) corners.pop_back();
    piece_.faces.push_back(std::move(corners));
    piece_.planes.push_back(plane);
  }

  void add_sides(const flat::Outline& part, std::size_t a, std::size_t b) {
    if (part[a].x == 0.0 && part[b].x == 0.0) return;
    const glm::dvec3 line = lines_(part[a], part[b]);
    if (line.x == 0.0) {
      add_level(a, b, glm::dvec4(0, 0, line.y, line.z));
      return;
    }
    for (std::uint32_t i = 0; i < count_; ++i) {
      add_face({rings_[a][i], rings_[a][i + 1], rings_[b][i + 1], rings_[b][i]}, side_plane(line, first_ + i));
    }
  }

  /// Adds the face swept by a horizontal side.
  void add_level(std::size_t a, std::size_t b, const glm::dvec4& plane) {
    std::vector<std::uint32_t> corners;
    const auto add = [&](std::uint32_t point) {
      const bool is_inside = closed_ && piece_.points[point].x == 0.0 && piece_.points[point].y == 0.0;
      if (!is_inside) corners.push_back(point);
    };
    std::for_each(rings_[a].begin(), rings_[a].end(), add);
    std::for_each(rings_[b].rbegin(), rings_[b].rend(), add);
    add_face(std::move(corners), plane);
  }

  /// The plane swept by a side of the profile in one segment. It is closer to the axis in the middle of the segment,
  /// because the segment is a chord.
  [[nodiscard]] glm::dvec4 side_plane(const glm::dvec3& line, std::uint32_t segment) const {
    const double from = turn_.angles[segment];
    const double to = turn_.angles[segment + 1];
    const double inset = model::cos_degrees((to - from) / 2.0);
    const double length = model::hypotenuse(line.x, line.y * inset);
    return glm::dvec4(line.x * direction((from + to) / 2.0), line.y * inset, line.z * inset) / length;
  }

  void add_ends() {
    const glm::dvec2& low = directions_[first_];
    const glm::dvec2& high = directions_[first_ + count_];
    std::vector<std::uint32_t> start;
    std::vector<std::uint32_t> end;
    for (const std::vector<std::uint32_t>& ring : rings_) {
      start.push_back(ring.front());
      end.push_back(ring.back());
    }
    std::reverse(end.begin(), end.end());
    add_face(std::move(start), glm::dvec4(low.y, -low.x, 0, 0));
    add_face(std::move(end), glm::dvec4(-high.y, high.x, 0, 0));
  }

  Turn turn_;
  SideLines lines_;
  std::vector<glm::dvec2> directions_;
  std::vector<model::Polyhedron> pieces_;

  // State of the piece under construction.
  std::uint32_t first_ = 0;  ///< first segment
  std::uint32_t count_ = 0;  ///< number of segments
  bool closed_ = false;
  model::Polyhedron piece_;
  std::vector<std::vector<std::uint32_t>> rings_;
};

}  // namespace

std::vector<model::Polyhedron> rotate_extrude(const flat::Area& area, const RotateExtrude& extrusion) {
  if (area.empty() || extrusion.angle == 0.0) return {};
  const auto [least, greatest] = x_range(area);
  const double radius = greatest - least;
  const bool is_left = -least > greatest;
  Turn turn = make_turn(extrusion, radius, is_left);
  if (turn.angles.empty()) return {};
  const flat::Area profile = right_of_axis(area, is_left, radius);
  Lathe lathe(profile, std::move(turn));
  const std::vector<flat::Outline> any = flat::convex_parts(profile);
  const std::vector<flat::Outline> stacked = axis_parts(profile);
  return lathe(lathe.cost(stacked) < lathe.cost(any) ? stacked : any);
}

}  // namespace csgsim::solids

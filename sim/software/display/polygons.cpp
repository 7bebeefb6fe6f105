#include "sim/software/display/polygons.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <utility>

#include "host/convex/clip.h"
#include "sim/software/methods/counts.h"

namespace csgsim::software {

namespace {

constexpr unsigned most_cell_levels = 18;

/// Heights of corners over a plane: three products of longs each, of four products of words.
template <class Count>
void count_heights(Count& count, std::size_t corners) {
  count(Operation::load_long, 6 * corners);
  count(Operation::multiply, 12 * corners);
  count(Operation::add_long, 15 * corners);
  count(Operation::compare_long, 2 * corners);
  count(Operation::branch, 2 * corners);
  count(Operation::branch_taken, corners);
}

/// Corners where edges cross a plane: a quotient of two digits, three products.
template <class Count>
void count_crossings(Count& count, std::size_t crossings) {
  count(Operation::divide, 2 * crossings);
  count(Operation::multiply, (2 + 12) * crossings);
  count(Operation::add_long, (2 + 18) * crossings);
  count(Operation::load_long, 8 * crossings);
  count(Operation::store_long, 3 * crossings);
}

/// Which sides of a plane points are on.
struct Sides {
  bool above = false;
  bool below = false;

  [[nodiscard]] bool both() const { return above && below; }
};

bool overlap(const facet::Box& a, const facet::Box& b, double tolerance) {
  return a.low.x <= b.high.x + tolerance && b.low.x <= a.high.x + tolerance && a.low.y <= b.high.y + tolerance &&
         b.low.y <= a.high.y + tolerance && a.low.z <= b.high.z + tolerance && b.low.z <= a.high.z + tolerance;
}

/// A part of a line, by how far along it.
struct Along {
  double first = std::numeric_limits<double>::infinity();
  double last = -std::numeric_limits<double>::infinity();
};

template <class Count>
class Clipper {
 public:
  Clipper(const Facets& facets, const facet::Geometry& geometry, std::size_t bucket_size, Count& count)
      : facets_(facets),
        planes_(geometry.planes.planes()),
        tolerance_(convex::tolerance(geometry.planes)),
        bucket_size_(bucket_size),
        count_(count) {
    made_.canonical_planes = planes_.size();
  }

  Polygons made() {
    std::vector<Piece> pieces;
    facet::Box box;
    for (std::uint32_t facet = 0; facet < facets_.facets.size(); ++facet) {
      pieces.push_back(whole(facet));
      box = facet::hull(box, pieces.back().box);
    }
    made_.cells.push_back({box});
    fill(0, 0, std::move(pieces));
    return std::move(made_);
  }

 private:
  Piece whole(std::uint32_t facet) {
    const std::span<const glm::dvec3> corners = facets_.corners_of(facet);
    Piece piece{facet, {corners.begin(), corners.end()}, {}, facet::box_of(corners)};
    if (!corners.empty()) return piece;
    // It has no place of its own, and is where its primitive is.
    const std::uint32_t primitive = facets_.facets[facet].primitive;
    for (std::size_t i = facets_.of_primitives[primitive]; i < facets_.of_primitives[primitive + 1]; ++i) {
      const std::span<const glm::dvec3> others = facets_.corners_of(static_cast<std::uint32_t>(i));
      if (others.empty()) continue;
      piece.corners = {others.front()};
      piece.box = {others.front(), others.front()};
      return piece;
    }
    piece.corners = {glm::dvec3{0}};
    piece.box = {glm::dvec3{0}, glm::dvec3{0}};
    return piece;
  }

  void fill(std::uint32_t cell, unsigned level, std::vector<Piece> pieces) {
    if (pieces.size() <= bucket_size_ || level == most_cell_levels) clip_each_other(pieces);
    count_(Operation::compare, 2);
    count_(Operation::branch, 2);
    if (pieces.size() <= bucket_size_ || level == most_cell_levels) {
      count_(Operation::store_long, pieces.size());
      made_.cells[cell].bucket = std::move(pieces);
      return;
    }
    halve(cell, level, std::move(pieces));
  }

  void halve(std::uint32_t cell, unsigned level, std::vector<Piece> pieces) {
    const auto axis = static_cast<glm::length_t>(level % 3);
    facet::Box low = made_.cells[cell].box;
    facet::Box high = low;
    const double middle = low.low[axis] + (low.high[axis] - low.low[axis]) / 2.0;
    low.high[axis] = high.low[axis] = middle;
    facet::Plane wall{glm::dvec3{0}, -middle};
    wall.normal[axis] = 1.0;
    const auto number = static_cast<std::uint32_t>(made_.walls.size());
    made_.walls.push_back(wall);
    std::vector<Piece> below;
    std::vector<Piece> above;
    for (Piece& piece : pieces) share(std::move(piece), number, below, above);
    const auto first = static_cast<std::uint32_t>(made_.cells.size());
    made_.cells[cell].wall = number;
    made_.cells[cell].low = first;
    made_.cells[cell].high = first + 1;
    made_.cells.push_back({low});
    made_.cells.push_back({high});
    fill(first, level + 1, std::move(below));
    fill(first + 1, level + 1, std::move(above));
  }

  /// Puts a piece, or its parts, on the sides of a wall.
  void share(Piece piece, std::uint32_t wall, std::vector<Piece>& below, std::vector<Piece>& above) {
    const facet::Plane& plane = made_.walls[wall];
    count_(Operation::load_long, 2);
    count_(Operation::compare_long, 2);
    count_(Operation::branch, 2);
    if (piece.corners.size() < 3) {
      glm::dvec3 middle{0};
      for (const glm::dvec3& corner : piece.corners) middle += corner / static_cast<double>(piece.corners.size());
      (plane.height(middle) > 0.0 ? above : below).push_back(std::move(piece));
      return;
    }
    const Sides sides = sides_of(piece.corners, plane);
    if (!sides.both()) {
      (sides.above ? above : below).push_back(std::move(piece));
      return;
    }
    above.push_back(cut(piece, static_cast<std::uint32_t>(planes_.size() + wall), plane));
    below.push_back(std::move(piece));
  }

  Sides sides_of(std::span<const glm::dvec3> corners, const facet::Plane& plane) {
    Sides sides;
    for (const glm::dvec3& corner : corners) {
      const double height = plane.height(corner);
      sides.above = sides.above || height > tolerance_;
      sides.below = sides.below || height < -tolerance_;
    }
    count_heights(count_, corners.size());
    return sides;
  }

  /// Leaves what is below the plane, and returns what is above.
  Piece cut(Piece& piece, std::uint32_t number, const facet::Plane& plane) {
    Piece above{piece.facet, {}, piece.cuts, {}};
    std::vector<glm::dvec3> below;
    std::size_t crossings = 0;
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
      const glm::dvec3& here = piece.corners[i];
      const glm::dvec3& next = piece.corners[(i + 1) % piece.corners.size()];
      const double height = plane.height(here);
      const double beyond = plane.height(next);
      if (height >= -tolerance_) above.corners.push_back(here);
      if (height <= tolerance_) below.push_back(here);
      if ((height > tolerance_ && beyond < -tolerance_) || (height < -tolerance_ && beyond > tolerance_)) {
        const glm::dvec3 crossing = here + (next - here) * (height / (height - beyond));
        above.corners.push_back(crossing);
        below.push_back(crossing);
        ++crossings;
      }
    }
    count_crossings(count_, crossings);
    count_(Operation::store_long, 6 + 3 * (above.corners.size() + below.size()));
    piece.corners = std::move(below);
    piece.cuts.push_back({number, true});
    above.cuts.push_back({number, false});
    piece.box = facet::box_of(piece.corners);
    above.box = facet::box_of(above.corners);
    return above;
  }

  [[nodiscard]] std::uint32_t plane_of(const Piece& piece) const { return facets_.facets[piece.facet].halfspace.plane; }

  /// Cuts pieces of different primitives until none cross.
  void clip_each_other(std::vector<Piece>& pieces) {
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (!cross(pieces[i], pieces[j])) continue;
        const std::uint32_t of_i = plane_of(pieces[i]);
        const std::uint32_t of_j = plane_of(pieces[j]);
        Piece rest_of_i = cut(pieces[i], of_j, planes_[of_j]);
        Piece rest_of_j = cut(pieces[j], of_i, planes_[of_i]);
        pieces.push_back(std::move(rest_of_i));
        pieces.push_back(std::move(rest_of_j));
      }
    }
  }

  bool cross(const Piece& a, const Piece& b) {
    count_(Operation::load, 2);
    count_(Operation::compare);
    count_(Operation::branch);
    if (facets_.facets[a.facet].primitive == facets_.facets[b.facet].primitive) return false;
    count_(Operation::load_long, 12);
    count_(Operation::compare_long, 6);
    count_(Operation::branch, 6);
    if (a.corners.size() < 3 || b.corners.size() < 3 || !overlap(a.box, b.box, 0.0)) return false;
    const facet::Plane& of_a = planes_[plane_of(a)];
    const facet::Plane& of_b = planes_[plane_of(b)];
    if (!sides_of(a.corners, of_b).both() || !sides_of(b.corners, of_a).both()) return false;
    const glm::dvec3 line = glm::normalize(glm::cross(of_a.normal, of_b.normal));
    const Along on_a = along(a.corners, of_b, line);
    const Along on_b = along(b.corners, of_a, line);
    count_(Operation::compare_long, 2);
    count_(Operation::branch, 2);
    return std::min(on_a.last, on_b.last) - std::max(on_a.first, on_b.first) > tolerance_;
  }

  /// Where a polygon that a plane cuts meets it.
  Along along(std::span<const glm::dvec3> corners, const facet::Plane& plane, const glm::dvec3& line) {
    Along part;
    std::size_t crossings = 0;
    const auto add = [&](const glm::dvec3& point) {
      const double place = glm::dot(point, line);
      part = {std::min(part.first, place), std::max(part.last, place)};
      ++crossings;
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec3& here = corners[i];
      const glm::dvec3& next = corners[(i + 1) % corners.size()];
      const double height = plane.height(here);
      const double beyond = plane.height(next);
      if (height >= -tolerance_ && height <= tolerance_) add(here);
      if ((height > tolerance_ && beyond < -tolerance_) || (height < -tolerance_ && beyond > tolerance_))
        add(here + (next - here) * (height / (height - beyond)));
    }
    count_crossings(count_, crossings);
    count_heights(count_, crossings);
    return part;
  }

  const Facets& facets_;
  const std::vector<facet::Plane>& planes_;
  double tolerance_;
  std::size_t bucket_size_;
  Count& count_;
  Polygons made_;
};

/// Whether the picture cannot show a cell: all of it is beyond one side of what is seen, or behind the eye.
bool is_outside(const facet::Box& box, const view::EyeSpace& eye, const glm::dvec3& centre, double width,
                double height) {
  std::array<bool, 5> beyond{true, true, true, true, eye.perspective};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const glm::dvec3 point{(corner & 1U) != 0 ? box.high.x : box.low.x, (corner & 2U) != 0 ? box.high.y : box.low.y,
                           (corner & 4U) != 0 ? box.high.z : box.low.z};
    const glm::dvec3 in_eye = eye.to_eye(point + centre);
    const double unit = eye.perspective ? eye.pixel * in_eye.z : eye.pixel;
    beyond[0] = beyond[0] && in_eye.x < -(eye.middle_x + 1.0) * unit;
    beyond[1] = beyond[1] && in_eye.x > (width - eye.middle_x) * unit;
    beyond[2] = beyond[2] && in_eye.y > (eye.middle_y + 1.0) * unit;
    beyond[3] = beyond[3] && in_eye.y < -(height - eye.middle_y) * unit;
    beyond[4] = beyond[4] && in_eye.z < 0.0;
  }
  return std::ranges::any_of(beyond, [](bool is) { return is; });
}

}  // namespace

std::size_t Polygons::pieces() const {
  std::size_t sum = 0;
  for (const PolygonCell& cell : cells) {
    for (const Piece& piece : cell.bucket) sum += piece.corners.size() >= 3 ? 1U : 0U;
  }
  return sum;
}

std::size_t Polygons::filled() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(cells, [](const PolygonCell& cell) { return !cell.bucket.empty(); }));
}

template <class Count>
Polygons clipped(const Facets& facets, const facet::Geometry& geometry, std::size_t bucket_size, Count& count) {
  return Clipper<Count>(facets, geometry, bucket_size, count).made();
}

template Polygons clipped(const Facets&, const facet::Geometry&, std::size_t, CountingMethod&);
template Polygons clipped(const Facets&, const facet::Geometry&, std::size_t, UncountedMethod&);

CellOrder front_to_back(const Polygons& polygons, const view::EyeSpace& eye, const glm::dvec3& centre,
                        std::uint32_t width, std::uint32_t height) {
  CellOrder order;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    ++order.looked_at;
    const PolygonCell& cell = polygons.cells[at];
    if (is_outside(cell.box, eye, centre, width, height)) continue;
    if (cell.wall == PolygonCell::none) {
      if (!cell.bucket.empty()) order.cells.push_back(at);
      continue;
    }
    const facet::Plane& wall = polygons.walls[cell.wall];
    const bool is_low_first =
        eye.perspective ? wall.height(eye.eye - centre) < 0.0 : glm::dot(wall.normal, eye.axes.forward) > 0.0;
    open.push_back(is_low_first ? cell.high : cell.low);
    open.push_back(is_low_first ? cell.low : cell.high);
  }
  return order;
}

}  // namespace csgsim::software

#include "host/solids/bent_slices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "host/convex/clip.h"
#include "host/convex/merge.h"
#include "host/facet/planes.h"
#include "host/flat/parts.h"
#include "host/model/degrees.h"
#include "host/solids/enclosed.h"
#include "host/solids/limits.h"
#include "host/solids/partition.h"
#include "host/solids/polyhedra.h"
#include "host/solids/side_lines.h"
#include "host/solids/slice_count.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

/// A cross-section: maps the area's corners to one end of a slice.
struct SliceEnd {
  double z = 0;
  double turn = 0;  ///< degrees, clockwise
  glm::dvec2 scale{1};

  [[nodiscard]] glm::dvec2 operator()(const glm::dvec2& corner) const {
    const double sine = model::sin_degrees(turn);
    const double cosine = model::cos_degrees(turn);
    return scale * glm::dvec2(cosine * corner.x + sine * corner.y, cosine * corner.y - sine * corner.x);
  }
};

struct Slice {
  SliceEnd low;
  SliceEnd high;

  [[nodiscard]] bool has_no_top() const { return high.scale.x == 0.0 || high.scale.y == 0.0; }
  [[nodiscard]] bool ends_in_line() const { return has_no_top() && high.scale.x != high.scale.y; }
};

Slice slice_at(const LinearExtrude& extrusion, std::uint32_t index, std::uint32_t count) {
  const double start = extrusion.center ? -extrusion.height / 2.0 : 0.0;
  const double end = extrusion.center ? extrusion.height / 2.0 : extrusion.height;
  const auto level = [&](std::uint32_t i) {
    return SliceEnd{
        start + (end - start) * i / count, extrusion.twist * i / count,
        glm::dvec2(1) - (glm::dvec2(1) - extrusion.scale) * static_cast<double>(i) / static_cast<double>(count)};
  };
  return {level(index), level(index + 1)};
}

/// The surface swept by one side of the outline; `Quad` stores the lower and upper ends of that side.
struct Quad {
  glm::dvec3 low_from;
  glm::dvec3 low_to;
  glm::dvec3 high_from;
  glm::dvec3 high_to;
};

/// Whether the quad's diagonal rises along the side. OpenSCAD uses the diagonal that is shorter in plan view, but the
/// longer one below a top without area. If the lengths differ by less than 1e-5 of their mean, the twist and the kind
/// of outline decide.
bool diagonal_rises(const Quad& quad, const Slice& slice, bool is_hole) {
  constexpr double equal = 1e-5;
  const double rising = glm::length(glm::dvec2(quad.high_to) - glm::dvec2(quad.low_from));
  const double falling = glm::length(glm::dvec2(quad.high_from) - glm::dvec2(quad.low_to));
  const bool are_equal = 2.0 * std::abs(rising - falling) <= equal * (rising + falling);
  const bool turns_back = slice.high.turn <= slice.low.turn;
  const bool rises = are_equal ? is_hole == turns_back : rising < falling;
  return rises != slice.has_no_top();
}

constexpr double relative_tolerance = double_precision_tolerance;

/// Maximum difference between the volumes of the pieces and of the slice, in units of the slice's size cubed:
/// convex::clip() loses sheets thinner than 1e-10.
constexpr double volume_tolerance = 1e-8;

/// The surface of a slice as triangles and caps, and their planes.
class SliceSides {
 public:
  SliceSides(const flat::Area& area, const Slice& slice, const Work& work)
      : slice_(slice), box_(box_of(area, slice)), planes_(glm::dvec3(0), size()) {
    limits_.work = work;
    for (const flat::Outline& outline : area.outlines) add(outline);
    for (const flat::Outline& part : flat::convex_parts(area)) add_caps(part);
  }

  /// The slice's interior as convex polytopes.
  std::vector<convex::Polytope> pieces() {
    const convex::Polytope space = make_cell();
    std::optional<std::vector<convex::Polytope>> found = uncrossed(space);
    if (!found) found = enclosed(soup_, space, planes_, convex::tolerance(planes_), limits_);
    convex::merge(*found, planes_, limits_.work);
    return std::move(*found);
  }

  [[nodiscard]] const facet::PlaneTable& planes() const { return planes_; }

 private:
  struct Triangle {
    std::array<std::uint32_t, 3> corners{};
    facet::Plane plane;
    bool is_flat = true;  ///< whether the triangle has no area
  };

  /// The two triangles of a side.
  struct Pair {
    Triangle first;   ///< contains the edge that rises from the start of the side, if that triangle has area
    Triangle second;  ///< contains the edge that rises from the end of the side
    bool rises = false;
  };

  static facet::Box box_of(const flat::Area& area, const Slice& slice) {
    facet::Box box;
    for (const flat::Outline& outline : area.outlines) {
      for (const glm::dvec2& corner : outline) {
        box = facet::hull(box, glm::dvec3(slice.low(corner), slice.low.z));
        box = facet::hull(box, glm::dvec3(slice.high(corner), slice.high.z));
      }
    }
    return box;
  }

  [[nodiscard]] double size() const { return box_.diagonal(); }

  /// The pieces; empty if sides cross each other, because they then leave holes, or enclose space twice or with the
  /// wrong orientation.
  [[nodiscard]] std::optional<std::vector<convex::Polytope>> uncrossed(const convex::Polytope& space) const {
    try {
      std::vector<convex::Polytope> found = partition(soup_, space, {}, planes_, convex::tolerance(planes_), limits_);
      double sum = 0;
      for (const convex::Polytope& piece : found) sum += convex::volume(piece);
      const double most = volume_tolerance * size() * size() * size();
      if (std::abs(sum - volume()) <= most) return found;
    } catch (const WorkError&) {
      throw;
    } catch (const InputError&) {
      return std::nullopt;  // crossing sides would also give too many pieces
    }
    return std::nullopt;
  }

  /// The volume enclosed by the faces, by the divergence theorem.
  [[nodiscard]] double volume() const {
    double six_times = 0;
    for (const Fragment& fragment : soup_.fragments) {
      for_each_triangle(soup_, fragment, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
        six_times += glm::dot(a, glm::cross(b, c));
      });
    }
    return six_times / 6.0;
  }

  /// A cell around the slice, with a margin of a tenth of its size.
  convex::Polytope make_cell() {
    const double margin = 0.1 * size();
    return convex::intersection(box_, convex::add_box_halfspaces({box_.low - margin, box_.high + margin}, planes_),
                                planes_);
  }

  void add(const flat::Outline& outline) {
    const bool is_hole = signed_area(outline) < 0.0;
    const auto count = static_cast<std::uint32_t>(outline.size());
    const auto first = static_cast<std::uint32_t>(soup_.points.size());
    for (const glm::dvec2& corner : outline) {
      soup_.points.emplace_back(slice_.low(corner), slice_.low.z);
      soup_.points.emplace_back(slice_.high(corner), slice_.high.z);
    }
    std::vector<Pair> pairs;
    for (std::uint32_t i = 0; i < count; ++i) {
      pairs.push_back(pair(first + 2 * i, first + 2 * ((i + 1) % count), is_hole));
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      const Pair& before = pairs[(i + count - 1) % count];
      if (slice_.ends_in_line()) {
        emit_at_line(before, pairs[i]);
      } else {
        emit(before, pairs[i], pairs[(i + 1) % count]);
      }
    }
  }

  /// Adds one convex part of the slice's lower cap and of its upper cap. A cap without area is omitted.
  void add_caps(const flat::Outline& part) {
    std::vector<glm::dvec3> corners;
    for (const glm::dvec2& corner : part) corners.emplace_back(slice_.low(corner), slice_.low.z);
    std::reverse(corners.begin(), corners.end());
    add_cap(corners, {{0, 0, -1}, slice_.low.z});
    if (slice_.has_no_top()) return;
    corners.clear();
    for (const glm::dvec2& corner : part) corners.emplace_back(slice_.high(corner), slice_.high.z);
    add_cap(corners, {{0, 0, 1}, -slice_.high.z});
  }

  void add_cap(const std::vector<glm::dvec3>& corners, const facet::Plane& plane) {
    const auto begin = static_cast<std::uint32_t>(soup_.corners.size());
    for (const glm::dvec3& corner : corners) {
      soup_.corners.push_back({static_cast<std::uint32_t>(soup_.points.size()), false});
      soup_.points.push_back(corner);
    }
    soup_.fragments.push_back({planes_.add(plane), begin, static_cast<std::uint32_t>(soup_.corners.size())});
  }

  /// The triangles over the side between two lower corners. The upper point of each corner has the next index.
  Pair pair(std::uint32_t from, std::uint32_t to, bool is_hole) {
    const Quad quad{soup_.points[from], soup_.points[to], soup_.points[from + 1], soup_.points[to + 1]};
    Pair made;
    made.rises = diagonal_rises(quad, slice_, is_hole);
    if (made.rises) {
      made.first = triangle({from, to + 1, from + 1});
      made.second = triangle({from, to, to + 1});
    } else {
      made.first = triangle({from, to, from + 1});
      made.second = triangle({to, to + 1, from + 1});
    }
    // The triangles of a side that is not bent share one plane.
    const std::uint32_t beyond = made.rises ? from + 1 : to + 1;
    const facet::Plane& plane = made.rises ? made.second.plane : made.first.plane;
    const bool both = !made.first.is_flat && !made.second.is_flat;
    if (both && std::abs(plane.height(soup_.points[beyond])) <= relative_tolerance * size()) {
      made.first.plane = made.second.plane = plane;
    }
    return made;
  }

  [[nodiscard]] Triangle triangle(const std::array<std::uint32_t, 3>& corners) const {
    const glm::dvec3& origin = soup_.points[corners[0]];
    const glm::dvec3 normal = glm::cross(soup_.points[corners[1]] - origin, soup_.points[corners[2]] - origin);
    const double length = glm::length(normal);
    if (length <= relative_tolerance * size() * size()) return {corners, {}, true};
    return {corners, {normal / length, -glm::dot(normal, origin) / length}, false};
  }

  /// Whether the dihedral angle of the solid exceeds 180 degrees where the second triangle joins the first.
  [[nodiscard]] bool is_reflex(const Triangle& first, const Triangle& second) const {
    if (first.is_flat || second.is_flat) return true;
    const double near = convex::tolerance(planes_);
    return std::any_of(second.corners.begin(), second.corners.end(),
                       [&](std::uint32_t corner) { return first.plane.height(soup_.points[corner]) > near; });
  }

  void emit(const Pair& before, const Pair& here, const Pair& after) {
    const bool starts = is_reflex(before.second, here.first);
    const bool between = is_reflex(here.first, here.second);
    const bool ends = is_reflex(here.second, after.first);
    if (here.rises) {
      emit(here.first, {between, false, starts});
      emit(here.second, {false, ends, between});
    } else {
      emit(here.first, {false, between, starts});
      emit(here.second, {ends, false, between});
    }
  }

  /// Adds the triangles of a side below a top that is a line. Triangles with an upper edge that share their lower
  /// corner lie in one plane and may be folded back on each other. One triangle replaces them, between the ends that
  /// they do not share.
  void emit_at_line(const Pair& before, const Pair& here) {
    const std::array<bool, 3> unknown{true, true, true};
    emit(here.rises ? here.second : here.first, unknown);
    const std::uint32_t corner = here.first.corners[0];
    const std::uint32_t start = before.rises ? corner + 1 : before.first.corners[2];
    const std::uint32_t end = here.rises ? here.first.corners[1] : corner + 1;
    emit(triangle({corner, end, start}), unknown);
  }

  /// Adds a triangle. `reflex[i]` applies to the edge from corner i to the next one.
  void emit(const Triangle& triangle, const std::array<bool, 3>& reflex) {
    if (triangle.is_flat) return;
    const auto begin = static_cast<std::uint32_t>(soup_.corners.size());
    for (std::size_t i = 0; i < 3; ++i) soup_.corners.push_back({triangle.corners[i], reflex[i]});
    soup_.fragments.push_back({planes_.add(triangle.plane), begin, begin + 3});
  }

  Limits limits_;
  Slice slice_;
  facet::Box box_;
  facet::PlaneTable planes_;
  Soup soup_;
};

constexpr std::string_view cutting_slices = "cutting twisted or tapered slices";

std::vector<model::Polyhedron> cut(const flat::Area& area, const Slice& slice, const Work& work) {
  constexpr std::uint64_t corner_steps = 2'000;
  for (const flat::Outline& outline : area.outlines) work.charge(corner_steps * outline.size(), cutting_slices);
  SliceSides sides(area, slice, work);
  std::vector<model::Polyhedron> pieces;
  for (const convex::Polytope& polytope : sides.pieces()) pieces.push_back(to_polyhedron(polytope, sides.planes()));
  return pieces;
}

/// Moves a piece of one slice to another slice that differs only in height and turn.
model::Polyhedron moved(const model::Polyhedron& piece, const Slice& from, const Slice& to) {
  const SliceEnd turned{0, to.low.turn - from.low.turn, glm::dvec2(1)};
  const double shift = to.low.z - from.low.z;
  model::Polyhedron result = piece;
  for (glm::dvec3& point : result.points) {
    const double z = point.z == from.low.z ? to.low.z : point.z == from.high.z ? to.high.z : point.z + shift;
    point = glm::dvec3(turned(point), z);
  }
  for (glm::dvec4& plane : result.planes) {
    if (std::abs(plane.z) == 1.0) {
      plane.w = plane.z < 0.0 ? to.low.z : -to.high.z;
    } else {
      plane = glm::dvec4(turned(glm::dvec2(plane)), plane.z, plane.w - plane.z * shift);
    }
  }
  return result;
}

/// Whether every side has the same direction at both ends, so that no side bends.
bool is_straight(const flat::Area& area, const LinearExtrude& extrusion) {
  if (extrusion.twist != 0.0) return false;
  return std::all_of(area.outlines.begin(), area.outlines.end(), [](const flat::Outline& outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 side = outline[(i + 1) % outline.size()] - outline[i];
      if (side.x != 0.0 && side.y != 0.0) return false;
    }
    return true;
  });
}

/// Throws InputError if there are too many pieces. `pieces` may be a lower bound, because each slice has at least one
/// piece.
void require_few(std::size_t pieces) {
  const std::size_t most = Limits{}.max_pieces;
  if (pieces <= most) return;
  throw InputError("linear_extrude() needs more than " + std::to_string(most) +
                   " convex pieces; use fewer slices, or raise $fa or $fs");
}

}  // namespace

std::vector<model::Polyhedron> extrude_bent(const flat::Area& area, const LinearExtrude& extrusion, const Work& work) {
  const std::uint32_t count = is_straight(area, extrusion) ? 1 : slice_count(area, extrusion);
  require_few(count);
  std::vector<model::Polyhedron> pieces = cut(area, slice_at(extrusion, 0, count), work);
  const std::size_t a_slice = pieces.size();
  const bool are_alike = extrusion.scale == glm::dvec2(1);
  if (are_alike) require_few(a_slice * count);
  for (std::uint32_t i = 1; i < count; ++i) {
    const Slice slice = slice_at(extrusion, i, count);
    if (are_alike) {
      constexpr std::uint64_t moved_steps = 500;
      work.charge(moved_steps * a_slice, cutting_slices);
      for (std::size_t piece = 0; piece < a_slice; ++piece) {
        pieces.push_back(moved(pieces[piece], slice_at(extrusion, 0, count), slice));
      }
    } else {
      std::vector<model::Polyhedron> more = cut(area, slice, work);
      std::move(more.begin(), more.end(), std::back_inserter(pieces));
    }
    require_few(pieces.size() + (count - 1 - i));
  }
  return pieces;
}

}  // namespace csgsim::solids

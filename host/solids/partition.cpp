#include "host/solids/partition.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "host/convex/clip.h"
#include "host/solids/choice.h"
#include "host/solids/neighbours.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

enum class Side : std::uint8_t { back, on, front };

/// Minimum width that the coverage check resolves, as a fraction of the model's diagonal. The intersection of two
/// nearly parallel planes is not known much more accurately.
constexpr double min_visible_width = 1e-6;

constexpr std::string_view cutting = "cutting a solid into convex pieces";

/// Cost of one cut, in steps of work per corner of the surface.
constexpr std::uint64_t cut_steps = 20;

/// A part of space, and the surface inside it.
struct Cell {
  Soup soup;
  convex::Polytope space;
};

Side classify(double height, double near) {
  return height > near ? Side::front : height < -near ? Side::back : Side::on;
}

/// The area of a convex polygon whose corners are `corner(i)`.
template <class Corner>
double compute_area(std::size_t corners, const Corner& corner) {
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < corners; ++i) sum += glm::cross(corner(i) - corner(0), corner(i + 1) - corner(0));
  return glm::length(sum) / 2;
}

double compute_area(const Soup& soup, const Fragment& fragment) {
  return compute_area(fragment.end - fragment.begin,
                      [&](std::size_t i) { return soup.points[soup.corners[fragment.begin + i].point]; });
}

/// Whether the surface covers the faces of a piece that do not lie in a wall. Total areas are compared, because nearly
/// parallel planes share their area arbitrarily. Missing area may consist of slivers, at most `near` wide in model
/// units, a few along each side. A piece that is not covered extends past the surface where part of the surface was
/// lost.
bool is_covered(const convex::Polytope& piece, std::span<const facet::Halfspace> walls, const Soup& surface,
                double near) {
  constexpr double slivers = 8;  // maximum number of lost slivers along a side
  double missing = 0;
  for (const convex::Face& face : piece.faces) {
    if (std::ranges::find(walls, face.halfspace) != walls.end()) continue;
    const auto corner = [&](std::size_t i) { return piece.vertices[face.corners[i % face.corners.size()]]; };
    double around = 0;
    for (std::size_t i = 0; i < face.corners.size(); ++i) around += glm::distance(corner(i), corner(i + 1));
    missing += compute_area(face.corners.size(), corner) - slivers * near * around;
  }
  for (const Fragment& fragment : surface.fragments) missing -= compute_area(surface, fragment);
  return missing <= 0;
}

/// One side of a cut, with only the points that this side needs.
class Half {
 public:
  explicit Half(const std::vector<glm::dvec3>& points) : points_(points), places_(points.size(), none) {}

  void add(std::uint32_t point, bool reflex) {
    if (point >= places_.size()) places_.resize(points_.size(), none);
    if (places_[point] == none) {
      places_[point] = static_cast<std::uint32_t>(soup.points.size());
      soup.points.push_back(points_[point]);
    }
    soup.corners.push_back({places_[point], reflex});
  }

  void close(facet::Halfspace halfspace) {
    const std::uint32_t begin = soup.fragments.empty() ? 0 : soup.fragments.back().end;
    soup.fragments.push_back({halfspace, begin, static_cast<std::uint32_t>(soup.corners.size())});
  }

  Soup soup;

 private:
  const std::vector<glm::dvec3>& points_;  ///< points of both sides of the cut
  std::vector<std::uint32_t> places_;      ///< for each of `points_`: its index in the soup, or `none`
};

/// Divides a soup into the parts behind and in front of a plane.
class Cut {
 public:
  Cut(Soup soup, facet::Halfspace halfspace, const facet::PlaneTable& planes, double near)
      : soup_(std::move(soup)),
        planes_(planes),
        number_(halfspace.plane),
        plane_(convex::outward_plane(halfspace, planes)),
        back(soup_.points),
        front(soup_.points) {
    for (const glm::dvec3& point : soup_.points) {
      heights_.push_back(plane_.height(point));
      sides_.push_back(classify(heights_.back(), near));
    }
  }

  /// Divides all fragments. A fragment whose plane is the cutting plane is treated as in it regardless of rounding, so
  /// neither half keeps a fragment that the same plane would cut again.
  void operator()() {
    for (const Fragment& fragment : soup_.fragments) {
      if (fragment.halfspace.plane == number_) {
        accumulate(fragment);
        continue;
      }
      bool is_front = false;
      bool is_back = false;
      for (std::uint32_t i = fragment.begin; i < fragment.end; ++i) {
        is_front |= side(i) == Side::front;
        is_back |= side(i) == Side::back;
      }
      if (is_front) part(fragment, Side::front, front);
      if (is_back) part(fragment, Side::back, back);
      if (!is_front && !is_back) accumulate(fragment);
    }
  }

 private:
  [[nodiscard]] Side side(std::uint32_t corner) const { return sides_[soup_.corners[corner].point]; }

  /// Accumulates the area of faces in the plane. The sign of the sum shows which side of the plane is solid.
  void accumulate(const Fragment& fragment) {
    facing += compute_area(soup_, fragment) *
              glm::dot(convex::outward_plane(fragment.halfspace, planes_).normal, plane_.normal);
  }

  /// Adds the part of a fragment on one side to `half`.
  void part(const Fragment& fragment, Side kept, Half& half) {
    for (std::uint32_t i = fragment.begin; i < fragment.end; ++i) {
      const std::uint32_t next = i + 1 < fragment.end ? i + 1 : fragment.begin;
      const Side here = side(i);
      const Side there = side(next);
      const bool is_out = here != kept && here != Side::on;
      const bool leaves = there != kept && there != Side::on;
      // An edge in the plane is no longer reflex on either side, and an edge made by the cut never is.
      const bool stays = here == kept || there == kept;
      if (!is_out) half.add(soup_.corners[i].point, soup_.corners[i].reflex && stays);
      if ((here == kept && leaves) || (is_out && there == kept)) {
        half.add(crossing(soup_.corners[i].point, soup_.corners[next].point), soup_.corners[i].reflex && is_out);
      }
    }
    half.close(fragment.halfspace);
  }

  /// The point where an edge crosses the plane.
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    const auto next = static_cast<std::uint32_t>(soup_.points.size());
    const auto [entry, is_new] = crossings_.try_emplace(std::uint64_t{low} << 32U | high, next);
    if (is_new) {
      const double share = heights_[low] / (heights_[low] - heights_[high]);
      soup_.points.push_back(soup_.points[low] + share * (soup_.points[high] - soup_.points[low]));
    }
    return entry->second;
  }

  Soup soup_;
  const facet::PlaneTable& planes_;
  std::uint32_t number_;  ///< index of the cutting plane
  facet::Plane plane_;
  std::vector<double> heights_;
  std::vector<Side> sides_;
  std::unordered_map<std::uint64_t, std::uint32_t> crossings_;

 public:
  Half back;
  Half front;
  double facing = 0;  ///< area of faces in the plane that face its front, minus the area of those that face its back
};

class Partition {
 public:
  Partition(std::span<const Level> levels, const facet::PlaneTable& planes, double near, const Limits& limits)
      : levels_(levels), planes_(planes), near_(near), limits_(limits) {}

  std::vector<convex::Polytope> operator()(Cell whole) {
    is_of_surface_.assign(planes_.planes().size(), false);
    for (const Fragment& fragment : whole.soup.fragments) is_of_surface_[fragment.halfspace.plane] = true;
    for (const Level& level : levels_) is_of_surface_[level.halfspace.plane] = true;
    open_fragments_ = whole.soup.fragments.size();
    open_.push_back(std::move(whole));
    while (!open_.empty()) {
      Cell cell = std::move(open_.back());
      open_.pop_back();
      open_fragments_ -= cell.soup.fragments.size();
      if (const auto halfspace = choose_plane(cell.soup, {levels_, planes_, near_, limits_.work})) {
        divide(std::move(cell), *halfspace);
      } else {
        finish(std::move(cell));
      }
    }
    return std::move(pieces_);
  }

 private:
  void divide(Cell cell, facet::Halfspace halfspace) {
    limits_.work.charge(cut_steps * cell.soup.corners.size() + 2 * convex::clip_steps(cell.space), cutting);
    Cut cut(std::move(cell.soup), halfspace, planes_, near_);
    cut();
    convex::Polytope beyond = convex::clip(cell.space, convex::opposite(halfspace), planes_);
    add({std::move(cut.front.soup), std::move(beyond)}, cut.facing < 0);
    add({std::move(cut.back.soup), convex::clip(std::move(cell.space), halfspace, planes_)}, cut.facing > 0);
  }

  void add(Cell cell, bool is_solid_if_bare) {
    if (cell.space.empty()) return;
    if (cell.soup.fragments.empty()) {
      if (is_solid_if_bare) keep(std::move(cell.space));
      return;
    }
    open_fragments_ += cell.soup.fragments.size();
    if (open_fragments_ > limits_.max_fragments) {
      throw InputError("the solid's faces are cut into more than " + std::to_string(limits_.max_fragments) +
                       " parts; use fewer faces, or divide the solid");
    }
    open_.push_back(std::move(cell));
  }

  /// Keeps the part of the cell that is behind all planes of the surface in it.
  void finish(Cell cell) {
    std::vector<facet::Halfspace> halfspaces;
    for (const Fragment& fragment : cell.soup.fragments) halfspaces.push_back(fragment.halfspace);
    sort_unique(halfspaces);
    std::vector<facet::Halfspace> walls;
    for (const convex::Face& face : cell.space.faces) walls.push_back(face.halfspace);
    for (const facet::Halfspace halfspace : halfspaces) {
      limits_.work.charge(convex::clip_steps(cell.space), cutting);
      cell.space = convex::clip(std::move(cell.space), halfspace, planes_);
      if (cell.space.empty()) return;
    }
    if (limits_.checks_coverage &&
        !is_covered(cell.space, walls, cell.soup, std::max(near_, min_visible_width * planes_.diagonal())))
      fail();
    keep(std::move(cell.space));
  }

  [[noreturn]] static void fail() { throw HoleError("the solid's surface has a hole; close it"); }

  void keep(convex::Polytope piece) {
    for (const convex::Face& face : piece.faces) {
      if (is_of_surface_[face.halfspace.plane]) continue;
      fail();
    }
    pieces_.push_back(std::move(piece));
    if (pieces_.size() > limits_.max_pieces) {
      throw InputError("the solid needs more than " + std::to_string(limits_.max_pieces) +
                       " convex pieces; use fewer faces, or divide the solid");
    }
  }

  std::span<const Level> levels_;
  const facet::PlaneTable& planes_;
  double near_;
  const Limits& limits_;
  std::vector<Cell> open_;
  std::vector<convex::Polytope> pieces_;
  /// For each plane, whether it belongs to the surface or a level; the other planes are walls of the first cell.
  std::vector<bool> is_of_surface_;
  std::size_t open_fragments_ = 0;
};

}  // namespace

std::vector<convex::Polytope> partition(Soup soup, convex::Polytope cell, std::span<const Level> levels,
                                        const facet::PlaneTable& planes, double near, const Limits& limits) {
  return Partition(levels, planes, near, limits)({std::move(soup), std::move(cell)});
}

}  // namespace csgsim::solids

#include "host/solids/partition.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include "host/convex/clip.h"
#include "host/solids/covered.h"
#include "host/solids/neighbours.h"
#include "hw/base/error.h"

namespace csgsim::solids {

namespace {

enum class Side : std::uint8_t { back, on, front };

/// A part of space, and what of the surface is in it.
/// Of a model's diagonal: what is not as wide cannot be seen. Where two planes that are hardly tilted cross is not
/// known much better.
constexpr double seen = 1e-6;

struct Cell {
  Soup soup;
  convex::Polytope space;
};

double height(const facet::Plane& plane, const glm::dvec3& point) {
  return glm::dot(plane.normal, point) + plane.offset;
}

Side side_of(double height, double near) {
  return height > near ? Side::front : height < -near ? Side::back : Side::on;
}

std::uint64_t key_of(facet::Halfspace halfspace) {
  return std::uint64_t{halfspace.plane} << 1U | (halfspace.positive ? 1U : 0U);
}

void sort_unique(std::vector<facet::Halfspace>& halfspaces) {
  std::sort(halfspaces.begin(), halfspaces.end(),
            [](facet::Halfspace a, facet::Halfspace b) { return key_of(a) < key_of(b); });
  halfspaces.erase(std::unique(halfspaces.begin(), halfspaces.end()), halfspaces.end());
}

/// One side of a cut, with only the points that it needs.
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
  const std::vector<glm::dvec3>& points_;  ///< of both sides
  std::vector<std::uint32_t> places_;      ///< of those in the soup
};

/// Cuts a soup in two by a plane.
class Cut {
 public:
  Cut(Soup soup, const facet::Plane& plane, double near)
      : soup_(std::move(soup)), plane_(plane), back(soup_.points), front(soup_.points) {
    for (const glm::dvec3& point : soup_.points) {
      heights_.push_back(height(plane, point));
      sides_.push_back(side_of(heights_.back(), near));
    }
  }

  void operator()(const facet::PlaneTable& planes) {
    for (const Fragment& fragment : soup_.fragments) {
      bool is_front = false;
      bool is_back = false;
      for (std::uint32_t i = fragment.begin; i < fragment.end; ++i) {
        is_front |= side(i) == Side::front;
        is_back |= side(i) == Side::back;
      }
      if (is_front) part(fragment, Side::front, front);
      if (is_back) part(fragment, Side::back, back);
      if (!is_front && !is_back) weigh(fragment, planes);
    }
  }

 private:
  [[nodiscard]] Side side(std::uint32_t corner) const { return sides_[soup_.corners[corner].point]; }

  /// The area of faces in the plane says which of its sides is solid.
  void weigh(const Fragment& fragment, const facet::PlaneTable& planes) {
    glm::dvec3 sum(0);
    const glm::dvec3& origin = soup_.points[soup_.corners[fragment.begin].point];
    for (std::uint32_t i = fragment.begin + 1; i + 1 < fragment.end; ++i) {
      sum +=
          glm::cross(soup_.points[soup_.corners[i].point] - origin, soup_.points[soup_.corners[i + 1].point] - origin);
    }
    facing += glm::length(sum) * glm::dot(convex::outward_plane(fragment.halfspace, planes).normal, plane_.normal);
  }

  /// What of a fragment is on one side.
  void part(const Fragment& fragment, Side kept, Half& half) {
    for (std::uint32_t i = fragment.begin; i < fragment.end; ++i) {
      const std::uint32_t next = i + 1 < fragment.end ? i + 1 : fragment.begin;
      const Side here = side(i);
      const Side there = side(next);
      const bool is_out = here != kept && here != Side::on;
      const bool leaves = there != kept && there != Side::on;
      // An edge in the plane is no longer reflex on either side, and the edge that the cut makes never is.
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
  facet::Plane plane_;
  std::vector<double> heights_;
  std::vector<Side> sides_;
  std::unordered_map<std::uint64_t, std::uint32_t> crossings_;

 public:
  Half back;
  Half front;
  double facing = 0;  ///< area of faces in the plane that face its front, less that of those that face its back
};

/// Chooses the plane to cut a cell by.
class Choice {
 public:
  Choice(const Soup& soup, std::span<const Level> levels, const facet::PlaneTable& planes, double near)
      : soup_(soup), levels_(levels), planes_(planes), near_(near) {}

  /// None if the surface is convex.
  std::optional<facet::Halfspace> operator()() {
    std::vector<facet::Halfspace> candidates = at_reflex_edges();
    std::optional<Found> found = best_of(candidates);
    if (!found) {
      candidates.clear();
      for (const Fragment& fragment : soup_.fragments) candidates.push_back(fragment.halfspace);
      sort_unique(candidates);
      found = best_of(candidates);
    }
    if (!found) return std::nullopt;
    const std::optional<Found> level = best_of(levels_inside());
    constexpr double gain = 0.7;  // A level of about the same cost leaves more to cut.
    return level && level->cost < gain * found->cost ? level->halfspace : found->halfspace;
  }

 private:
  struct Found {
    facet::Halfspace halfspace;
    double cost = 0;
  };

  /// Of each axis those next to the middle, which have something of the surface on both sides.
  [[nodiscard]] std::vector<facet::Halfspace> levels_inside() const {
    constexpr std::ptrdiff_t each_way = 4;
    std::vector<facet::Halfspace> inside;
    for (int axis = 0; axis < 3 && !levels_.empty(); ++axis) {
      const auto [low, high] =
          std::minmax_element(soup_.points.begin(), soup_.points.end(),
                              [axis](const glm::dvec3& a, const glm::dvec3& b) { return a[axis] < b[axis]; });
      const auto from = [&](double place) {
        return std::partition_point(levels_.begin(), levels_.end(), [&](const Level& level) {
          return level.axis < axis || (level.axis == axis && level.place <= place);
        });
      };
      const auto begin = from((*low)[axis] + near_);
      const auto end = std::max(begin, from((*high)[axis] - near_));
      const auto middle = std::clamp(from(((*low)[axis] + (*high)[axis]) / 2.0), begin, end);
      for (auto level = middle - std::min(each_way, middle - begin); level != middle + std::min(each_way, end - middle);
           ++level) {
        inside.push_back(level->halfspace);
      }
    }
    return inside;
  }

  [[nodiscard]] std::vector<facet::Halfspace> at_reflex_edges() const {
    std::vector<facet::Halfspace> found;
    for (const Fragment& fragment : soup_.fragments) {
      const auto begin = soup_.corners.begin() + fragment.begin;
      const auto end = soup_.corners.begin() + fragment.end;
      if (std::any_of(begin, end, [](const Corner& corner) { return corner.reflex; })) {
        found.push_back(fragment.halfspace);
      }
    }
    sort_unique(found);
    return found;
  }

  /// The best of the candidates that have something of the surface in front of them; of many, some are looked at.
  std::optional<Found> best_of(const std::vector<facet::Halfspace>& candidates) {
    constexpr std::size_t work = 200'000;
    const std::size_t most = std::max<std::size_t>(12, work / (soup_.points.size() + soup_.corners.size() + 1));
    std::optional<Found> best;
    std::size_t looked_at = 0;
    const std::size_t stride = stride_of(candidates.size());
    for (std::size_t i = 0; i < candidates.size() && looked_at < most; ++i) {
      const facet::Halfspace candidate = candidates[i * stride % candidates.size()];
      if (!has_front(candidate)) continue;
      ++looked_at;
      const double cost = cost_of(candidate);
      if (!best || cost < best->cost) best = Found{candidate, cost};
    }
    return best;
  }

  /// A step that visits all of so many, and the first few of them far apart.
  static std::size_t stride_of(std::size_t count) {
    std::size_t stride = static_cast<std::size_t>(static_cast<double>(count) * 0.381966) | 1U;
    const auto divides = [&](std::size_t a, std::size_t b) {
      while (b != 0) a = std::exchange(b, a % b);
      return a != 1;
    };
    while (count > 1 && divides(stride, count)) ++stride;
    return stride;
  }

  [[nodiscard]] bool has_front(facet::Halfspace candidate) const {
    const facet::Plane plane = convex::outward_plane(candidate, planes_);
    return std::any_of(soup_.points.begin(), soup_.points.end(),
                       [&](const glm::dvec3& point) { return height(plane, point) > near_; });
  }

  /// Few fragments should be cut, and many reflex edges be in the plane; large surfaces are halved.
  double cost_of(facet::Halfspace candidate) {
    const facet::Plane plane = convex::outward_plane(candidate, planes_);
    sides_.clear();
    for (const glm::dvec3& point : soup_.points) sides_.push_back(side_of(height(plane, point), near_));
    double cuts = 0;
    double resolved = 0;
    double balance = 0;
    for (const Fragment& fragment : soup_.fragments) {
      bool is_front = false;
      bool is_back = false;
      for (std::uint32_t i = fragment.begin; i < fragment.end; ++i) {
        const Side here = sides_[soup_.corners[i].point];
        const std::uint32_t next = i + 1 < fragment.end ? i + 1 : fragment.begin;
        is_front |= here == Side::front;
        is_back |= here == Side::back;
        if (soup_.corners[i].reflex && here == Side::on && sides_[soup_.corners[next].point] == Side::on)
          resolved += 0.5;
      }
      if (is_front && is_back) ++cuts;
      balance += (is_front ? 1.0 : 0.0) - (is_back ? 1.0 : 0.0);
    }
    const double count = static_cast<double>(soup_.fragments.size());
    return (cuts + 2.0 + balance_weight(count) * std::abs(balance)) / (resolved + 0.5);
  }

  static double balance_weight(double count) { return count > 1000 ? 0.1 : 0.0; }

  const Soup& soup_;
  std::span<const Level> levels_;
  const facet::PlaneTable& planes_;
  double near_;
  std::vector<Side> sides_;
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
      if (const auto halfspace = Choice(cell.soup, levels_, planes_, near_)()) {
        divide(std::move(cell), *halfspace);
      } else {
        finish(std::move(cell));
      }
    }
    return std::move(pieces_);
  }

 private:
  void divide(Cell cell, facet::Halfspace halfspace) {
    Cut cut(std::move(cell.soup), convex::outward_plane(halfspace, planes_), near_);
    cut(planes_);
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
    if (open_fragments_ > limits_.most_fragments) {
      throw InputError("the solid's faces fall into more than " + std::to_string(limits_.most_fragments) +
                       " parts; give it fewer faces, or divide it");
    }
    open_.push_back(std::move(cell));
  }

  /// What is behind all of the surface's planes.
  void finish(Cell cell) {
    std::vector<facet::Halfspace> halfspaces;
    for (const Fragment& fragment : cell.soup.fragments) halfspaces.push_back(fragment.halfspace);
    sort_unique(halfspaces);
    std::vector<facet::Halfspace> walls;
    for (const convex::Face& face : cell.space.faces) walls.push_back(face.halfspace);
    for (const facet::Halfspace halfspace : halfspaces) {
      cell.space = convex::clip(std::move(cell.space), halfspace, planes_);
      if (cell.space.empty()) return;
    }
    if (limits_.watches_cover && !is_covered(cell.space, walls, cell.soup, std::max(near_, seen * planes_.diagonal())))
      fail();
    keep(std::move(cell.space));
  }

  [[noreturn]] static void fail() { throw HoleError("the faces leave a hole in the solid's surface; close it"); }

  void keep(convex::Polytope piece) {
    for (const convex::Face& face : piece.faces) {
      if (is_of_surface_[face.halfspace.plane]) continue;
      fail();
    }
    pieces_.push_back(std::move(piece));
    if (pieces_.size() > limits_.most_pieces) {
      throw InputError("the solid falls into more than " + std::to_string(limits_.most_pieces) +
                       " convex pieces; give it fewer faces, or divide it");
    }
  }

  std::span<const Level> levels_;
  const facet::PlaneTable& planes_;
  double near_;
  const Limits& limits_;
  std::vector<Cell> open_;
  std::vector<convex::Polytope> pieces_;
  std::vector<bool> is_of_surface_;  ///< of each plane, and of levels: others are walls of the first cell
  std::size_t open_fragments_ = 0;
};

}  // namespace

std::vector<convex::Polytope> partition(Soup soup, convex::Polytope cell, std::span<const Level> levels,
                                        const facet::PlaneTable& planes, double near, const Limits& limits) {
  return Partition(levels, planes, near, limits)({std::move(soup), std::move(cell)});
}

}  // namespace csgsim::solids

#include "host/solids/choice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "host/convex/clip.h"

namespace csgsim::solids {

namespace {

/// Sides of a plane as a bit set: for a point its side; for several points all sides on which they lie.
using Sides = std::uint8_t;
constexpr Sides on = 0;
constexpr Sides back = 1;
constexpr Sides front = 2;

std::uint64_t sort_key(facet::Halfspace halfspace) {
  return std::uint64_t{halfspace.plane} << 1U | (halfspace.positive ? 1U : 0U);
}

/// A step coprime to `count`: its multiples visit all indices, and the first ones are far apart.
std::size_t coprime_stride(std::size_t count) {
  std::size_t stride = static_cast<std::size_t>(static_cast<double>(count) * 0.381966) | 1U;
  const auto divides = [&](std::size_t a, std::size_t b) {
    while (b != 0) a = std::exchange(b, a % b);
    return a != 1;
  };
  while (count > 1 && divides(stride, count)) ++stride;
  return stride;
}

class PlaneChooser {
 public:
  PlaneChooser(const Soup& soup, const Choices& from) : soup_(soup), from_(from), sides_(soup.points.size()) {
    for (const Fragment& fragment : soup_.fragments) {
      for (std::uint32_t i = fragment.begin; i < fragment.end; ++i) {
        if (soup_.corners[i].reflex) reflex_edges_.push_back({corner(i), corner(next(fragment, i))});
      }
    }
  }

  std::optional<facet::Halfspace> operator()() {
    std::vector<facet::Halfspace> candidates = at_reflex_edges();
    std::optional<Found> found = choose_best(candidates);
    if (!found) {
      candidates.clear();
      for (const Fragment& fragment : soup_.fragments) candidates.push_back(fragment.halfspace);
      sort_unique(candidates);
      found = choose_best(candidates);
    }
    if (!found) return std::nullopt;
    const std::optional<Found> level = choose_best(levels_inside());
    constexpr double gain = 0.7;  // a level whose cost is about the same would leave more to cut
    return level && level->cost < gain * found->cost ? level->halfspace : found->halfspace;
  }

 private:
  struct Found {
    facet::Halfspace halfspace;
    double cost = 0;
  };

  /// The point index of a fragment's corner.
  [[nodiscard]] std::uint32_t corner(std::uint32_t i) const { return soup_.corners[i].point; }

  static std::uint32_t next(const Fragment& fragment, std::uint32_t corner) {
    return corner + 1 < fragment.end ? corner + 1 : fragment.begin;
  }

  /// The levels nearest to the middle of each axis that have part of the surface on both sides.
  [[nodiscard]] std::vector<facet::Halfspace> levels_inside() const {
    constexpr std::ptrdiff_t each_way = 4;
    const std::span<const Level> levels = from_.levels;
    std::vector<facet::Halfspace> inside;
    for (int axis = 0; axis < 3 && !levels.empty(); ++axis) {
      const auto [low, high] =
          std::minmax_element(soup_.points.begin(), soup_.points.end(),
                              [axis](const glm::dvec3& a, const glm::dvec3& b) { return a[axis] < b[axis]; });
      const auto after = [&](double place) {
        return std::partition_point(levels.begin(), levels.end(), [&](const Level& level) {
          return level.axis < axis || (level.axis == axis && level.place <= place);
        });
      };
      const auto begin = after((*low)[axis] + from_.near);
      const auto end = std::max(begin, after((*high)[axis] - from_.near));
      const auto middle = std::clamp(after(((*low)[axis] + (*high)[axis]) / 2.0), begin, end);
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

  /// The candidate with the lowest cost that has part of the surface in front of it. If there are many candidates, only
  /// a sample is evaluated.
  std::optional<Found> choose_best(const std::vector<facet::Halfspace>& candidates) {
    constexpr std::size_t work = 200'000;
    const std::size_t size = soup_.points.size() + soup_.corners.size();
    const std::size_t most = std::max<std::size_t>(12, work / (size + 1));
    std::optional<Found> best;
    std::size_t looked_at = 0;
    const std::size_t stride = coprime_stride(candidates.size());
    for (std::size_t i = 0; i < candidates.size() && looked_at < most; ++i) {
      const facet::Halfspace candidate = candidates[i * stride % candidates.size()];
      from_.work.charge(size, "choosing planes to cut a solid");
      if (!find_sides(candidate)) continue;
      ++looked_at;
      const double cost = cost_below(best ? best->cost : std::numeric_limits<double>::infinity());
      if (!best || cost < best->cost) best = Found{candidate, cost};
    }
    return best;
  }

  /// Finds the side of every point. Returns whether part of the surface is in front of the plane.
  bool find_sides(facet::Halfspace candidate) {
    const facet::Plane plane = convex::outward_plane(candidate, from_.planes);
    const double near = from_.near;
    Sides any = on;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      const double height = glm::dot(plane.normal, soup_.points[i]) + plane.offset;
      sides_[i] = static_cast<Sides>((height > near ? front : on) | (height < -near ? back : on));
      any = static_cast<Sides>(any | sides_[i]);
    }
    return (any & front) != 0;
  }

  /// The cost of the plane for which find_sides() was last called. It rises with the number of fragments cut and falls
  /// with the number of reflex edges in the plane; large surfaces should be halved. Stops early and returns some value
  /// of at least `most` once the cost cannot be lower.
  [[nodiscard]] double cost_below(double most) const {
    const auto in_plane = [&](const ReflexEdge& edge) { return (sides_[edge.from] | sides_[edge.to]) == on; };
    const auto resolved = std::count_if(reflex_edges_.begin(), reflex_edges_.end(), in_plane);
    const double divisor = 0.5 * static_cast<double>(resolved) + 0.5;
    std::int64_t cuts = 0;
    std::int64_t balance = 0;
    for (const Fragment& fragment : soup_.fragments) {
      Sides sides = on;
      for (std::uint32_t i = fragment.begin; i < fragment.end; ++i)
        sides = static_cast<Sides>(sides | sides_[corner(i)]);
      balance += ((sides & front) != 0 ? 1 : 0) - ((sides & back) != 0 ? 1 : 0);
      if (sides != (front | back)) continue;
      ++cuts;
      const double least = (static_cast<double>(cuts) + 2.0) / divisor;
      if (least >= most) return least;
    }
    const double count = static_cast<double>(soup_.fragments.size());
    return (static_cast<double>(cuts) + 2.0 + balance_weight(count) * std::abs(static_cast<double>(balance))) / divisor;
  }

  static double balance_weight(double count) { return count > 1000 ? 0.1 : 0.0; }

  struct ReflexEdge {
    std::uint32_t from;  ///< point index
    std::uint32_t to;
  };

  const Soup& soup_;
  const Choices& from_;
  std::vector<ReflexEdge> reflex_edges_;
  std::vector<Sides> sides_;  ///< side of each point
};

}  // namespace

void sort_unique(std::vector<facet::Halfspace>& halfspaces) {
  std::sort(halfspaces.begin(), halfspaces.end(),
            [](facet::Halfspace a, facet::Halfspace b) { return sort_key(a) < sort_key(b); });
  halfspaces.erase(std::unique(halfspaces.begin(), halfspaces.end()), halfspaces.end());
}

std::optional<facet::Halfspace> choose_plane(const Soup& soup, const Choices& choices) {
  return PlaneChooser(soup, choices)();
}

}  // namespace csgsim::solids

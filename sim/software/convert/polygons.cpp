#include "sim/software/convert/polygons.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "sim/software/convert/sets.h"
#include "sim/software/convert/sides.h"

namespace csgsim::software::convert {

namespace {

/// The triangles of one plane.
class PlaneFaces {
 public:
  PlaneFaces(const Surface& surface, std::size_t first, std::size_t last)
      : surface_(surface), first_(first), parts_(last - first) {
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t corner = 0; corner < 3; ++corner) from_.emplace(side(i, corner), i);
    for (std::size_t i = first; i < last; ++i) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        const Side here = side(i, corner);
        const auto across = from_.find({here[1], here[0]});
        if (across != from_.end()) parts_.join(number(i), number(across->second));
      }
    }
    for (std::size_t i = first; i < last; ++i) triangles_[parts_.find(number(i))].push_back(i);
  }

  void add_to(std::vector<std::vector<std::uint32_t>>& polygons) const {
    for (const auto& [part, triangles] : triangles_) {
      Outline outline;
      for (const std::size_t i : triangles)
        for (std::size_t corner = 0; corner < 3; ++corner) outline.sides.push_back(side(i, corner));
      cancel_opposite_sides(outline.sides);
      std::vector<std::vector<std::uint32_t>> rounds = rounds_of(outline);
      // A polygon of n corners consists of n - 2 triangles. A polygon that touches itself stays in triangles, as does
      // one bent by rounding, which OpenSCAD would reject.
      if (rounds.size() == 1 && rounds.front().size() == triangles.size() + 2 && is_simple(rounds.front()) &&
          is_flat(surface_.points, rounds.front())) {
        polygons.push_back(std::move(rounds.front()));
        continue;
      }
      for (const std::size_t i : triangles) {
        const Triangle& triangle = surface_.triangles[i];
        polygons.push_back({triangle.begin(), triangle.end()});
      }
    }
  }

 private:
  [[nodiscard]] Side side(std::size_t triangle, std::size_t corner) const {
    return {surface_.triangles[triangle][corner], surface_.triangles[triangle][(corner + 1) % 3]};
  }

  [[nodiscard]] std::uint32_t number(std::size_t triangle) const {
    return static_cast<std::uint32_t>(triangle - first_);
  }

  static bool is_simple(std::vector<std::uint32_t> round) {
    std::ranges::sort(round);
    return std::ranges::adjacent_find(round) == round.end();
  }

  const Surface& surface_;
  std::size_t first_;
  DisjointSets parts_;
  std::map<Side, std::size_t> from_;  ///< triangles by their sides
  std::map<std::uint32_t, std::vector<std::size_t>> triangles_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> polygons_of(const Surface& surface) {
  std::vector<std::vector<std::uint32_t>> polygons;
  for (std::size_t first = 0; first < surface.triangles.size();) {
    std::size_t last = first;
    while (last < surface.triangles.size() && surface.outlines[last] == surface.outlines[first]) ++last;
    PlaneFaces(surface, first, last).add_to(polygons);
    first = last;
  }
  return polygons;
}

}  // namespace csgsim::software::convert

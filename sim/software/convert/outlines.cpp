#include "sim/software/convert/outlines.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "host/convex/clip.h"
#include "sim/software/convert/point_table.h"
#include "sim/software/convert/sides.h"

namespace csgsim::software::convert {

namespace {

/// As a part of the diagonal: what is left of places that were rounded.
constexpr double straight_tolerance = 1e-13;

struct TripleHash {
  std::size_t operator()(const Triple& triple) const {
    std::uint64_t sum = 0;
    for (const std::uint32_t one : triple) {
      sum = (sum ^ one) * 0x9e3779b97f4a7c15U;
      sum ^= sum >> 32U;
    }
    return sum;
  }
};

/// Numbers of the points of fragments.
class Points {
 public:
  explicit Points(const Bodies& bodies)
      : centre_(bodies.geometry.planes.centre()),
        unit_(bodies.planes.unit()),
        table_(bodies.geometry.planes.centre(), bodies.geometry.planes.diagonal()) {
    // Where a corner of a primitive is near, it is the point.
    for (const facet::Convex& solid : bodies.geometry.solids)
      for (const glm::dvec3& vertex : solid.vertices) table_.add(vertex);
  }

  std::uint32_t number_of(const FragmentCorner& corner) {
    const auto [entry, is_new] = known_.try_emplace(corner.planes, 0);
    if (is_new) entry->second = table_.add(centre_ + corner.place * unit_);
    return entry->second;
  }

  [[nodiscard]] const std::vector<glm::dvec3>& all() const { return table_.points(); }

 private:
  glm::dvec3 centre_;
  double unit_;
  PointTable table_;
  std::unordered_map<Triple, std::uint32_t, TripleHash> known_;
};

}  // namespace

std::optional<Outlines> join(const Bodies& bodies, const std::vector<Fragment>& fragments) {
  Outlines result;
  Points points(bodies);
  const facet::PlaneTable& planes = bodies.geometry.planes;
  std::vector<std::array<std::uint32_t, 2>> number(planes.planes().size());  // of outlines, from 1; back, front
  for (const Fragment& fragment : fragments) {
    std::uint32_t& known = number[fragment.plane][fragment.is_front ? 1 : 0];
    if (known == 0) {
      const glm::dvec3 normal = planes.planes()[fragment.plane].normal;
      result.outlines.push_back({fragment.is_front ? normal : -normal, {}});
      known = static_cast<std::uint32_t>(result.outlines.size());
    }
    std::vector<Side>& sides = result.outlines[known - 1].sides;
    const std::uint32_t first = points.number_of(fragment.corners.front());
    std::uint32_t at = first;
    for (std::size_t i = 1; i < fragment.corners.size(); ++i) {
      const std::uint32_t next = points.number_of(fragment.corners[i]);
      sides.push_back({std::exchange(at, next), next});
    }
    sides.push_back({at, first});
  }
  result.points = points.all();
  for (Outline& outline : result.outlines) cancel(outline.sides);
  constexpr int most_rounds = 10;
  const double tolerance = convex::tolerance(planes);
  for (int round = 0; round < most_rounds && end_at_points(result, tolerance); ++round) {
  }
  if (open_side(result)) return std::nullopt;
  join_straight(result, straight_tolerance * planes.diagonal());
  std::erase_if(result.outlines, [](const Outline& outline) { return outline.sides.empty(); });
  return result;
}

}  // namespace csgsim::software::convert

#include "host/facet/planes.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <utility>

namespace csgsim::facet {

namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<double, 4, bg::cs::cartesian>;
using Box = bg::model::box<Point>;
using Entry = std::pair<Point, std::uint32_t>;

/// Components this near to 0 do not decide a canonical orientation.
constexpr double zero_component = 4.0 * coincidence_tolerance;

bool points_backward(const glm::dvec3& normal) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) > zero_component) return normal[axis] < 0.0;
  }
  return false;
}

Point key(const Plane& plane, double diagonal, double shift) {
  Point point;
  bg::set<0>(point, plane.normal.x + shift);
  bg::set<1>(point, plane.normal.y + shift);
  bg::set<2>(point, plane.normal.z + shift);
  bg::set<3>(point, plane.offset / diagonal + shift);
  return point;
}

}  // namespace

struct PlaneTable::Index {
  bg::index::rtree<Entry, bg::index::quadratic<16>> tree;
};

PlaneTable::PlaneTable(const glm::dvec3& centre, double diagonal)
    : centre_(centre), diagonal_(diagonal > 0.0 ? diagonal : 1.0), index_(std::make_unique<Index>()) {}
PlaneTable::~PlaneTable() = default;
PlaneTable::PlaneTable(PlaneTable&&) noexcept = default;
PlaneTable& PlaneTable::operator=(PlaneTable&&) noexcept = default;

Halfspace PlaneTable::add(const Plane& plane) {
  Plane canonical{plane.normal, plane.offset + glm::dot(plane.normal, centre_)};
  const bool positive = !points_backward(canonical.normal);
  if (!positive) canonical = {-canonical.normal, -canonical.offset};

  const Box near(key(canonical, diagonal_, -coincidence_tolerance), key(canonical, diagonal_, coincidence_tolerance));
  std::vector<Entry> found;
  index_->tree.query(bg::index::intersects(near), std::back_inserter(found));
  if (!found.empty()) {
    std::uint32_t first = found.front().second;
    for (const Entry& entry : found) first = std::min(first, entry.second);
    return {first, positive};
  }
  const auto added = static_cast<std::uint32_t>(planes_.size());
  planes_.push_back(canonical);
  index_->tree.insert({key(canonical, diagonal_, 0.0), added});
  return {added, positive};
}

}  // namespace csgsim::facet

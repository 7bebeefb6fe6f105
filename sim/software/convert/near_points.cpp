#include "sim/software/convert/near_points.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "host/facet/geometry.h"

namespace csgsim::software::convert {

namespace {

namespace bg = boost::geometry;
using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using Item = std::pair<Corner, std::uint32_t>;

Corner corner_of(const glm::dvec3& point) { return {point.x, point.y, point.z}; }

std::vector<Item> items(std::span<const glm::dvec3> points, std::span<const std::uint32_t> used) {
  std::vector<Item> items;
  items.reserve(used.size());
  for (const std::uint32_t point : used) items.emplace_back(corner_of(points[point]), point);
  return items;
}

double size_of(std::span<const glm::dvec3> points, std::span<const std::uint32_t> used) {
  facet::Box box;
  for (const std::uint32_t point : used) box = facet::hull(box, {points[point], points[point]});
  return box.empty() ? 0 : box.diagonal();
}

}  // namespace

struct NearPoints::Index {
  bg::index::rtree<Item, bg::index::quadratic<16>> tree;
};

NearPoints::NearPoints(std::span<const glm::dvec3> points, std::span<const std::uint32_t> used)
    : points_(points),
      size_(size_of(points, used)),
      index_(std::make_unique<Index>(Index{decltype(Index::tree)(items(points, used))})) {}

NearPoints::~NearPoints() = default;

std::vector<PointAlong> NearPoints::beside(std::uint32_t from, std::uint32_t to, double distance) const {
  const glm::dvec3 start = points_[from];
  const glm::dvec3 way = points_[to] - start;
  const double length = glm::length(way);
  std::vector<PointAlong> found;
  // Oblique lines are searched in pieces, whose boxes contain fewer points.
  const glm::dvec3 across = glm::abs(way);
  const double widest = std::max({across.x, across.y, across.z});
  const double second = across.x + across.y + across.z - widest - std::min({across.x, across.y, across.z});
  const int pieces = second > distance ? static_cast<int>(std::ceil(8.0 * std::min(1.0, 4.0 * length / size_))) : 1;
  for (int piece = 0; piece < pieces; ++piece) {
    const glm::dvec3 one = start + way * (static_cast<double>(piece) / pieces);
    const glm::dvec3 other = start + way * (static_cast<double>(piece + 1) / pieces);
    const bg::model::box<Corner> box(corner_of(glm::min(one, other) - distance),
                                     corner_of(glm::max(one, other) + distance));
    const auto add = [&](const Item& item) {
      const std::uint32_t point = item.second;
      if (point == from || point == to) return;
      const double along = length > 0 ? glm::dot(points_[point] - start, way) / (length * length) : 0;
      if (glm::distance(points_[point], start + along * way) <= distance) found.push_back({along, point});
    };
    index_->tree.query(bg::index::intersects(box), boost::make_function_output_iterator(add));
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace csgsim::software::convert

#include "host/csg/box_index.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <utility>

namespace csgsim::csg {

namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<float, 4, bg::cs::cartesian>;
using Bounds = bg::model::box<Point>;
using Item = std::pair<Bounds, std::uint32_t>;

Point to_point(const std::array<float, 4>& coordinates) {
  Point point;
  bg::set<0>(point, coordinates[0]);
  bg::set<1>(point, coordinates[1]);
  bg::set<2>(point, coordinates[2]);
  bg::set<3>(point, coordinates[3]);
  return point;
}

Bounds to_bounds(const BoxIndex::Box& box) { return {to_point(box.low), to_point(box.high)}; }

/// Scale factors, a power of two for each axis, so that distinct coordinates stay distinct.
using Scale = std::array<float, 4>;

BoxIndex::Box scaled(BoxIndex::Box box, const Scale& scale) {
  for (std::size_t axis = 0; axis < scale.size(); ++axis) {
    box.low[axis] *= scale[axis];
    box.high[axis] *= scale[axis];
  }
  return box;
}

/// Scales all axes to about the same extent. The tree is split across the longest axis, which would otherwise always be
/// the depths.
Scale choose_scale(std::span<const BoxIndex::Entry> entries) {
  Scale scale{1, 1, 1, 1};
  for (std::size_t axis = 0; !entries.empty() && axis < scale.size(); ++axis) {
    float low = entries.front().box.low[axis];
    float high = entries.front().box.high[axis];
    for (const BoxIndex::Entry& entry : entries) {
      low = std::min(low, entry.box.low[axis]);
      high = std::max(high, entry.box.high[axis]);
    }
    if (high > low) scale[axis] = std::ldexp(1.0F, -std::ilogb(high - low));
  }
  return scale;
}

std::vector<Item> make_items(std::span<const BoxIndex::Entry> entries, const Scale& scale) {
  std::vector<Item> items;
  items.reserve(entries.size());
  for (const BoxIndex::Entry& entry : entries) items.emplace_back(to_bounds(scaled(entry.box, scale)), entry.number);
  return items;
}

constexpr std::size_t fan_out = 16;

using Items = bg::index::rtree<Item, bg::index::quadratic<fan_out>>;

/// Appends the numbers in an order that depends on how the standard library partitions equal elements.
template <class Predicate>
void append_found(const Items& items, const Predicate& predicate, std::vector<std::uint32_t>& numbers) {
  const auto append = [&](const Item& item) { numbers.push_back(item.second); };
  items.query(predicate, boost::make_function_output_iterator(append));
}

}  // namespace

struct BoxIndex::Tree {
  explicit Tree(std::span<const Entry> entries) : scale(choose_scale(entries)), items(make_items(entries, scale)) {}

  [[nodiscard]] Bounds bounds(const Box& box) const { return to_bounds(scaled(box, scale)); }

  Scale scale;
  Items items;
};

BoxIndex::BoxIndex(std::span<const Entry> entries) : tree_(std::make_shared<const Tree>(entries)) {}

std::uint64_t BoxIndex::path_boxes() const {
  std::uint64_t boxes = 0;
  for (std::size_t left = tree_->items.size(); left > 0; left = left > fan_out ? (left + fan_out - 1) / fan_out : 0)
    boxes += std::min(left, fan_out);
  return boxes;
}

void BoxIndex::meeting(const Box& box, std::vector<std::uint32_t>& numbers) const {
  const auto begin = static_cast<std::ptrdiff_t>(numbers.size());
  append_found(tree_->items, bg::index::intersects(tree_->bounds(box)), numbers);
  std::sort(numbers.begin() + begin, numbers.end());
}

std::vector<std::uint32_t> BoxIndex::covering(const Box& box, std::size_t max_count) const {
  std::vector<std::uint32_t> numbers;
  append_found(tree_->items, bg::index::covers(tree_->bounds(box)), numbers);
  const std::size_t count = std::min(max_count, numbers.size());
  std::partial_sort(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(count), numbers.end());
  numbers.resize(count);
  return numbers;
}

BoxIndex::Box picture_box(const view::PixelRect& pixels, std::int64_t z_low, std::int64_t z_high, std::uint32_t first,
                          std::uint32_t last) {
  const auto [nearest, farthest] = std::minmax(z_low, z_high);
  return {{static_cast<float>(pixels.x0), static_cast<float>(pixels.y0), static_cast<float>(nearest),
           static_cast<float>(first)},
          {static_cast<float>(pixels.x1), static_cast<float>(pixels.y1), static_cast<float>(farthest),
           static_cast<float>(last)}};
}

}  // namespace csgsim::csg

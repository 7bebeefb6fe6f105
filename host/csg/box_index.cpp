#include "host/csg/box_index.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <utility>

namespace csgsim::csg {

namespace {

namespace bg = boost::geometry;
using Point = bg::model::point<float, 4, bg::cs::cartesian>;
using Bounds = bg::model::box<Point>;
using Item = std::pair<Bounds, std::uint32_t>;

Point point_of(const std::array<float, 4>& coordinates) {
  Point point;
  bg::set<0>(point, coordinates[0]);
  bg::set<1>(point, coordinates[1]);
  bg::set<2>(point, coordinates[2]);
  bg::set<3>(point, coordinates[3]);
  return point;
}

Bounds bounds_of(const BoxIndex::Box& box) { return {point_of(box.low), point_of(box.high)}; }

std::vector<Item> items_of(std::span<const BoxIndex::Entry> entries) {
  std::vector<Item> items;
  items.reserve(entries.size());
  for (const BoxIndex::Entry& entry : entries) items.emplace_back(bounds_of(entry.box), entry.number);
  return items;
}

constexpr std::size_t fan_out = 16;

using Items = bg::index::rtree<Item, bg::index::quadratic<fan_out>>;

/// In an order that depends on how the standard library parts what is equal, when the tree is made.
template <class Predicate>
void append_found(const Items& items, const Predicate& predicate, std::vector<std::uint32_t>& numbers) {
  const auto append = [&](const Item& item) { numbers.push_back(item.second); };
  items.query(predicate, boost::make_function_output_iterator(append));
}

}  // namespace

struct BoxIndex::Tree {
  Items items;
};

BoxIndex::BoxIndex(std::span<const Entry> entries)
    : tree_(std::make_shared<const Tree>(Tree{Items(items_of(entries))})) {}

std::uint64_t BoxIndex::boxes_of_way() const {
  std::uint64_t boxes = 0;
  for (std::size_t left = tree_->items.size(); left > 0; left = left > fan_out ? (left + fan_out - 1) / fan_out : 0)
    boxes += std::min(left, fan_out);
  return boxes;
}

void BoxIndex::meeting(const Box& box, std::vector<std::uint32_t>& numbers) const {
  const auto begin = static_cast<std::ptrdiff_t>(numbers.size());
  append_found(tree_->items, bg::index::intersects(bounds_of(box)), numbers);
  std::sort(numbers.begin() + begin, numbers.end());
}

std::vector<std::uint32_t> BoxIndex::covering(const Box& box, std::size_t most) const {
  std::vector<std::uint32_t> numbers;
  append_found(tree_->items, bg::index::covers(bounds_of(box)), numbers);
  const std::size_t count = std::min(most, numbers.size());
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

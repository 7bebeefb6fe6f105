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

}  // namespace

struct BoxIndex::Tree {
  bg::index::rtree<Item, bg::index::quadratic<fan_out>> items;
};

BoxIndex::BoxIndex(std::span<const Entry> entries)
    : tree_(std::make_shared<const Tree>(Tree{decltype(Tree::items)(items_of(entries))})) {}

std::uint64_t BoxIndex::boxes_of_way() const {
  std::uint64_t boxes = 0;
  for (std::size_t left = tree_->items.size(); left > 0; left = left > fan_out ? (left + fan_out - 1) / fan_out : 0)
    boxes += std::min(left, fan_out);
  return boxes;
}

void BoxIndex::meeting(const Box& box, std::vector<std::uint32_t>& numbers) const {
  const auto append = [&](const Item& item) { numbers.push_back(item.second); };
  tree_->items.query(bg::index::intersects(bounds_of(box)), boost::make_function_output_iterator(append));
}

bool BoxIndex::any_covering(const Box& box, std::size_t most,
                            const std::function<bool(std::uint32_t number)>& test) const {
  const auto end = tree_->items.qend();
  for (auto item = tree_->items.qbegin(bg::index::covers(bounds_of(box))); item != end && most > 0; ++item, --most) {
    if (test(item->second)) return true;
  }
  return false;
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

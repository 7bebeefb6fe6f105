#include "host/emit/region_index.h"

namespace csgsim::emit {

namespace {

csg::BoxIndex index_of(std::span<const isa::Region> regions) {
  std::vector<csg::BoxIndex::Entry> entries;
  for (const isa::Region& region : regions)
    entries.push_back({csg::picture_box(region_pixels(region), 0, 0), static_cast<std::uint32_t>(entries.size())});
  return csg::BoxIndex(entries);
}

}  // namespace

view::PixelRect region_pixels(const isa::Region& region) {
  const auto x = static_cast<std::int32_t>(region.x);
  const auto y = static_cast<std::int32_t>(region.y);
  return {x, y, x + static_cast<std::int32_t>(region.width) - 1, y + static_cast<std::int32_t>(region.height) - 1};
}

RegionIndex::RegionIndex(std::span<const isa::Region> regions) : index_(index_of(regions)) {}

std::vector<std::vector<std::uint32_t>> sets_by_region(std::span<const isa::Region> regions,
                                                       std::span<const csg::ConvexSet> sets, const view::View& view) {
  std::vector<std::vector<std::uint32_t>> found(regions.size());
  RegionIndex index(regions);
  for (std::uint32_t i = 0; i < sets.size(); ++i) {
    view::PixelRect pixels = view.extents[sets[i].front()].pixels;
    for (const std::uint32_t primitive : sets[i]) pixels = common(pixels, view.extents[primitive].pixels);
    index.for_each(pixels, [&](std::uint32_t region) { found[region].push_back(i); });
  }
  return found;
}

}  // namespace csgsim::emit

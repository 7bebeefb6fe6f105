#include "sim/software/methods/known.h"

#include <cstddef>

namespace csgsim::software {

namespace {

bool are_apart(const view::Extent& a, const view::Extent& b) {
  return view::common(a.pixels, b.pixels).empty() || a.z_high < b.z_low || b.z_high < a.z_low;
}

}  // namespace

std::vector<Known> known_in(const view::View& view, const RayBand& band, std::uint32_t first_column,
                            std::uint32_t columns) {
  const auto x0 = static_cast<std::int32_t>(first_column);
  const auto y0 = static_cast<std::int32_t>(band.first_row);
  const view::PixelRect cell{x0, y0, x0 + static_cast<std::int32_t>(columns) - 1,
                             y0 + static_cast<std::int32_t>(band.rows) - 1};
  std::vector<Known> known(view.extents.size(), Known::out);
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (!view::common(view.extents[i].pixels, cell).empty()) known[i] = Known::nothing;
  }
  return known;
}

std::vector<Known> known_inside(const view::View& view, std::uint32_t primitive) {
  std::vector<Known> known(view.extents.size(), Known::out);
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (!are_apart(view.extents[i], view.extents[primitive])) known[i] = Known::nothing;
  }
  known[primitive] = Known::in;
  return known;
}

}  // namespace csgsim::software

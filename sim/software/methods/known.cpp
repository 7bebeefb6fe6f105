#include "sim/software/methods/known.h"

#include <cstddef>

#include "host/csg/separation.h"

namespace csgsim::software {

std::vector<Known> classes_in_cell(const view::View& view, const RayBand& band, std::uint32_t first_column,
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

std::vector<Known> classes_inside(const view::View& view, std::uint32_t primitive) {
  csg::Pruning by_picture = csg::Pruning::none();
  by_picture.picture = true;
  std::vector<Known> known(view.extents.size(), Known::out);
  for (std::uint32_t other = 0; other < known.size(); ++other) {
    if (!csg::disjoint(view, other, primitive, by_picture)) known[other] = Known::nothing;
  }
  known[primitive] = Known::in;
  return known;
}

}  // namespace csgsim::software

#include "sim/software/methods/known.h"

#include "sim/software/rays/caster.h"
#include "tests/support/test.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using software::Interval;
using software::Known;
using testing::Scene;

namespace {

bool meet(const Interval& a, const Interval& b) { return a.front < b.back && b.front < a.back; }

/// Counts pairs of primitives that meet on a ray although classified as disjoint.
std::uint64_t wrongly_apart(std::span<const Interval> intervals, const std::vector<std::vector<Known>>& inside) {
  std::uint64_t wrong = 0;
  for (const Interval& a : intervals) {
    for (const Interval& b : intervals) wrong += meet(a, b) && inside[a.primitive][b.primitive] == Known::out ? 1U : 0U;
  }
  return wrong;
}

/// Counts wrong classifications: those of primitives with pixels in the cell must be undecided, all others `out`.
std::uint64_t wrong_in_cell(const view::View& view, const software::RayBand& band, std::uint32_t first_column) {
  const std::vector<Known> known = software::classes_in_cell(view, band, first_column, software::cell_columns);
  std::uint64_t wrong = 0;
  for (std::size_t i = 0; i < known.size(); ++i) {
    const view::PixelRect& pixels = view.extents[i].pixels;
    const auto x = static_cast<std::int32_t>(first_column);
    const auto y = static_cast<std::int32_t>(band.first_row);
    const bool has_pixels = pixels.x1 >= x && pixels.x0 < x + 16 && pixels.y1 >= y &&
                            pixels.y0 < y + static_cast<std::int32_t>(band.rows) && pixels.x1 >= pixels.x0 &&
                            pixels.y1 >= pixels.y0;
    wrong += known[i] != (has_pixels ? Known::nothing : Known::out) ? 1U : 0U;
  }
  return wrong;
}

struct Tally {
  std::uint64_t apart = 0;
  std::uint64_t pairs = 0;
};

void check_scene(const Scene& scene, Tally& tally) {
  const software::RayCaster rays(scene.tree, scene.geometry, scene.view);
  std::vector<std::vector<Known>> inside;
  for (std::uint32_t primitive = 0; primitive < scene.tree.primitives.size(); ++primitive) {
    inside.push_back(software::classes_inside(scene.view, primitive));
    for (std::uint32_t other = 0; other < inside.back().size(); ++other) {
      const Known known = inside.back()[other];
      CHECK((known == Known::in) == (other == primitive));
      tally.apart += known == Known::out ? 1U : 0U;
      ++tally.pairs;
    }
  }
  software::RayBand band;
  for (std::uint32_t row = 0; row < rays.height(); row += software::band_rows) {
    rays.cast(row, band);
    std::uint64_t wrong = 0;
    for (std::size_t ray = 0; ray < band.rays(); ++ray) wrong += wrongly_apart(band.intervals_of(ray), inside);
    CHECK(wrong == 0);
    for (std::uint32_t column = 0; column < rays.width(); column += 16)
      CHECK(wrong_in_cell(scene.view, band, column) == 0);
  }
}

}  // namespace

TEST_CASE("primitives classified before rays are cast have that class on every ray") {
  Tally tally;
  for (std::uint64_t seed = 7001; seed <= 7100; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene) continue;
    CAPTURE(seed);
    check_scene(*scene, tally);
  }
  CHECK(tally.apart > tally.pairs / 10);
}

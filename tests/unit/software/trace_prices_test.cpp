// Costs of tracing one block, recounted from its pixels and calculated by hand in clocks of an MC68000 programmed in
// assembly (prices in block_prices_test.cpp).

#include "host/read/read.h"
#include "hw/processors/processor.h"
#include "sim/software/tracing/trace.h"
#include "sim/software/tree/tree.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;

namespace {

constexpr std::int32_t width = 64;
constexpr std::int32_t height = 48;
constexpr double pixels = width * height;

testing::Scene block_scene() {
  view::Sampling sampling;
  sampling.width = width;
  sampling.height = height;
  sampling.z_bits = 20;
  sampling.fraction_bits = 12;
  const view::Camera front{{0, -60, 0}, {0, 0, 0}, view::Projection::orthographic};
  return testing::make_scene(read::read_csg_text("cube(size=[8,8,8],center=true);", "block"), front, sampling);
}

/// A block seen from the front: two of its six faces are in the picture.
struct Block {
  testing::Scene scene = block_scene();
  software::Tree tree = software::make_tree(scene.tree, software::Shape::written);
  software::TraceScene traced{scene.tree, scene.geometry, scene.view, tree};

  [[nodiscard]] software::TraceCounts counts(const software::TraceOptions& options) const {
    const auto space = software::directory_of("none").make(traced.shapes(), {8});
    return software::trace(traced, *space, options, true).counts;
  }
  [[nodiscard]] std::span<const software::ScreenFacet> faces() const { return traced.screen().facets; }
  [[nodiscard]] bool is_back_first() const { return faces()[0].leaves; }
  [[nodiscard]] double bounds(std::size_t face) const {
    return static_cast<double>(traced.screen().bounds_of(faces()[face]).size());
  }
  [[nodiscard]] bool is_on(const software::ScreenFacet& face, std::int32_t column, std::int32_t row) const {
    return traced.screen().event_at(face, column, row).has_value();
  }
};

double clocks(const software::Operations& operations) {
  return processors::clocks(operations, processors::load_processor("mc68000+compiler.factor=1000"));
}

double hits_of(const Block& block) {
  double hits = 0;
  for (std::int32_t row = 0; row < height; ++row) {
    for (std::int32_t column = 0; column < width; ++column) hits += block.is_on(block.faces()[0], column, row) ? 1 : 0;
  }
  return hits;
}

constexpr double product = 4 * 70 + 3 * 8 + 2 * 4;
constexpr double quotient = 2 * 140 + 2 * 70 + 2 * 8;
constexpr double comparison = 16 + 6 + 8;
constexpr double distance = 6 * product + quotient + 2 * comparison;

/// A ray checks once for each of six facets whether it has been tested; two are in the picture, and tested by a call.
constexpr double mailbox_checks = 6 * ((2 * 16 + 6 + 8 + 16) + (2 * 16 + 2 * 8)) + 2 * (18 + 16);

/// An event is inserted in order among two, and taken from them when the ray is settled to its end.
double kept(const Block& block) {
  constexpr double put = 16 + 6 + 2 * 16 + 10;
  constexpr double moved = 16 + 6 + 2 * 16 + 10;
  return 2 * put + (block.is_back_first() ? moved : 0) + 3 * (6 + 8);
}
constexpr double none_kept = 6 + 8;

/// Edges of a face tested in the plane of the picture: all if the ray passes through the face, else those up to the
/// first with the ray on another side.
double tested_edges(std::span<const glm::dvec3> corners, const glm::dvec3& at) {
  double edges = 0;
  double side = 0;
  glm::dvec3 from = corners.back();
  for (const glm::dvec3& to : corners) {
    const double area = (from.x - at.x) * (to.z - at.z) - (from.z - at.z) * (to.x - at.x);
    ++edges;
    if (side * area < 0) return edges;
    side = area;
    from = to;
  }
  return edges;
}

/// A tree of one leaf is inverted, evaluated and inverted again by three calls.
constexpr double alone = 2 * (18 + 16 + 4 + 16 + 12 + 4 + 12 + 10) + 18 + 12 + 16;

}  // namespace

TEST_CASE("primary rays tested in space take the hand-calculated clocks") {
  const Block block;
  REQUIRE(block.faces().size() == 2);
  const double hits = hits_of(block);
  REQUIRE(hits > 100);
  const software::TraceCounts counts = block.counts({});
  CHECK(clocks(counts.projection) == 0);
  double edges = 0;
  for (std::int32_t row = 0; row < height; ++row) {
    for (std::int32_t column = 0; column < width; ++column) {
      const glm::dvec3 at = block.traced.ray_of(column, row).origin;
      for (const software::ScreenFacet& face : block.faces())
        edges += tested_edges(block.traced.facets().corners_of(face.facet), at);
    }
  }
  constexpr double edge = 4 * product + 3 * 16 + 6 * 8 + 8;
  CHECK(clocks(counts.intersection) == pixels * (mailbox_checks + 2 * 2 * product) + edges * edge +
                                           2 * hits * distance + hits * kept(block) + (pixels - hits) * none_kept);
  // The surface in front is found in the list structure: inserted and looked up once.
  constexpr double once = (18 + 2 * 12 + 4 * 16 + 8 + 16) + (2 * 12 + 4 + 12) + alone;
  constexpr double classified = 16 + 6 + 8 + (6 + 8 + 4 + 16 + 6 + 8) + (12 + 4 + 8) + (2 * 12 + 4 + 8);
  CHECK(clocks(counts.classification.operations) == once + hits * classified);
  CHECK(clocks(counts.shading) == pixels * (3 * 16 + 10));
  CHECK(counts.words == 6 + 12);  // a mailbox per facet; the list structure and the tree
}
TEST_CASE("primary rays tested in the picture take the hand-calculated clocks") {
  const Block block;
  const double hits = hits_of(block);
  software::TraceOptions options;
  options.facet_test = software::FacetTest::projected;
  const software::TraceCounts counts = block.counts(options);
  // Six faces of four corners, two planes and their edges are transformed into the picture.
  const auto linears = static_cast<double>(block.traced.screen().linears.size());
  constexpr double long_product = 4 * 70 + 5 * 8 + 2 * 16;
  constexpr double long_quotient = 2 * 70 + 2 * 140 + 2 * 8 + 2 * 16;
  CHECK(clocks(counts.projection) == (9 * 24 + 6 * 2 + 2 * linears) * long_product + (2 * 24 + 3 * 2) * long_quotient +
                                         16 * (3 * 24 + 6 * 2 + 6 * linears) + (24 + 2 + linears) * (18 + 16));
  constexpr double rectangle = 4 * 12 + 4 * 4 + 4 * 8;
  // A value of two longs takes three coefficients, and two products of words for each long of two.
  constexpr double value = 6 * 16 + 8 * 70 + 8 * 8 + 4 + 8;
  double values = 0;
  double shifts = 0;
  for (const software::ScreenFacet& face : block.faces()) {
    for (std::int32_t row = face.pixels.y0; row <= face.pixels.y1; ++row) {
      for (std::int32_t column = face.pixels.x0; column <= face.pixels.x1; ++column) {
        const std::span<const view::FixedLinear> bounds = block.traced.screen().bounds_of(face);
        const auto failed = std::ranges::find_if(
            bounds, [&](const view::FixedLinear& bound) { return value_at(bound, column, row) < 0; });
        values += static_cast<double>(failed - bounds.begin()) + 1;
        shifts += failed == bounds.end() ? 1 : 0;
      }
    }
  }
  CHECK(clocks(counts.intersection) == pixels * (mailbox_checks + 2 * rectangle) + values * value +
                                           shifts * (8 + 2 * 12) + hits * kept(block) + (pixels - hits) * none_kept);
}
TEST_CASE("an item buffer takes the hand-calculated clocks of its pass and of the pixels") {
  const Block block;
  const double hits = hits_of(block);
  software::TraceOptions options;
  options.item_pass = software::ItemPass::list_priority;
  options.list_priority.operations.counts[static_cast<std::size_t>(software::Operation::multiply)] = 1000;
  options.list_priority.events = 77;
  options.list_priority.words = 5;
  const software::TraceCounts counts = block.counts(options);
  CHECK(clocks(counts.projection) == 1000 * 70 + hits * 16);
  CHECK(clocks(counts.intersection) == pixels * (16 + 6 + 8) + hits * distance);
  CHECK(clocks(counts.classification.operations) == alone);  // initialization of the tracer's own list structure
  CHECK(counts.items == 77);
  CHECK(static_cast<double>(counts.words) == 5 + 6 + 12 + 2 * pixels);
  options.item_pass = software::ItemPass::depth_lists;
  const software::TraceCounts by_lists = block.counts(options);
  const auto rows = static_cast<double>(block.faces()[0].pixels.y1 - block.faces()[0].pixels.y0 + 1);
  const auto linears = static_cast<double>(block.traced.screen().linears.size());
  constexpr double long_product = 4 * 70 + 5 * 8 + 2 * 16;
  constexpr double long_quotient = 2 * 70 + 2 * 140 + 2 * 8 + 2 * 16;
  const double projected = (9 * 24 + 6 * 2 + 2 * linears) * long_product + (2 * 24 + 3 * 2) * long_quotient +
                           16 * (3 * 24 + 6 * 2 + 6 * linears) + (24 + 2 + linears) * (18 + 16);
  constexpr double row = 4 * 16 + 2 * 8;
  constexpr double row_edge = 6 * 16 + 2 * 140 + 2 * 70 + 4 * 8 + 4 + 8;
  constexpr double column = 2 * 8 + 2 * (8 + 2 * 12) + 2 * 6 + 2 * 8 + 2 * 16 + 10;
  double compared = 0;  // clocks of the library's sort of two
  std::vector<int> two = block.is_back_first() ? std::vector<int>{2, 1} : std::vector<int>{1, 2};
  std::sort(two.begin(), two.end(), [&](int a, int b) {
    ++compared;
    return a < b;
  });
  CHECK(clocks(by_lists.projection) == projected + rows * (2 * row + (block.bounds(0) + block.bounds(1)) * row_edge) +
                                           2 * hits * column + hits * compared * (2 * 16 + 6 + 10 + 16) +
                                           pixels * 2 * 16);
  CHECK(by_lists.items == 2 * static_cast<std::uint64_t>(hits));
}

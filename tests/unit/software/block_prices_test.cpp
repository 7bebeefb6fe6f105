// Hand-calculated cost of each method for one block seen from the front, in clocks of an MC68000 programmed in
// assembly: a word read or written 12, a long 16; words added or compared 4, longs added 8 and compared 6; a product
// 70, a quotient 140; a shift 8 and 2 per place; a branch 8, taken 10; a call 18, its return 16.

#include "host/read/read.h"
#include "hw/processors/processor.h"
#include "sim/software/display/rows.h"
#include "sim/software/facets/screen_facets.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/software/scenes.h"
#include "tests/unit/software/shown.h"

using namespace csgsim;
using software::Phase;

namespace {

constexpr double width = 64;
constexpr double height = 48;
constexpr double pixels = width * height;

testing::Scene block_scene() {
  view::Sampling sampling;
  sampling.width = static_cast<std::uint32_t>(width);
  sampling.height = static_cast<std::uint32_t>(height);
  sampling.z_bits = 20;
  sampling.fraction_bits = 12;
  const view::Camera front{{0, -60, 0}, {0, 0, 0}, view::Projection::orthographic};
  return testing::make_scene(read::read_csg_text("cube(size=[8,8,8],center=true);", "block"), front, sampling);
}

/// The front and the back are in the picture; the other four faces are edge-on.
struct Block {
  testing::Scene scene = block_scene();
  testing::Shown shown{scene};
  software::ScreenFacets seen = software::screen_facets(scene.tree, scene.geometry, scene.view, shown.facets);

  [[nodiscard]] double bounds() const {
    return static_cast<double>(seen.bounds_of(seen.facets[0]).size() + seen.bounds_of(seen.facets[1]).size());
  }
  [[nodiscard]] double linears() const { return static_cast<double>(seen.linears.size()); }
  [[nodiscard]] bool is_back_first() const { return seen.facets[0].leaves; }
  [[nodiscard]] software::DisplayCounts counts(const char* method) const { return shown.by(method).counts; }
};

/// Columns and rows of the square that is drawn, and its pixels.
struct Square {
  double columns = 0;
  double rows = 0;
  double pixels = 0;
};

Square square_of(const Block& block) {
  const software::Picture picture = block.shown.by("depth-lists").picture;
  Square square;
  for (std::size_t row = 0; row < static_cast<std::size_t>(height); ++row) {
    const auto first = picture.seen.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(width));
    const auto columns =
        static_cast<double>(std::count_if(first, first + static_cast<std::ptrdiff_t>(width),
                                          [](const software::VisibleSurface& seen) { return seen.owner == 0; }));
    if (columns == 0) continue;
    square.columns = columns;
    square.rows += 1;
  }
  square.pixels = square.columns * square.rows;
  return square;
}

double clocks(const software::DisplayCounts& counts, Phase phase) {
  return processors::clocks(counts.of(phase), processors::load_processor("mc68000+compiler.factor=1000"));
}

// A depth has 20 bits, 12 bits of fraction and a sign: two longs.
/// Edge setup: three coefficients read; two values by four products; two quotients of two digits with a product each;
/// sums; four longs written.
constexpr double edge = 6 * 16 + 4 * 70 + 4 * 140 + 4 * 70 + 8 * 8 + 4 * 16;
/// Step to the next row: column and remainder of an edge; the columns between edges, and the depth at the first of
/// them.
constexpr double row_edge = 4 * 16 + 2 * 8 + 6 + 2 * 16 + 4 + 2 * 8;
constexpr double row = 4 * 16 + 2 * 8 + 2 * 16 + 4 + 8 + 10;
constexpr double column = 10;
/// The slope is added, both longs are shifted by 12 places, and the depth is compared with both ends of its range.
constexpr double depth = 2 * 8 + 2 * (8 + 2 * 12) + 2 * 6 + 2 * 8;

/// The status tree of one leaf is inverted, evaluated and inverted again to find what is behind a first surface: three
/// calls.
constexpr double flip = 18 + 16 + 4 + 16 + 12 + 4 + 12 + 10;
constexpr double alone = 2 * flip + 18 + 12 + 16;
constexpr double first_element = 6 + 8 + 4 + 16 + 6 + 8;
constexpr double element_made = 18 + 2 * 12 + 4 * 16 + 8 + 16;
constexpr double class_read = 12 + 4 + 8;
/// The class is first looked up in the table of first surfaces and kept.
constexpr double class_found = 2 * 12 + 4 + 12;
constexpr double owner = 2 * 12 + 4 + 8;
/// Separation of the events at one depth from the next.
constexpr double point = 2 * 16 + 6 + 8;

/// Scan conversion of both faces of the block.
double scans(const Block& block, const Square& square) {
  return block.bounds() * edge + 2 * square.rows * row + square.rows * block.bounds() * row_edge +
         2 * square.pixels * column;
}

/// Transformation of corners, planes and edges into the picture.
double transformed(double corners, double planes, double edges) {
  constexpr double product = 4 * 70 + 5 * 8 + 2 * 16;
  constexpr double quotient = 2 * 70 + 2 * 140 + 2 * 8 + 2 * 16;
  return (9 * corners + 6 * planes + 2 * edges) * product + (2 * corners + 3 * planes) * quotient +
         (3 * corners + 6 * planes + 6 * edges) * 16 + (corners + planes + edges) * (18 + 16);
}

/// Clearing the picture: two longs per pixel.
constexpr double cleared = 2 * 16 + 10;

/// The table of first surfaces, the initial elements of sequences, and per element three pointers and a class; a node
/// has its kind and two operands, in a status tree also its father and status, and a primitive its leaf.
constexpr std::uint64_t words_of_sequences = 1 + 1 + 4 + (3 + 2 + 1);

}  // namespace

TEST_CASE("the block of the price tests has two faces that are not edge-on") {
  const Block block;
  REQUIRE(block.seen.facets.size() == 2);
  CHECK(block.seen.facets[0].leaves != block.seen.facets[1].leaves);
  const Square square = square_of(block);
  CHECK(square.pixels > 100);
  for (const software::ScreenFacet& facet : block.seen.facets)
    CHECK(facet.pixels.y1 - facet.pixels.y0 + 1 == static_cast<std::int32_t>(square.rows));
}
TEST_CASE("depth lists of one block take the hand-calculated clocks") {
  const Block block;
  const Square square = square_of(block);
  const software::DisplayCounts counts = block.counts("depth-lists");
  CHECK(clocks(counts, Phase::preprocessing) == 0);
  CHECK(clocks(counts, Phase::transformation) == transformed(6 * 4, 2, block.linears()));
  CHECK(clocks(counts, Phase::initialisation) == pixels * (cleared + 16));
  CHECK(clocks(counts, Phase::depth_test) == 2 * square.pixels * depth);
  constexpr double put_in = 16 + 3 * 16 + 12 + 2 * 8;
  constexpr double classified = first_element + point + class_read + owner;
  CHECK(clocks(counts, Phase::scan_conversion) == scans(block, square) + 2 * square.pixels * put_in + alone +
                                                      element_made + class_found + square.pixels * classified +
                                                      pixels * 2 * 16);
  constexpr double gathered = 2 * 16 + 12 + 16 + 12 + 10;
  constexpr double moved = 2 * 16 + 6 + 2 * 16 + 2 * 10;
  const double sorted = 2 * 16 + 16 + 6 + 8 + 2 * 16 + (block.is_back_first() ? moved : 0);
  CHECK(clocks(counts, Phase::sorting) == pixels * (16 + 8) + square.pixels * (2 * gathered + sorted));
  CHECK(counts.words.polygons == 3 * 24 + 6 * block.seen.linears.size() + 10 * 2);
  CHECK(counts.words.buckets == 0);
  CHECK(static_cast<double>(counts.words.pixels) == 2 * pixels + pixels + 3 * 2 * square.pixels);
  CHECK(counts.words.sequences == words_of_sequences);
}
TEST_CASE("depth peeling of one block takes the hand-calculated clocks") {
  const Block block;
  const Square square = square_of(block);
  const software::DisplayCounts counts = block.counts("depth-peeling");
  REQUIRE(counts.passes == 2);
  CHECK(clocks(counts, Phase::preprocessing) == 0);
  CHECK(clocks(counts, Phase::transformation) == transformed(6 * 4, 2, block.linears()));
  CHECK(clocks(counts, Phase::sorting) == 0);
  CHECK(clocks(counts, Phase::initialisation) == pixels * (cleared + 3 * 16 + 12));
  constexpr double held_against = 2 * 16 + 2 * 6 + 10;
  constexpr double is_nearest = 8 + 16;
  constexpr double held_again = 16 + 6 + 8;
  const double nearest = block.is_back_first() ? 2 : 1;
  CHECK(clocks(counts, Phase::depth_test) ==
        square.pixels * (4 * depth + 2 * held_against + nearest * is_nearest + 2 * held_again));
  constexpr double taken = 16 + first_element + 12 + 4 + 12 + 16;
  constexpr double looked_at = 12 + 8 + 10;
  constexpr double set = class_read + owner + 2 * 16 + 2 * 16 + 12;
  CHECK(clocks(counts, Phase::scan_conversion) == 2 * scans(block, square) + alone + element_made + class_found +
                                                      square.pixels * (taken + set) + pixels * looked_at);
  CHECK(counts.words.polygons == 3 * 24 + 6 * block.seen.linears.size() + 10 * 2);
  CHECK(static_cast<double>(counts.words.pixels) == (2 + 4) * pixels);
  CHECK(counts.words.sequences == words_of_sequences);
}
TEST_CASE("list priority of one block takes the hand-calculated clocks") {
  const Block block;
  const Square square = square_of(block);
  for (const bool has_depth_buffer : {false, true}) {
    CAPTURE(has_depth_buffer);
    const software::DisplayCounts counts =
        block.counts(has_depth_buffer ? "list-priority/depth-buffer" : "list-priority");
    REQUIRE(counts.drawn_polygons == 2);
    REQUIRE(counts.visited_parts == 1);
    const auto edges = static_cast<double>(counts.words.polygons - 3 * 24 - 8 * 6 - 10 * 2) / 6;
    REQUIRE(edges == block.linears());
    CHECK(clocks(counts, Phase::preprocessing) > 0);
    CHECK(clocks(counts, Phase::transformation) == transformed(6 * 4, 2, edges));
    CHECK(clocks(counts, Phase::initialisation) == pixels * (cleared + (has_depth_buffer ? 2 * 16 + 12 : 16)));
    // One cell is visited: the side of its wall, and four sides of the picture at eight corners.
    constexpr double cell = 8 * 16 + 33 * 6 + 4 * 24 * 70 + 4 * 30 * 8 + 33 * 8 + 2 * 16;
    // The key of each of two pieces takes its plane at two corners of its rectangle.
    constexpr double keys = 2 * (8 * 70 + 8 * 8);
    constexpr double compared = 2 * 16 + 6 + 10 + 16;
    constexpr double decided = 8 * 12 + 5 * 4 + 5 * 8;  // the two rectangles overlap: front before back
    constexpr double noted = 12 + 16 + 4;
    constexpr double taken = 12 + 8 + 2 * 16;
    constexpr double released = 16 + 4;
    CHECK(clocks(counts, Phase::sorting) == cell + keys + compared + decided + noted + 2 * taken + released);
    constexpr double passed = 16 + 8;
    const double set = passed + first_element + 16 + class_read + (has_depth_buffer ? 2 * 16 : 16);
    CHECK(clocks(counts, Phase::scan_conversion) ==
          scans(block, square) + alone + element_made + class_found + square.pixels * (set + passed));
    constexpr double held_against = 16 + 6 + 2 * 8 + 16;
    CHECK(clocks(counts, Phase::depth_test) == (has_depth_buffer ? 2 * square.pixels * (depth + held_against) : 0));
    CHECK(static_cast<double>(counts.words.pixels) == (2 + (has_depth_buffer ? 3 : 1)) * pixels);
    CHECK(counts.words.sequences == words_of_sequences);
  }
}
TEST_CASE("scan lines over one block take the hand-calculated clocks") {
  const Block block;
  const Square square = square_of(block);
  const software::DisplayCounts counts = block.counts("scan-line");
  REQUIRE(static_cast<double>(counts.spans) == square.rows);
  REQUIRE(counts.splits == 0);
  CHECK(clocks(counts, Phase::preprocessing) == 0);
  CHECK(clocks(counts, Phase::transformation) == transformed(6 * 4, 2, block.linears()));
  CHECK(clocks(counts, Phase::initialisation) == pixels * cleared);
  CHECK(clocks(counts, Phase::depth_test) == square.rows * (2 + square.columns) * depth);
  // The left end of a span: the values of both planes are computed and the visible surface is classified. Both ends
  // of both are tested, and the back is found behind the front.
  constexpr double value = column + 2 * 70 + 2 * 16;
  constexpr double classified = first_element + point + class_read + owner;
  constexpr double ends = 2 * 70 + 4 * 16 + 2 * 8 + 4 * 6 + 4 * 8 + 4 * 16 + 12;
  constexpr double behind = 8 * 16 + 4 * 8 + 4 * 6 + 2 * 8;
  constexpr double filled = 2 * 16 + 10 + column;
  CHECK(clocks(counts, Phase::scan_conversion) ==
        block.bounds() * edge + square.rows * (2 * row + block.bounds() * row_edge) + alone + element_made +
            class_found + square.rows * (2 * value + classified + 2 * ends + behind + square.columns * filled));
  // The number of comparisons in a library's sort of two ends and four limits is unspecified.
  const auto compared = [](auto values) {
    double comparisons = 0;
    std::ranges::sort(values, [&](const auto& a, const auto& b) {
      ++comparisons;
      return a < b;
    });
    return comparisons;
  };
  const double limits = compared(std::vector<std::pair<int, int>>{{10, 0}, {20, 0}, {10, 1}, {20, 1}});
  const double events = compared(block.is_back_first() ? std::vector<int>{2, 1} : std::vector<int>{1, 2});
  constexpr double bucketed = 12 + 8 + 16 + 2 * 16;
  constexpr double active = 16 + 12 + 4 + 8;
  constexpr double crossed = 12 + 4 + 8 + 12;  // a limit; the second facet is put behind the first
  CHECK(clocks(counts, Phase::sorting) ==
        2 * bucketed + square.rows * (2 * active + limits * (2 * 12 + 4 + 10 + 16) + 4 * crossed + 12 +
                                      events * (2 * 16 + 6 + 10 + 16)));
  // A list per row, the facets in them, and the maximum active at one time.
  CHECK(counts.words.buckets == static_cast<std::uint64_t>(height) + 2 + 12 * 2);
  CHECK(counts.words.polygons == 3 * 24 + 6 * block.seen.linears.size() + 10 * 2);
  CHECK(static_cast<double>(counts.words.pixels) == 2 * pixels);
  CHECK(counts.words.sequences == words_of_sequences);
}
TEST_CASE("rays through one block take the hand-calculated clocks of six half-spaces") {
  const Block block;
  const software::DisplayCounts counts = block.counts("rays");
  CHECK(clocks(counts, Phase::preprocessing) == 0);
  CHECK(clocks(counts, Phase::depth_test) == 0);
  CHECK(clocks(counts, Phase::initialisation) == pixels * 2 * 16);
  // A plane takes 16 products of longs and three quotients.
  constexpr double plane = (16 * 4 + 3 * 2) * 70 + 3 * 2 * 140 + (12 * 4 + 3 * 2) * 8 + 20 * 16 + 6 * 16 + 18 + 16;
  CHECK(clocks(counts, Phase::transformation) == 6 * plane);
  CHECK(counts.words.polygons == 6 * 6);
  CHECK(counts.words.buckets == 0);
  CHECK(static_cast<double>(counts.words.pixels) == 2 * pixels);
}

#include "host/read/read.h"
#include "sim/software/display/polygons.h"
#include "sim/software/facets/screen_facets.h"
#include "sim/software/rays/caster.h"
#include "sim/software/space/directory.h"
#include "tests/oracle/pixel_oracle.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/shown.h"

using namespace csgsim;
using software::DisplayRow;
using testing::Scene;
using testing::Shown;

namespace {

struct Tally {
  std::uint64_t scenes = 0;
  std::uint64_t refused = 0;
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0;
  std::uint64_t spans = 0;
  std::uint64_t splits = 0;
};

std::string difference(const software::Picture& picture, const std::vector<testing::Seen>& expected,
                       std::uint32_t width) {
  if (picture.seen.size() != expected.size()) return "another number of pixels";
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const software::VisibleSurface& seen = picture.seen[i];
    if (seen.depth == expected[i].depth && seen.owner == expected[i].owner) continue;
    return fmt::format("pixel {}, {} is {} at {}, not {} at {}", i % width, i / width, seen.owner, seen.depth,
                       expected[i].owner, expected[i].depth);
  }
  return "";
}

/// Returns the fault of a scene's pictures by exact methods; empty if none.
std::string find_fault(const Scene& scene, Tally& tally) {
  const std::vector<testing::Seen> expected = testing::draw_by_rules(scene.tree, scene.geometry, scene.view);
  for (const testing::Seen& seen : expected)
    tally.covered += seen.owner != software::VisibleSurface::nothing_seen ? 1U : 0U;
  tally.pixels += expected.size();
  const Shown shown(scene);
  for (const DisplayRow* const row : software::display_methods()) {
    if (!row->is_exact) continue;
    for (const bool counts : {false, true}) {
      const software::Displayed displayed = shown.by(*row, counts);
      tally.spans += displayed.counts.spans;
      tally.splits += displayed.counts.splits;
      const std::string fault = difference(displayed.picture, expected, scene.view.sampling.width);
      if (!fault.empty()) return fmt::format("{}: {}", row->name, fault);
    }
  }
  return "";
}

/// Counts of exact methods from ray events: surface sequences whose class is evaluated.
struct Recount {
  std::set<std::vector<std::uint32_t>> evaluated;
  std::set<std::vector<std::uint32_t>> elements;
  std::uint64_t points = 0;
  std::uint64_t layers = 1;
  std::uint64_t events = 0;
};

Recount recounted(const Scene& scene) {
  const std::vector<testing::Seen> expected = testing::draw_by_rules(scene.tree, scene.geometry, scene.view);
  const software::RayCaster rays(scene.tree, scene.geometry, scene.view);
  Recount recount;
  software::RayBand band;
  for (std::uint32_t row = 0; row < rays.height(); row += software::band_rows) {
    rays.cast(row, band);
    for (std::size_t ray = 0; ray < band.rays(); ++ray) {
      const std::span<const software::Event> events = band.events_of(ray);
      const testing::Seen& seen = expected[std::size_t{row} * rays.width() + ray];
      recount.events += events.size();
      std::vector<std::uint32_t> sequence;
      std::uint64_t points = 0;
      for (std::size_t i = 0; i < events.size() && events[i].depth <= seen.depth; ++i) {
        sequence.push_back(events[i].primitive());
        recount.elements.insert(sequence);
        const bool is_last = i + 1 == events.size() || events[i + 1].depth != events[i].depth;
        if (!is_last) continue;
        ++points;
        if (i > 0) recount.evaluated.insert(sequence);
      }
      recount.points += points;
      recount.layers =
          std::max(recount.layers, points + (seen.owner == software::VisibleSurface::nothing_seen ? 1 : 0));
    }
  }
  return recount;
}

/// Returns the number of evaluations.
std::uint64_t check_counts(const Scene& scene) {
  const Recount recount = recounted(scene);
  const Shown shown(scene);
  for (const char* const method : {"depth-lists", "depth-peeling", "scan-line"}) {
    CAPTURE(method);
    const software::DisplayCounts counts = shown.by(method).counts;
    CHECK(counts.csg.evaluations == recount.evaluated.size());
    CHECK(counts.csg.list_elements == recount.elements.size());
  }
  const software::DisplayCounts lists = shown.by("depth-lists").counts;
  CHECK(lists.csg.points == recount.points);
  CHECK(lists.pixel_events == recount.events);
  const software::DisplayCounts peeling = shown.by("depth-peeling").counts;
  CHECK(peeling.csg.points == recount.points);
  CHECK(peeling.passes == 2 * recount.layers);
  CHECK(peeling.pixel_events == 2 * recount.layers * recount.events);
  return recount.evaluated.size();
}

}  // namespace

TEST_CASE("exact facet methods draw random models as the rule-based judge does") {
  Tally tally;
  CHECK(testing::holds_in_random_scenes(tally, testing::is_faceted, [&](const Scene& scene, std::uint64_t /*seed*/) {
    return find_fault(scene, tally);
  }));
  MESSAGE(tally.scenes, " scenes, ", tally.refused, " refused, ", tally.covered, " of ", tally.pixels,
          " pixels covered, ", tally.spans, " spans, ", tally.splits, " splits");
  if (!testing::draws_usual_cases()) return;
  CHECK(tally.refused < tally.scenes * 3 / 4);
  CHECK(tally.covered > tally.pixels / 20);
  CHECK(tally.splits > 0);
  CHECK(tally.spans < tally.pixels * 2);
}
TEST_CASE("exact facet methods draw the thesis's objects as the rule-based judge does") {
  Tally tally;
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    for (const testing::ThesisObject& one : testing::thesis_objects(projection)) {
      CAPTURE(one.name);
      CHECK(find_fault(testing::thesis_scene(one, 130, 45), tally) == "");
    }
  }
  MESSAGE(tally.pixels, " pixels, ", tally.spans, " spans, ", tally.splits, " splits");
}
TEST_CASE("facet methods show a plate thinner than a depth step only where it spans a step") {
  Tally tally;
  std::uint64_t opposites = 0;
  for (unsigned i = 0; i < 60; ++i) {
    const double thickness = 0.2 + 0.05 * i;
    const double angle = 0.02 * (1 + i % 20);
    const std::string csg = fmt::format(
        "multmatrix([[{0},{1},0,0],[{2},{0},0,0],[0,0,1,0],[0,0,0,1]]){{cube(size=[40,{3},30],center=true);}}"
        "multmatrix([[1,0,0,0],[0,1,0,-30],[0,0,1,0],[0,0,0,1]]){{cube(size=[1,1,1],center=true);}}"
        "multmatrix([[1,0,0,0],[0,1,0,30],[0,0,1,0],[0,0,0,1]]){{cube(size=[44,1,34],center=true);}}",
        std::cos(angle), -std::sin(angle), std::sin(angle), thickness);
    view::Sampling sampling;
    sampling.width = 60;
    sampling.height = 12;
    sampling.z_bits = 5;
    sampling.fraction_bits = 8;
    const view::Camera camera{{0, -110, 0}, {0, 0, 0}, view::Projection::orthographic};
    const Scene scene = testing::make_scene(read::read_csg_text(csg, "plates"), camera, sampling);
    CAPTURE(i);
    CHECK(find_fault(scene, tally) == "");
    const Shown shown(scene);
    const software::ScreenFacets seen = software::screen_facets(scene.tree, scene.geometry, scene.view, shown.facets);
    for (const software::ScreenFacet& facet : seen.facets) opposites += seen.opposites_of(facet).size();
  }
  CHECK(opposites > 30);
}
TEST_CASE("facet methods evaluate each sequence once and peel each layer in two passes") {
  std::uint64_t evaluations = 0;
  std::uint64_t scenes = 0;
  for (std::uint64_t seed = 1; scenes < 60; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene || !testing::is_faceted(*scene)) continue;
    CAPTURE(seed);
    evaluations += check_counts(*scene);
    ++scenes;
  }
  CHECK(evaluations > 10 * scenes);
  for (const testing::ThesisObject& one : testing::thesis_objects(view::Projection::perspective)) {
    CAPTURE(one.name);
    check_counts(testing::thesis_scene(one, 130, 45));
  }
}
TEST_CASE("a facet method counts only on request and an unknown one is rejected") {
  const Scene scene = testing::thesis_scene(testing::thesis_objects(view::Projection::perspective).front(), 40, 30);
  const Shown shown(scene);
  for (const DisplayRow* const row : software::display_methods()) {
    CAPTURE(row->name);
    const software::DisplayCounts counts = shown.by(*row, true).counts;
    const software::DisplayCounts plain = shown.by(*row, false).counts;
    CHECK(counts.of(software::Phase::transformation).of(software::Operation::multiply) > 0);
    CHECK(counts.of(software::Phase::scan_conversion).of(software::Operation::add_long) > 0);
    CHECK(plain.csg.operations == software::Operations{});
    CHECK(plain.csg.evaluations == 0);
    CHECK(plain.words.all() == counts.words.all());
    CHECK(plain.pieces == counts.pieces);
    CHECK(shown.by(*row, true).picture.seen == shown.by(*row, false).picture.seen);
    software::Operations all;
    for (const software::Operations& phase : counts.operations) all += phase;
    CHECK(all == counts.csg.operations);
  }
  CHECK_THROWS_WITH_AS(software::display_method("scanline"), doctest::Contains("scan-line"), InputError);
}
TEST_CASE("each facet method is found by name and all but two are exact") {
  for (const DisplayRow* const row : software::display_methods())
    CHECK(&software::display_method(std::string(row->name)) == row);
  CHECK(std::ranges::count(software::display_methods(), false, [](const DisplayRow* row) { return row->is_exact; }) ==
        2);
  CHECK(!software::display_method("list-priority").is_exact);
  CHECK(!software::display_method("list-priority/depth-buffer").is_exact);
  CHECK(DisplayRow{}.is_exact);
  CHECK_THROWS_AS(software::display_method(""), InputError);
  CHECK_THROWS_AS(software::display_method("list-priorit"), InputError);
}
TEST_CASE("counts of a facet method start at zero and buckets hold 24 polygons") {
  const software::DisplayCounts counts;
  CHECK(counts.polygons + counts.pieces + counts.shared + counts.references + counts.crossing_tests +
            counts.overlap_tests + counts.drawn_polygons + counts.pixel_events + counts.passes + counts.spans +
            counts.splits + counts.cells + counts.drawn_cells + counts.visited_parts + counts.overfull_cells +
            counts.conflicts ==
        0);
  for (const software::Operations& operations : counts.operations) CHECK(operations == software::Operations{});
  CHECK(counts.words.all() == 0);
  CHECK(software::DisplayWords{1, 20, 300, 4000}.all() == 4321);
  const software::Displayed displayed;
  CHECK(displayed.preprocessing_seconds == 0);
  CHECK(displayed.drawing_seconds == 0);
  const software::ClippedFacets clipped;
  CHECK(clipped.crossing_tests + clipped.overlap_tests == 0);
  const software::Polygons polygons;
  CHECK(polygons.canonical_planes + polygons.clipped + polygons.shared + polygons.crossing_tests +
            polygons.overlap_tests + polygons.words ==
        0);
  CHECK(software::CellOrder{}.looked_at == 0);
  CHECK(software::Piece{}.facet == 0);
  CHECK(software::PolygonOptions{software::directory_of("excell")}.bucket_size == 24);
}
TEST_CASE("a ledger replaces totals by the sums of its phases and keeps other counts") {
  struct CountSource {
    software::Counts counts;

    [[nodiscard]] const software::Counts& counts_so_far() const { return counts; }
  };
  software::Ledger<CountSource> ledger;
  // The first phase counts 1 of each, the next 10, and so on.
  std::uint64_t times = 1;
  for (std::size_t phase = 0; phase < software::phases; ++phase, times *= 10) {
    software::Counts& counts = ledger[static_cast<software::Phase>(phase)].counts;
    counts.points = times;
    counts.evaluations = 2 * times;
    counts.precomputed = 3 * times;
    counts.looked_up = 4 * times;
    counts.node_visits = 5 * times;
    counts.early_outs = 6 * times;
    counts.list_steps = 7 * times;
    counts.list_elements = 8 * times;
    counts.ties = 9 * times;
    counts.operations.counts[static_cast<std::size_t>(software::Operation::multiply)] = times;
  }
  software::DisplayCounts total;
  total.csg.points = total.csg.ties = 50;
  total.conflicts = 77;
  ledger.store_counts(total);
  CHECK(total.csg.points == 111111);
  CHECK(total.csg.evaluations == 222222);
  CHECK(total.csg.precomputed == 333333);
  CHECK(total.csg.looked_up == 444444);
  CHECK(total.csg.node_visits == 555555);
  CHECK(total.csg.early_outs == 666666);
  CHECK(total.csg.list_steps == 777777);
  CHECK(total.csg.list_elements == 888888);
  CHECK(total.csg.ties == 999999);
  CHECK(total.csg.operations.of(software::Operation::multiply) == 111111);
  CHECK(total.of(software::Phase::preprocessing).of(software::Operation::multiply) == 1);
  CHECK(total.of(software::Phase::sorting).of(software::Operation::multiply) == 100);
  CHECK(total.of(software::Phase::initialisation).of(software::Operation::multiply) == 100000);
  CHECK(total.conflicts == 77);
}
TEST_CASE("a display subject computes its pixels and farthest depth and has default buckets") {
  const Scene scene = testing::thesis_scene(testing::thesis_objects(view::Projection::perspective).front(), 40, 30);
  const Shown shown(scene);
  const software::DisplaySubject subject{scene.tree, scene.geometry, scene.view, shown.tree, shown.facets};
  CHECK(subject.pixels() == 1200);
  CHECK(subject.farthest() == 1048575);  // 20 bits
  CHECK(subject.bucket_size == 24);
  CHECK(subject.directory == "excell");
  const software::Displayed displayed = software::display_method("list-priority").run(subject, true);
  CHECK(displayed.counts.references == shown.by("list-priority", true, 24).counts.references);
  CHECK(displayed.counts.references != shown.by("list-priority", true, 23).counts.references);
  CHECK(displayed.preprocessing_seconds > 0);
  CHECK(displayed.drawing_seconds > 0);
  CHECK(displayed.preprocessing_seconds < 60);
  CHECK(displayed.drawing_seconds < 60);
}
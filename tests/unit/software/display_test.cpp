#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "host/read/read.h"
#include "hw/base/error.h"
#include "sim/software/display/polygons.h"
#include "sim/software/display/rows.h"
#include "sim/software/display/screen_pieces.h"
#include "sim/software/methods/counts.h"
#include "sim/software/rays/caster.h"
#include "tests/oracle/pixel_oracle.h"
#include "tests/support/drawing.h"
#include "tests/support/usual_cases.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using software::DisplayRow;
using software::DisplaySubject;
using testing::Scene;

namespace {

struct Tally {
  std::uint64_t scenes = 0;
  std::uint64_t refused = 0;
  std::uint64_t pixels = 0;
  std::uint64_t covered = 0;
  std::uint64_t spans = 0;
  std::uint64_t splits = 0;
};

/// A scene and what its methods are given.
struct Shown {
  const Scene& scene;
  software::Tree tree;
  software::Facets facets;

  explicit Shown(const Scene& of)
      : scene(of),
        tree(software::make_tree(of.tree, software::Shape::balanced)),
        facets(software::facets_of(of.tree, of.geometry)) {}

  [[nodiscard]] software::Displayed by(const DisplayRow& row, bool counts, std::size_t bucket_size = 24) const {
    return row.run({scene.tree, scene.geometry, scene.view, tree, facets, bucket_size}, counts);
  }
  [[nodiscard]] software::Displayed by(const char* method, bool counts = true, std::size_t bucket_size = 24) const {
    return by(software::display_method(method), counts, bucket_size);
  }
};

std::string difference(const software::Picture& picture, const std::vector<testing::Seen>& expected,
                       std::uint32_t width) {
  if (picture.seen.size() != expected.size()) return "another number of pixels";
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const software::Seen& seen = picture.seen[i];
    if (seen.depth == expected[i].depth && seen.owner == expected[i].owner) continue;
    return fmt::format("pixel {}, {} is {} at {}, not {} at {}", i % width, i / width, seen.owner, seen.depth,
                       expected[i].owner, expected[i].depth);
  }
  return "";
}

/// What is wrong with a scene's pictures by exact methods; empty if nothing is.
std::string fault_of(const Scene& scene, Tally& tally) {
  const std::vector<testing::Seen> expected = testing::draw_by_rules(scene.tree, scene.geometry, scene.view);
  for (const testing::Seen& seen : expected) tally.covered += seen.owner != software::Seen::nothing_seen ? 1U : 0U;
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

/// What exact methods count, from the events of rays: sequences of surfaces at which a class is asked for.
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
      recount.layers = std::max(recount.layers, points + (seen.owner == software::Seen::nothing_seen ? 1 : 0));
    }
  }
  return recount;
}

/// Returns the evaluations.
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

TEST_CASE("exact methods that go facet by facet draw random models as the rules say") {
  Tally tally;
  CHECK(testing::holds_in_random_scenes(
      tally, testing::is_faceted, [&](const Scene& scene, std::uint64_t /*seed*/) { return fault_of(scene, tally); }));
  MESSAGE(tally.scenes, " scenes, ", tally.refused, " refused, ", tally.covered, " of ", tally.pixels,
          " pixels covered, ", tally.spans, " spans, ", tally.splits, " splits");
  if (!testing::draws_usual_cases()) return;
  CHECK(tally.refused < tally.scenes * 3 / 4);
  CHECK(tally.covered > tally.pixels / 20);
  CHECK(tally.splits > 0);
  CHECK(tally.spans < tally.pixels * 2);
}
TEST_CASE("exact methods that go facet by facet draw the thesis's objects as the rules say") {
  Tally tally;
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    for (const testing::ThesisObject& one : testing::thesis_objects(projection)) {
      CAPTURE(one.name);
      CHECK(fault_of(testing::thesis_scene(one, 130, 45), tally) == "");
    }
  }
  MESSAGE(tally.pixels, " pixels, ", tally.spans, " spans, ", tally.splits, " splits");
}
TEST_CASE("plates thinner than a step of depth, drawn facet by facet, are seen where a step lies between their faces") {
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
    CHECK(fault_of(scene, tally) == "");
    const Shown shown(scene);
    const software::ScreenFacets seen = software::screen_facets(scene.tree, scene.geometry, scene.view, shown.facets);
    for (const software::ScreenFacet& facet : seen.facets) opposites += seen.opposites_of(facet).size();
  }
  CHECK(opposites > 30);
}
TEST_CASE(
    "methods that go facet by facet evaluate each sequence of surfaces once, and peel as many layers as there are") {
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
TEST_CASE("a method that goes facet by facet counts only when it is made to, and an unknown one is refused") {
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

namespace {

/// Wrong pixels of list priority.
struct Wrong {
  std::uint64_t scenes = 0;
  std::uint64_t pixels = 0;
  std::uint64_t events = 0;
  std::uint64_t pieces = 0;
  std::uint64_t polygons = 0;
  std::uint64_t conflicts = 0;
  std::uint64_t lost = 0;  ///< events of cells that are not drawn
  software::Faults faults;
  software::Faults with_depth_buffer;
};

/// Whether two surfaces of a ray are at one depth or a step apart, no farther than the one that is seen there by one of
/// two pictures.
bool has_near_events(std::span<const software::Event> events, std::uint32_t farthest) {
  for (std::size_t i = 1; i < events.size() && events[i - 1].depth <= farthest; ++i) {
    if (events[i].depth - events[i - 1].depth <= 1) return true;
  }
  return false;
}

void add(software::Faults& sum, const software::Faults& more) {
  sum.coincident += more.coincident;
  sum.three_way += more.three_way;
  sum.order += more.order;
}

/// What is wrong with the wrong pixels of a picture: all are told of, and none without a reason.
std::string fault_of_wrong(const Scene& scene, const software::Displayed& displayed, Wrong& wrong) {
  const std::vector<testing::Seen> expected = testing::draw_by_rules(scene.tree, scene.geometry, scene.view);
  const software::RayCaster rays(scene.tree, scene.geometry, scene.view);
  std::uint64_t all = 0;
  std::uint64_t unexplained = 0;
  std::uint64_t events = 0;
  software::RayBand band;
  for (std::uint32_t row = 0; row < rays.height(); row += software::band_rows) {
    rays.cast(row, band);
    for (std::size_t ray = 0; ray < band.rays(); ++ray) {
      const std::size_t pixel = std::size_t{row} * rays.width() + ray;
      events += band.events_of(ray).size();
      const software::Seen& seen = displayed.picture.seen[pixel];
      if (seen.depth == expected[pixel].depth && seen.owner == expected[pixel].owner) continue;
      ++all;
      unexplained += has_near_events(band.events_of(ray), std::max(seen.depth, expected[pixel].depth)) ? 0U : 1U;
    }
  }
  wrong.pixels += expected.size();
  wrong.events += events;
  // With few bits a face may have pixels far from its place, and its cell be out of sight.
  const bool are_all_drawn = displayed.counts.drawn_cells == displayed.counts.cells;
  wrong.lost += events - displayed.counts.pixel_events;
  if (displayed.counts.pixel_events > events || (are_all_drawn && displayed.counts.pixel_events != events))
    return fmt::format("{} events are drawn, not {}", displayed.counts.pixel_events, events);
  if (displayed.faults.all() != all) return fmt::format("{} wrong pixels of {}", displayed.faults.all(), all);
  if (unexplained > displayed.faults.order) return "wrong pixels without surfaces near each other";
  return "";
}

std::string fault_of_priority(const Scene& scene, std::size_t bucket_size, Wrong& wrong) {
  const Shown shown(scene);
  const software::Displayed plain = shown.by("list-priority", true, bucket_size);
  const software::Displayed mended = shown.by("list-priority/depth-buffer", true, bucket_size);
  ++wrong.scenes;
  wrong.pieces += plain.counts.pieces;
  wrong.polygons += plain.counts.polygons;
  wrong.conflicts += plain.counts.conflicts;
  add(wrong.faults, plain.faults);
  add(wrong.with_depth_buffer, mended.faults);
  for (const software::Displayed* const one : {&plain, &mended}) {
    const std::string fault = fault_of_wrong(scene, *one, wrong);
    if (!fault.empty()) return (one == &plain ? "plain: " : "depth buffer: ") + fault;
  }
  return "";
}

void tell(const Wrong& wrong) {
  MESSAGE(wrong.scenes, " scenes, ", wrong.polygons, " polygons, ", wrong.pieces, " pieces, ", wrong.conflicts,
          " conflicts, ", wrong.lost, " events lost, ", wrong.pixels, " pixels, ", wrong.events,
          " events; wrong: ", wrong.faults.coincident, " ", wrong.faults.three_way, " ", wrong.faults.order,
          "; with a depth buffer: ", wrong.with_depth_buffer.coincident, " ", wrong.with_depth_buffer.three_way, " ",
          wrong.with_depth_buffer.order);
}

}  // namespace

TEST_CASE("list priority draws each event once, and its wrong pixels have surfaces near each other, in random scenes") {
  Wrong wrong;
  CHECK(rc::check([&] {
    const auto seed = *rc::gen::arbitrary<std::uint64_t>();
    for (std::uint64_t i = 0; i < 4; ++i) {
      const std::optional<Scene> scene = testing::random_scene(seed + i);
      if (!scene || !testing::is_faceted(*scene)) continue;
      const std::string fault = fault_of_priority(*scene, 4 + (seed + i) % 30, wrong);
      if (!fault.empty()) RC_FAIL(fmt::format("seed {}: {}", seed + i, fault));
    }
  }));
  tell(wrong);
  if (!testing::draws_usual_cases()) return;
  CHECK(wrong.faults.coincident > 0);
  CHECK(wrong.faults.three_way > 0);
  CHECK(wrong.with_depth_buffer.all() < wrong.faults.all() / 20);
  CHECK(wrong.faults.all() < wrong.pixels / 20);
  CHECK(wrong.lost < wrong.events / 20);
  CHECK(wrong.pieces > 2 * wrong.polygons);
}
TEST_CASE("list priority draws the thesis's objects but for surfaces near each other") {
  Wrong wrong;
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    for (const testing::ThesisObject& one : testing::thesis_objects(projection)) {
      CAPTURE(one.name);
      CHECK(fault_of_priority(testing::thesis_scene(one, 130, 45), 24, wrong) == "");
    }
  }
  tell(wrong);
  CHECK(wrong.faults.all() > 0);
  CHECK(wrong.faults.all() < 50);
  CHECK(wrong.with_depth_buffer.all() == 0);
  CHECK(wrong.lost == 0);
}

namespace {

/// The events of pieces at each pixel, by the bounds of the pieces alone.
std::vector<std::vector<software::Event>> events_of_pieces(const software::ScreenFacets& pieces, std::uint32_t width,
                                                           std::uint32_t height) {
  std::vector<std::vector<software::Event>> events(std::size_t{width} * height);
  for (const software::ScreenFacet& piece : pieces.facets) {
    for (std::int32_t y = 0; y < static_cast<std::int32_t>(height); ++y) {
      for (std::int32_t x = 0; x < static_cast<std::int32_t>(width); ++x) {
        const std::optional<software::Event> event = pieces.event_at(piece, x, y);
        if (event) events[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)].push_back(*event);
      }
    }
  }
  for (std::vector<software::Event>& one : events) std::sort(one.begin(), one.end());
  return events;
}

std::vector<std::uint32_t> all_cells(const software::Polygons& polygons) {
  std::vector<std::uint32_t> cells(polygons.cells.size());
  std::iota(cells.begin(), cells.end(), 0U);
  return cells;
}

software::Polygons polygons_of(const Shown& shown, std::size_t bucket_size) {
  software::UncountedMethod uncounted;
  return software::clipped(shown.facets, shown.scene.geometry, bucket_size, uncounted);
}

/// Where a segment goes through a convex polygon, by more than `margin` on all sides of it: the least of the heights of
/// its ends over the plane, and of the point's distances from the edges.
bool pierces(const glm::dvec3& from, const glm::dvec3& to, std::span<const glm::dvec3> corners, double margin) {
  glm::dvec3 normal{0};
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal += glm::cross(corners[i] - corners[0], corners[(i + 1) % corners.size()] - corners[0]);
  normal = glm::normalize(normal);
  const double at_from = glm::dot(normal, from - corners[0]);
  const double at_to = glm::dot(normal, to - corners[0]);
  if (std::min(at_from, at_to) > -margin || std::max(at_from, at_to) < margin) return false;
  const glm::dvec3 point = from + (to - from) * (at_from / (at_from - at_to));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 edge = corners[(i + 1) % corners.size()] - corners[i];
    if (glm::length(edge) < margin) continue;
    if (glm::dot(glm::cross(normal, glm::normalize(edge)), point - corners[i]) < margin) return false;
  }
  return true;
}

bool pierce(const software::Piece& one, const software::Piece& other, double margin) {
  for (std::size_t i = 0; i < one.corners.size(); ++i) {
    if (pierces(one.corners[i], one.corners[(i + 1) % one.corners.size()], other.corners, margin)) return true;
  }
  return false;
}

/// Pairs of pieces of different primitives that go through each other.
std::uint64_t crossings(const Shown& shown, const software::Polygons& polygons, double margin) {
  std::vector<const software::Piece*> pieces;
  for (const software::PolygonCell& cell : polygons.cells) {
    for (const software::Piece& piece : cell.bucket) {
      if (piece.corners.size() >= 3) pieces.push_back(&piece);
    }
  }
  std::uint64_t count = 0;
  for (const software::Piece* const one : pieces) {
    for (const software::Piece* const other : pieces) {
      const bool are_apart = shown.facets.facets[one->facet].primitive == shown.facets.facets[other->facet].primitive;
      if (!are_apart && pierce(*one, *other, margin)) ++count;
    }
  }
  return count;
}

double area(std::span<const glm::dvec3> corners) {
  glm::dvec3 sum{0};
  for (std::size_t i = 2; i < corners.size(); ++i)
    sum += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  return glm::length(sum) / 2.0;
}

}  // namespace

TEST_CASE("each pixel of a facet is in one of its pieces, whatever the size of buckets, in random scenes") {
  std::uint64_t scenes = 0;
  std::uint64_t cuts = 0;
  for (std::uint64_t seed = 1; scenes < 60; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene || !testing::is_faceted(*scene)) continue;
    CAPTURE(seed);
    const Shown shown(*scene);
    const software::ScreenFacets seen =
        software::screen_facets(scene->tree, scene->geometry, scene->view, shown.facets);
    software::ScreenFacets caps = seen;
    std::erase_if(caps.facets,
                  [](const software::ScreenFacet& one) { return one.facet != software::ScreenFacet::near_cap; });
    const software::Polygons polygons = polygons_of(shown, 1 + seed % 20);
    const software::ScreenPieces pieces =
        software::screen_pieces(polygons, all_cells(polygons), seen, scene->geometry, scene->view);
    cuts += pieces.pieces.facets.size() - (seen.facets.size() - caps.facets.size());
    const view::Sampling& sampling = scene->view.sampling;
    std::vector<std::vector<software::Event>> events = events_of_pieces(pieces.pieces, sampling.width, sampling.height);
    const auto of_caps = events_of_pieces(caps, sampling.width, sampling.height);
    for (std::size_t i = 0; i < events.size(); ++i) {
      events[i].insert(events[i].end(), of_caps[i].begin(), of_caps[i].end());
      std::sort(events[i].begin(), events[i].end());
    }
    CHECK((events == events_of_pieces(seen, sampling.width, sampling.height)));
    ++scenes;
  }
  CHECK(cuts > 1000);
}
TEST_CASE("pieces of different primitives do not cross, and a facet's have its area") {
  std::uint64_t scenes = 0;
  std::uint64_t before = 0;
  for (std::uint64_t seed = 1; scenes < 24; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene || !testing::is_faceted(*scene)) continue;
    const Shown shown(*scene);
    if (shown.facets.facets.size() > 60) continue;
    CAPTURE(seed);
    const software::Polygons polygons = polygons_of(shown, 12);
    const double margin = 1e-6 * scene->geometry.planes.diagonal();
    CHECK(crossings(shown, polygons, margin) == 0);
    software::Polygons whole;
    software::PolygonCell cell;
    for (std::uint32_t facet = 0; facet < shown.facets.facets.size(); ++facet) {
      const auto corners = shown.facets.corners_of(facet);
      cell.bucket.push_back({facet, {corners.begin(), corners.end()}, {}, {}});
    }
    whole.cells.push_back(cell);
    before += crossings(shown, whole, margin);
    std::vector<double> areas(shown.facets.facets.size());
    for (const software::PolygonCell& one : polygons.cells) {
      for (const software::Piece& piece : one.bucket) areas[piece.facet] += area(piece.corners);
    }
    for (std::uint32_t facet = 0; facet < areas.size(); ++facet) {
      const double expected = area(shown.facets.corners_of(facet));
      CHECK(areas[facet] == doctest::Approx(expected).epsilon(1e-6).scale(margin));
    }
    ++scenes;
  }
  CHECK(before > 50);
}
TEST_CASE("a wrong pixel is for what came out of order there") {
  const std::vector<software::Event> exact{{10, 0}, {20, 2}, {20, 4}, {40, 1}, {40, 3}, {41, 5}, {60, 7}};
  const auto fault = [&](std::vector<software::Event> drawn) { return software::fault_of(exact, drawn); };
  CHECK(fault({{0, 0}, {0, 2}}) == software::Fault::coincident);
  CHECK(fault({{0, 0}, {0, 4}}) == software::Fault::coincident);
  CHECK(fault({{0, 0}, {0, 2}, {0, 4}, {0, 3}}) == software::Fault::three_way);
  CHECK(fault({{0, 0}, {0, 2}, {0, 4}, {0, 1}, {0, 5}}) == software::Fault::three_way);
  CHECK(fault({{0, 2}}) == software::Fault::order);
  CHECK(fault({{0, 0}, {0, 2}, {0, 4}, {0, 7}}) == software::Fault::order);
  CHECK(fault({{0, 0}, {0, 9}}) == software::Fault::order);
  CHECK(fault({{0, 0}}) == software::Fault::order);
}

#include "sim/software/tracing/trace.h"

#include "host/read/read.h"
#include "sim/software/tree/tree.h"
#include "tests/oracle/pixel_oracle.h"
#include "tests/support/drawing.h"
#include "tests/support/software_ways.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using software::VisibleSurface;
using testing::Scene;

namespace {

struct Tally {
  std::uint64_t scenes = 0;
  std::uint64_t refused = 0;
  std::uint64_t covered = 0;
  std::uint64_t tested = 0;
  std::uint64_t loose = 0;
  std::uint64_t facets = 0;
  std::uint64_t loose_facets = 0;
};

/// Returns the fault in the traced pictures of a scene; empty if none.
std::string find_fault(const Scene& scene, std::uint32_t bucket_size, Tally& tally) {
  const std::vector<testing::Seen> expected = testing::draw_by_rules(scene.tree, scene.geometry, scene.view);
  const software::Tree tree = software::make_tree(scene.tree, software::Shape::written);
  const software::TraceScene traced_scene(scene.tree, scene.geometry, scene.view, tree);
  tally.facets += traced_scene.screen().facets.size();
  tally.loose_facets += traced_scene.loose();
  for (const software::DirectoryRow* row : software::directories()) {
    const std::unique_ptr<software::Directory> directory = row->make(traced_scene.shapes(), {bucket_size});
    for (const bool has_mailboxes : {true, false}) {
      for (const bool has_item_buffer : {false, true}) {
        software::TraceOptions options;
        options.item_pass = has_item_buffer ? software::ItemPass::depth_lists : software::ItemPass::none;
        options.has_mailboxes = has_mailboxes;
        const software::Traced traced = software::trace(traced_scene, *directory, options, has_mailboxes);
        tally.tested += traced.counts.primary.tested;
        tally.loose += traced.counts.primary.loose;
        for (std::size_t i = 0; i < expected.size(); ++i) {
          const VisibleSurface& seen = traced.pixels[i].seen;
          tally.covered += seen.owner != VisibleSurface::nothing_seen ? 1U : 0U;
          if (seen.depth == expected[i].depth && seen.owner == expected[i].owner) continue;
          return fmt::format("{}{}{}: pixel {}, {} has depth {} and owner {} instead of {}, {}", row->name,
                             has_mailboxes ? "" : " without mailboxes", has_item_buffer ? " with item buffer" : "",
                             i % traced_scene.width(), i / traced_scene.width(), seen.depth, seen.owner,
                             expected[i].depth, expected[i].owner);
        }
      }
    }
  }
  return "";
}

Scene build_scene(const std::string& csg, const view::Camera& camera, std::uint32_t width, std::uint32_t height) {
  view::Sampling sampling;
  sampling.width = width;
  sampling.height = height;
  return testing::make_scene(read::read_csg_text(csg, "test"), camera, sampling);
}

}  // namespace

TEST_CASE("ray tracing matches the rule-based judge in random scenes with all options") {
  Tally tally;
  CHECK(testing::holds_in_random_scenes(tally, testing::is_faceted, [&](const Scene& scene, std::uint64_t seed) {
    return find_fault(scene, static_cast<std::uint32_t>(1 + seed % 9), tally);
  }));
  MESSAGE(tally.scenes, " scenes, ", tally.refused, " refused, ", tally.covered, " pixels covered, ", tally.tested,
          " facets tested, ", tally.loose, " of them loose; ", tally.loose_facets, " of ", tally.facets, " are loose");
  if (!testing::draws_usual_cases()) return;
  CHECK(tally.covered > 10'000);
  CHECK(tally.refused < tally.scenes * 3 / 4);
}
TEST_CASE("ray tracing draws the thesis's objects as the judge does with few loose facets") {
  Tally tally;
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    for (const testing::ThesisObject& one : testing::thesis_objects(projection)) {
      CAPTURE(one.name);
      CHECK(find_fault(testing::thesis_scene(one, 90, 70), 8, tally) == "");
    }
  }
  MESSAGE(tally.tested, " facets tested, ", tally.loose, " of them loose; ", tally.loose_facets, " of ", tally.facets);
  CHECK(tally.loose_facets < tally.facets / 20);
}
TEST_CASE("counts of primary rays agree between directories and with and without mailboxes") {
  for (const testing::ThesisObject& one : testing::thesis_objects(view::Projection::perspective)) {
    CAPTURE(one.name);
    const Scene scene = testing::thesis_scene(one, 40, 30);
    const software::Tree tree = software::make_tree(scene.tree, software::Shape::balanced);
    const software::TraceScene traced_scene(scene.tree, scene.geometry, scene.view, tree);
    const auto met = [&](const char* directory, bool has_mailboxes) {
      const auto space = software::directory_of(directory).make(traced_scene.shapes(), {6});
      software::TraceOptions options;
      options.has_mailboxes = has_mailboxes;
      return software::trace(traced_scene, *space, options, true).counts.primary;
    };
    const software::RaysMet all = met("none", true);
    CHECK(all.rays == 40 * 30);
    CHECK(all.cells == all.rays);
    CHECK(all.tested - all.loose == all.rays * traced_scene.shapes().placed().size());
    const software::RaysMet points = met("excell", true);
    const software::RaysMet halves = met("excell-recursive", true);
    CHECK(points.cells == halves.cells);
    CHECK(points.tested == halves.tested);
    CHECK(points.rays_by_cells == halves.rays_by_cells);
    CHECK(points.hits == all.hits);
    CHECK(points.met <= all.met);
    const software::RaysMet again = met("excell", false);
    CHECK(again.repeats == 0);
    CHECK(again.tested == points.tested + points.repeats);
    CHECK(again.met >= points.met);
    std::uint64_t rays = 0;
    std::uint64_t cells = 0;
    for (std::size_t i = 0; i < points.rays_by_cells.size(); ++i) {
      rays += points.rays_by_cells[i];
      cells += i * points.rays_by_cells[i];
    }
    CHECK(rays == points.rays);
    CHECK(cells == points.cells);
  }
}
TEST_CASE("rays at a lone box are tested against its six facets in one cell") {
  const view::Camera front{{0, -60, 0}, {0, 0, 0}, view::Projection::orthographic};
  const Scene scene = build_scene("cube(size=[8,8,8],center=true);", front, 64, 64);
  const software::Tree tree = software::make_tree(scene.tree, software::Shape::written);
  const software::TraceScene traced_scene(scene.tree, scene.geometry, scene.view, tree);
  const auto space = software::directory_of("excell").make(traced_scene.shapes(), {6});
  const software::RaysMet met = software::trace(traced_scene, *space, {}, true).counts.primary;
  CHECK(met.hits > 200);
  CHECK(met.cells >= met.hits);
  CHECK(met.cells <= met.hits + 4 * 64);  // the cell extends slightly beyond the box
  CHECK(met.tested == 6 * met.cells);
  CHECK(met.met == 2 * met.hits);
}
TEST_CASE("ray tracing shows nothing of an empty model or one behind the eye") {
  Tally tally;
  const view::Camera aside{{18, -25, 21}, {0, 0, 0}, view::Projection::perspective};
  CHECK(find_fault(build_scene("union(){}", aside, 20, 9), 8, tally) == "");
  const view::Camera away{{18, -25, 21}, {36, -50, 42}, view::Projection::perspective};
  CHECK(find_fault(build_scene("cube(size=[4,4,4],center=true);", away, 20, 9), 8, tally) == "");
  CHECK(tally.covered == 0);
}
TEST_CASE("rays of a camera in a solid start inside the solid") {
  Tally tally;
  view::Sampling sampling;
  sampling.width = 40;
  sampling.height = 30;
  sampling.near = 0.25;
  const Scene scene = testing::make_scene(
      read::read_csg_text("difference(){cube(size=[9,9,9],center=true);sphere(r=2,$fn=16);}", "test"),
      {{3.5, 0, 0}, {0, 0.5, 0}, view::Projection::perspective}, sampling);
  CHECK(find_fault(scene, 4, tally) == "");
  CHECK(tally.covered > 0);
}

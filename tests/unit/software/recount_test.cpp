#include "tests/unit/software/recount.h"

#include "tests/oracle/pixel_oracle.h"
#include "tests/support/drawing.h"
#include "tests/support/software_ways.h"
#include "tests/support/test.h"
#include "tests/unit/software/plain_tree.h"
#include "tests/unit/software/random_scenes.h"
#include "tests/unit/software/scenes.h"
#include "tests/unit/software/shown.h"

using namespace csgsim;
using software::Counts;
using software::Pruning;
using testing::RecordedRay;
using testing::Scene;
using testing::SoftwareScene;

namespace {

const std::vector<std::string> traversals{"standard", "early-out",      "positional",
                                          "status",   "bit-sequential", "bit-parallel"};

/// A scene as counted by the software, and the data for the recount.
struct Counted {
  SoftwareScene software;
  std::vector<testing::Seen> seen;
  software::RayCounts ray_counts;
  std::vector<RecordedRay> rays;
  testing::PlainTree tree;
  std::size_t primitives;
  std::size_t width;

  explicit Counted(const Scene& scene)
      : software(scene.tree, scene.geometry, scene.view),
        seen(testing::draw_by_rules(scene.tree, scene.geometry, scene.view)),
        rays(testing::record_rays(software.rays(), seen, ray_counts)),
        tree(scene.tree),
        primitives(scene.tree.primitives.size()),
        width(scene.view.sampling.width) {}

  [[nodiscard]] Counts counts_of(const std::string& way, Pruning pruning = Pruning::none) const {
    const std::unique_ptr<software::Method> method = software.make(testing::variant_named(way, pruning), true);
    software::draw(software.rays(), *method);
    return method->counts();
  }
};

void check_same(const Counts& found, const Counts& expected) {
  CHECK(found.points == expected.points);
  CHECK(found.evaluations == expected.evaluations);
  CHECK(found.precomputed == expected.precomputed);
  CHECK(found.looked_up == expected.looked_up);
  CHECK(found.pruned_nodes == expected.pruned_nodes);
  CHECK(found.node_visits == expected.node_visits);
  CHECK(found.early_outs == expected.early_outs);
  CHECK(found.list_steps == expected.list_steps);
  CHECK(found.list_elements == expected.list_elements);
  CHECK(found.ties == expected.ties);
}

void check_survey(const Counted& counted) {
  const software::Picture picture = counted.software.draw(testing::variant_named("standard"));
  const software::Survey found = software::survey(counted.software.rays(), picture);
  const software::Survey expected = testing::survey_rays(counted.rays);
  CHECK(found.rays == expected.rays);
  CHECK(found.met == expected.met);
  CHECK(found.hits == expected.hits);
  CHECK(found.points == expected.points);
  CHECK(found.sequences == expected.sequences);
  CHECK(found.different_sequences == expected.different_sequences);
  CHECK(found.combinations == expected.combinations);
  CHECK(found.max_points == expected.max_points);
}

/// Nodes visited to prune for cells: the tree for each 16 rows, then what is left of it for each 16 columns.
std::uint64_t pruned_for_cells(const testing::PlainTree& tree, const view::View& view) {
  std::uint64_t nodes = 0;
  const auto height = static_cast<std::int32_t>(view.sampling.height);
  for (std::int32_t row = 0; row < height; row += 16) {
    testing::Held there;
    for (const view::Extent& extent : view.extents)
      there.push_back(!extent.pixels.empty() && extent.pixels.y0 < row + 16 && extent.pixels.y1 >= row);
    nodes += tree.nodes() + (view.sampling.width + 15) / 16 * tree.nodes_with(there);
  }
  return nodes;
}

/// Trees are pruned for each cell; within a primitive, once for each primitive that is ever a ray's first to contain a
/// point.
void check_pruned(const Counted& counted, const view::View& view) {
  std::set<std::uint32_t> outermost;
  std::uint64_t points = 0;
  for (const RecordedRay& ray : counted.rays) {
    std::vector<std::uint32_t> entered;
    for (const testing::Point& point : ray.points) {
      for (std::size_t i = point.begin; i < point.end; ++i) {
        const std::uint32_t primitive = ray.events[i].primitive();
        if (std::erase(entered, primitive) == 0) entered.push_back(primitive);
      }
      if (!entered.empty()) outermost.insert(entered.front());
    }
    points += ray.points.size();
  }
  for (const std::string& traversal : traversals) {
    if (counted.software.is_too_deep(testing::variant_named(traversal))) continue;
    CAPTURE(traversal);
    const Counts by_cells = counted.counts_of(traversal, Pruning::cells);
    CHECK(by_cells.pruned_nodes == pruned_for_cells(counted.tree, view));
    CHECK(by_cells.evaluations + by_cells.looked_up == points);
    CHECK(by_cells.points == points);
    const Counts inside = counted.counts_of(traversal, Pruning::inside);
    CHECK(inside.pruned_nodes == outermost.size() * counted.tree.nodes());
    CHECK(inside.evaluations + inside.looked_up == points);
    CHECK(inside.evaluations <= counted.counts_of(traversal).evaluations);
  }
}

/// Checks that calls and returns are equally many.
void check_calls(const software::Operations& done) {
  CHECK(done.counts[static_cast<std::size_t>(software::Operation::call)] ==
        done.counts[static_cast<std::size_t>(software::Operation::come_back)]);
}

/// Checks the counts of a scene; returns its number of ties.
std::uint64_t check_scene(const Scene& scene) {
  const Counted counted(scene);
  std::uint64_t ties = 0;
  for (const software::CoherenceRow& row : software::coherences()) {
    const std::string name(row.name);
    CAPTURE(name);
    const testing::Coherence coherence = testing::coherence_of(name, counted.rays, counted.width);
    for (const std::string& traversal : traversals) {
      if (counted.software.is_too_deep(testing::variant_named(traversal))) continue;
      CAPTURE(traversal);
      const Counts expected =
          testing::recount_traversal(counted.tree, counted.primitives, traversal, coherence, counted.rays);
      check_same(counted.counts_of(fmt::format("{}/{}", traversal, name)), expected);
      ties = expected.ties;
    }
  }
  check_survey(counted);
  check_pruned(counted, scene.view);
  std::uint64_t events = 0;
  for (const RecordedRay& ray : counted.rays) events += ray.events.size();
  CHECK(counted.ray_counts.events == events);
  return ties;
}

}  // namespace

TEST_CASE("software counts equal a plain recount of rays and trees on random scenes") {
  std::uint64_t ties = 0;
  std::uint64_t scenes = 0;
  for (std::uint64_t seed = 5001; seed <= 5040; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene) continue;
    CAPTURE(seed);
    ties += check_scene(*scene);
    ++scenes;
  }
  CHECK(scenes > 30);
  CHECK(ties > 1000);
}
TEST_CASE("software counts equal a plain recount of rays and trees on the thesis's objects") {
  for (const testing::ThesisObject& one : testing::thesis_objects(view::Projection::perspective)) {
    CAPTURE(one.name);
    check_scene(testing::thesis_scene(one, 64, 64));
  }
}
TEST_CASE("every method counts as many returns as calls") {
  for (std::uint64_t seed = 5001; seed <= 5020; ++seed) {
    const std::optional<Scene> scene = testing::random_scene(seed);
    if (!scene) continue;
    CAPTURE(seed);
    const SoftwareScene drawn(scene->tree, scene->geometry, scene->view);
    for (const testing::MethodVariant& way : testing::all_variants()) {
      if (drawn.is_too_deep(way)) continue;
      const std::string name = testing::to_text(way);
      CAPTURE(name);
      const std::unique_ptr<software::Method> method = drawn.make(way, true);
      software::draw(drawn.rays(), *method);
      check_calls(method->counts().operations);
    }
    if (!testing::is_faceted(*scene)) continue;
    const testing::Shown shown(*scene);
    for (const software::DisplayRow* const row : software::display_methods()) {
      CAPTURE(row->name);
      const software::Displayed displayed = shown.by(*row, true);
      for (std::size_t phase = 0; phase < software::phases; ++phase)
        check_calls(displayed.counts.of(static_cast<software::Phase>(phase)));
      check_calls(displayed.counts.csg.operations);
    }
  }
}

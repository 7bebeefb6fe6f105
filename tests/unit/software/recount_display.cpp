#include "tests/unit/software/recount_display.h"

#include "tests/support/test.h"

namespace csgsim::testing {

using enum processors::Operation;

using software::Phase;

DisplayRecount::DisplayRecount(const Scene& of)
    : scene(of),
      tree(of.tree),
      primitives(of.tree.primitives.size()),
      binary(software::make_tree(of.tree, software::Shape::written)),
      facets(software::facets_of(of.tree, of.geometry)),
      screen(software::screen_facets(of.tree, of.geometry, of.view, facets)),
      rays(of),
      numbers(numbers_of(of)),
      farthest((1U << of.view.sampling.z_bits) - 1),
      seen(rays.size(), {farthest, software::VisibleSurface::nothing_seen}) {
  for (const software::ScreenFacet& facet : screen.facets) scans.push_back(scanned(screen, facet, rays));
  this->of(Phase::transformation) = transformed(facets.corners.size(), screen.facets.size(), screen.linears.size());
  this->of(Phase::initialisation) = rays.size() * steps({{store_long, 2}, branch_taken});
  expected.polygons = expected.pieces = static_cast<std::uint64_t>(
      std::ranges::count_if(facets.facets, [](const software::Facet& one) { return one.end - one.begin >= 3; }));
  expected.drawn_polygons = screen.facets.size();
  // Three coordinates per corner; three coefficients of two longs per plane and edge; and per facet its primitive, its
  // rectangle and a pointer.
  expected.words.polygons = 3 * facets.corners.size() + 6 * screen.linears.size() + 10 * screen.facets.size();
  expected.words.pixels = 2 * rays.size();
}

software::Displayed DisplayRecount::by(const std::string& method, std::size_t bucket_size,
                                       std::string_view directory) const {
  return software::display_method(method).run(
      {scene.tree, scene.geometry, scene.view, binary, facets, bucket_size, directory}, true);
}

void DisplayRecount::check(const software::Displayed& found) {
  CHECK(std::ranges::equal(found.picture.seen, seen));
  this->of(Phase::scan_conversion) += csg.operations;
  csg.operations = {};
  for (std::size_t phase = 0; phase < software::phases; ++phase) {
    INFO(std::string(software::phase_rows[phase].name));
    check_same(found.counts.operations[phase], expected.operations[phase]);
    csg.operations += expected.operations[phase];
  }
  check_same(found.counts.csg, csg);
  CHECK(found.counts.polygons == expected.polygons);
  CHECK(found.counts.pieces == expected.pieces);
  CHECK(found.counts.shared == expected.shared);
  CHECK(found.counts.references == expected.references);
  CHECK(found.counts.crossing_tests == expected.crossing_tests);
  CHECK(found.counts.overlap_tests == expected.overlap_tests);
  CHECK(found.counts.drawn_polygons == expected.drawn_polygons);
  CHECK(found.counts.pixel_events == expected.pixel_events);
  CHECK(found.counts.passes == expected.passes);
  CHECK(found.counts.spans == expected.spans);
  CHECK(found.counts.splits == expected.splits);
  CHECK(found.counts.cells == expected.cells);
  CHECK(found.counts.drawn_cells == expected.drawn_cells);
  CHECK(found.counts.visited_parts == expected.visited_parts);
  CHECK(found.counts.overfull_cells == expected.overfull_cells);
  CHECK(found.counts.conflicts == expected.conflicts);
  CHECK(found.counts.words.polygons == expected.words.polygons);
  CHECK(found.counts.words.buckets == expected.words.buckets);
  CHECK(found.counts.words.pixels == expected.words.pixels);
  CHECK(found.counts.words.sequences == expected.words.sequences);
}

void check_same(const Operations& found, const Operations& expected) {
  for (std::size_t kind = 0; kind < software::operation_kinds; ++kind) {
    INFO(std::string(software::operation_rows[kind].name));
    CHECK(found.counts[kind] == expected.counts[kind]);
  }
}

void check_same(const software::Counts& found, const software::Counts& expected) {
  CHECK(found.points == expected.points);
  CHECK(found.evaluations == expected.evaluations);
  CHECK(found.precomputed == expected.precomputed);
  CHECK(found.looked_up == expected.looked_up);
  CHECK(found.node_visits == expected.node_visits);
  CHECK(found.early_outs == expected.early_outs);
  CHECK(found.list_steps == expected.list_steps);
  CHECK(found.list_elements == expected.list_elements);
  CHECK(found.ties == expected.ties);
  check_same(found.operations, expected.operations);
}

}  // namespace csgsim::testing

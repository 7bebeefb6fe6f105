#include "sim/studies/display/measure.h"

#include <algorithm>
#include <limits>

#include "sim/software/display/rows.h"
#include "sim/software/facets/facets.h"
#include "sim/software/tree/tree.h"
#include "sim/studies/measured_row.h"

namespace csgsim::studies {

namespace {

void copy_counts(const software::DisplayCounts& counts, DisplayStudyRow& row) {
  row.polygons = counts.polygons;
  row.clipped_polygons = counts.pieces;
  row.shared_polygons = counts.shared;
  row.references = counts.references;
  row.drawn_polygons = counts.drawn_polygons;
  row.cells = counts.cells;
  row.drawn_cells = counts.drawn_cells;
  row.cell_visits = counts.visited_parts;
  row.overfull_cells = counts.overfull_cells;
  row.overlap_tests = counts.overlap_tests;
  row.crossing_tests = counts.crossing_tests;
  row.conflicts = counts.conflicts;
  row.passes = counts.passes;
  row.spans = counts.spans;
  row.splits = counts.splits;
  row.pixel_events = counts.pixel_events;
  row.points = counts.csg.points;
  row.evaluations = counts.csg.evaluations;
  row.list_steps = counts.csg.list_steps;
  row.list_elements = counts.csg.list_elements;
  row.polygon_words = counts.words.polygons;
  row.bucket_words = counts.words.buckets;
  row.pixel_words = counts.words.pixels;
  row.sequence_words = counts.words.sequences;
  row.words = counts.words.all();
  for (std::size_t phase = 0; phase < software::phases; ++phase) row.operations[phase] = {counts.operations[phase]};
}

/// Measures the minimum time of up to five runs, or fewer after 0.2 seconds.
void take_time(const software::DisplayRow& method, const software::DisplaySubject& subject, DisplayStudyRow& row) {
  constexpr unsigned max_runs = 5;
  constexpr double enough = 0.2;
  row.wall_seconds_preprocessing = row.wall_seconds_drawing = std::numeric_limits<double>::infinity();
  double spent = 0;
  for (unsigned i = 0; i < max_runs && spent < enough; ++i) {
    const software::Displayed displayed = method.run(subject, false);
    row.wall_seconds_preprocessing = std::min(row.wall_seconds_preprocessing, displayed.preprocessing_seconds);
    row.wall_seconds_drawing = std::min(row.wall_seconds_drawing, displayed.drawing_seconds);
    spent += displayed.preprocessing_seconds + displayed.drawing_seconds;
  }
}

}  // namespace

DisplaySeconds display_seconds(const DisplayStudyRow& row, const software::Priced& processor) {
  DisplaySeconds seconds;
  if (!processor.processor) {
    seconds.of[0] = row.wall_seconds_preprocessing;
    seconds.total = row.wall_seconds_drawing;
    return seconds;
  }
  for (std::size_t phase = 0; phase < software::phases; ++phase) {
    seconds.of[phase] = processors::seconds(row.operations[phase].operations, *processor.processor);
    if (phase != 0) seconds.total += *seconds.of[phase];
  }
  return seconds;
}

DisplayStudyRow measure_display(const DisplayPoint& point, const Inputs& inputs, const model::Tree& tree,
                                const facet::Geometry& geometry, const view::View& view) {
  return measured_row<DisplayStudyRow>(point, inputs, [&](DisplayStudyRow& row) {
    const software::DisplayRow& method = software::display_method(point.method);
    const software::Tree balanced = software::make_tree(tree, software::Shape::balanced);
    const software::Facets facets = software::facets_of(tree, geometry);
    software::DisplaySubject subject{tree, geometry, view, balanced, facets};
    if (point.bucket_size != 0) {
      subject.bucket_size = point.bucket_size;
      subject.directory = point.directory;
    }
    const software::Displayed displayed = method.run(subject, true);
    copy_counts(displayed.counts, row);
    row.primitives = tree.primitives.size();
    row.halfspaces = geometry.halfspaces();
    row.wrong = displayed.faults.all();
    row.wrong_depth_bits = displayed.faults.depth_bits;
    row.wrong_coincident = displayed.faults.coincident;
    row.wrong_three_way = displayed.faults.three_way;
    row.wrong_order = displayed.faults.order;
    row.surfaces = software::hash_of(displayed.picture);
    take_time(method, subject, row);
  });
}

}  // namespace csgsim::studies

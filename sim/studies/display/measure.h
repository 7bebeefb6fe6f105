// Points, rows and measurements of display methods.
// Used by csgsim display.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "sim/software/display/phases.h"
#include "sim/software/work.h"
#include "sim/studies/inputs.h"
#include "sim/studies/operations_cell.h"

namespace csgsim::studies {

/// A way to display a model, including how it is faceted.
struct DisplayPoint {
  std::string method;
  std::optional<double> tolerance{};  ///< faceting tolerance, model units; empty: given by the model or `fragments`
  unsigned fragments = 0;             ///< fragments per circle; 0: as in the model
  unsigned bucket_size = 0;           ///< maximum polygons per bucket; 0 for a method without buckets
  std::string directory = "none";     ///< directory of the buckets

  static void columns(auto& point, const auto& visit) {
    visit("method", point.method);
    visit("tolerance", point.tolerance);
    visit("fragments", point.fragments);
    visit("bucket_size", point.bucket_size);
    visit("directory", point.directory);
  }
};

/// Results of a point. Operations are counted by kind and by phase, so that they can be priced for any processor.
struct DisplayStudyRow {
  static constexpr std::size_t point_columns = 5;

  DisplayPoint point;
  Inputs inputs;
  std::uint64_t primitives = 0;
  std::uint64_t halfspaces = 0;
  std::uint64_t polygons = 0;
  std::uint64_t clipped_polygons = 0;
  std::uint64_t shared_polygons = 0;
  std::uint64_t references = 0;
  std::uint64_t drawn_polygons = 0;
  std::uint64_t cells = 0;
  std::uint64_t drawn_cells = 0;
  std::uint64_t cell_visits = 0;
  std::uint64_t overfull_cells = 0;
  std::uint64_t overlap_tests = 0;
  std::uint64_t crossing_tests = 0;
  std::uint64_t conflicts = 0;
  std::uint64_t passes = 0;
  std::uint64_t spans = 0;
  std::uint64_t splits = 0;
  std::uint64_t pixel_events = 0;
  std::uint64_t points = 0;
  std::uint64_t evaluations = 0;
  std::uint64_t list_steps = 0;
  std::uint64_t list_elements = 0;
  std::uint64_t polygon_words = 0;
  std::uint64_t bucket_words = 0;
  std::uint64_t pixel_words = 0;
  std::uint64_t sequence_words = 0;
  std::uint64_t words = 0;
  std::uint64_t wrong = 0;
  std::uint64_t wrong_depth_bits = 0;
  std::uint64_t wrong_coincident = 0;
  std::uint64_t wrong_three_way = 0;
  std::uint64_t wrong_order = 0;
  std::array<OperationsCell, software::phases> operations{};
  double wall_seconds_preprocessing = 0;
  double wall_seconds_drawing = 0;
  std::string surfaces;  ///< hash of depth and owner of every pixel
  std::string reason;

  [[nodiscard]] bool is_drawn() const { return reason.empty(); }

  static void columns(auto& row, const auto& visit) {
    DisplayPoint::columns(row.point, visit);
    Inputs::columns(row.inputs, visit);
    visit("primitives", row.primitives);
    visit("halfspaces", row.halfspaces);
    visit("polygons", row.polygons);
    visit("clipped_polygons", row.clipped_polygons);
    visit("shared_polygons", row.shared_polygons);
    visit("references", row.references);
    visit("drawn_polygons", row.drawn_polygons);
    visit("cells", row.cells);
    visit("drawn_cells", row.drawn_cells);
    visit("cell_visits", row.cell_visits);
    visit("overfull_cells", row.overfull_cells);
    visit("overlap_tests", row.overlap_tests);
    visit("crossing_tests", row.crossing_tests);
    visit("conflicts", row.conflicts);
    visit("passes", row.passes);
    visit("spans", row.spans);
    visit("splits", row.splits);
    visit("pixel_events", row.pixel_events);
    visit("points", row.points);
    visit("evaluations", row.evaluations);
    visit("list_steps", row.list_steps);
    visit("list_elements", row.list_elements);
    visit("polygon_words", row.polygon_words);
    visit("bucket_words", row.bucket_words);
    visit("pixel_words", row.pixel_words);
    visit("sequence_words", row.sequence_words);
    visit("words", row.words);
    visit("wrong", row.wrong);
    visit("wrong_depth_bits", row.wrong_depth_bits);
    visit("wrong_coincident", row.wrong_coincident);
    visit("wrong_three_way", row.wrong_three_way);
    visit("wrong_order", row.wrong_order);
    visit("preprocessing_operations", row.operations[0]);
    visit("transformation_operations", row.operations[1]);
    visit("sort_operations", row.operations[2]);
    visit("scan_conversion_operations", row.operations[3]);
    visit("depth_test_operations", row.operations[4]);
    visit("initialisation_operations", row.operations[5]);
    visit("wall_seconds_preprocessing", row.wall_seconds_preprocessing);
    visit("wall_seconds_drawing", row.wall_seconds_drawing);
    visit("surfaces", row.surfaces);
    visit("reason", row.reason);
  }
};

/// Seconds by phase as in table 5.1 of the thesis. On this computer, only preprocessing and total are measured.
struct DisplaySeconds {
  std::array<std::optional<double>, software::phases> of{};
  double total = 0;  ///< without preprocessing

  [[nodiscard]] double preprocessing() const { return of[0].value_or(0); }
};

DisplaySeconds display_seconds(const DisplayStudyRow& row, const software::Priced& processor);

/// Draws the picture once to count operations, then repeatedly to measure time. If the method cannot draw it, the row
/// holds the reason.
DisplayStudyRow measure_display(const DisplayPoint& point, const Inputs& inputs, const model::Tree& tree,
                                const facet::Geometry& geometry, const view::View& view);

}  // namespace csgsim::studies

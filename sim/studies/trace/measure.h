// Points, rows and measurements of ray tracing.
// Used by csgsim trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/facet/geometry.h"
#include "host/lighting/lighting.h"
#include "host/model/tree.h"
#include "host/scene/scene.h"
#include "host/view/projection.h"
#include "sim/software/tracing/trace.h"
#include "sim/software/work.h"
#include "sim/studies/inputs.h"
#include "sim/studies/operations_cell.h"

namespace csgsim::studies {

/// A way to trace a picture.
struct TracePoint {
  std::string directory;
  std::uint32_t bucket_size = 0;    ///< maximum facets per cell
  std::string cast;                 ///< rays that are cast: primary; shadow: also shadow rays; mirror: all three
  std::string facet_test{};         ///< for primary rays: space or projected
  std::string item_buffer{};        ///< `without`, `list-priority` or `depth-lists`
  std::string mailboxes;            ///< `with` or `without`
  std::optional<double> tolerance;  ///< faceting tolerance of curved solids, model units; empty: given by the options

  bool operator==(const TracePoint&) const = default;

  static void columns(auto& point, const auto& visit) {
    visit("directory", point.directory);
    visit("bucket_size", point.bucket_size);
    visit("cast", point.cast);
    visit("facet_test", point.facet_test);
    visit("item_buffer", point.item_buffer);
    visit("mailboxes", point.mailboxes);
    visit("tolerance", point.tolerance);
  }
};

/// Results of a point. Operations are counted by kind, so that they can be priced for any processor.
struct TraceRow {
  static constexpr std::size_t point_columns = 7;

  TracePoint point;
  Inputs inputs;
  std::uint64_t primitives = 0;
  std::uint64_t halfspaces = 0;
  std::uint64_t polygons = 0;
  std::uint64_t loose_facets = 0;
  std::uint64_t cells = 0;
  std::uint64_t entries = 0;
  std::uint64_t references = 0;
  std::uint64_t most_facets = 0;
  std::uint64_t overflows = 0;
  std::uint64_t splits = 0;
  std::uint64_t overlap_tests = 0;
  std::uint64_t directory_words = 0;
  std::uint64_t bucket_words = 0;
  std::uint64_t words = 0;
  std::uint64_t rays = 0;
  std::uint64_t hit_rays = 0;
  std::uint64_t shadow_rays = 0;
  std::uint64_t mirror_rays = 0;
  std::uint64_t cell_visits = 0;
  std::string rays_by_cells;  ///< number of primary rays that visited 0, 1, 2, ... cells
  std::uint64_t facet_tests = 0;
  std::uint64_t loose_tests = 0;
  std::uint64_t facets_met = 0;
  std::uint64_t repeats = 0;
  std::uint64_t items = 0;        ///< surfaces drawn at pixels by a projective pass
  std::uint64_t item_faults = 0;  ///< pixels at which list priority differs from the machines
  std::uint64_t evaluations = 0;
  std::uint64_t list_elements = 0;
  OperationsCell build_operations;
  OperationsCell projection_operations;
  OperationsCell traversal_operations;
  OperationsCell intersection_operations;
  OperationsCell operations;  ///< to classify the intersections
  OperationsCell shade_operations;
  double wall_seconds_build = 0;
  double wall_seconds_trace = 0;
  std::string surfaces;  ///< hash of depth and owner of every pixel
  std::string reason;

  [[nodiscard]] bool is_drawn() const { return reason.empty(); }

  static void columns(auto& row, const auto& visit) {
    TracePoint::columns(row.point, visit);
    Inputs::columns(row.inputs, visit);
    visit("primitives", row.primitives);
    visit("halfspaces", row.halfspaces);
    visit("polygons", row.polygons);
    visit("loose_facets", row.loose_facets);
    visit("cells", row.cells);
    visit("entries", row.entries);
    visit("references", row.references);
    visit("most_facets", row.most_facets);
    visit("overflows", row.overflows);
    visit("splits", row.splits);
    visit("overlap_tests", row.overlap_tests);
    visit("directory_words", row.directory_words);
    visit("bucket_words", row.bucket_words);
    visit("words", row.words);
    visit("rays", row.rays);
    visit("hit_rays", row.hit_rays);
    visit("shadow_rays", row.shadow_rays);
    visit("mirror_rays", row.mirror_rays);
    visit("cell_visits", row.cell_visits);
    visit("rays_by_cells", row.rays_by_cells);
    visit("facet_tests", row.facet_tests);
    visit("loose_tests", row.loose_tests);
    visit("facets_met", row.facets_met);
    visit("repeats", row.repeats);
    visit("items", row.items);
    visit("item_faults", row.item_faults);
    visit("evaluations", row.evaluations);
    visit("list_elements", row.list_elements);
    visit("build_operations", row.build_operations);
    visit("projection_operations", row.projection_operations);
    visit("traversal_operations", row.traversal_operations);
    visit("intersection_operations", row.intersection_operations);
    visit("operations", row.operations);
    visit("shade_operations", row.shade_operations);
    visit("wall_seconds_build", row.wall_seconds_build);
    visit("wall_seconds_trace", row.wall_seconds_trace);
    visit("surfaces", row.surfaces);
    visit("reason", row.reason);
  }
};

/// Seconds of a picture by purpose; on this computer only `all` is measured.
struct TraceSeconds {
  double projection = 0;  ///< seconds to project facets and to fill an item buffer
  double traversal = 0;
  double intersection = 0;
  double classification = 0;
  double shading = 0;
  double all = 0;
};
TraceSeconds seconds_of(const TraceRow& row, const software::Priced& processor);
/// Seconds to build the directory.
double build_seconds_of(const TraceRow& row, const software::Priced& processor);

/// A model with facets of one tolerance, its lights and mirrors.
class TraceSubject {
 public:
  /// Keeps a reference to the model. Mirrors are the flat faces with a mirroring material, or all facets if there are
  /// none.
  TraceSubject(const model::Tree& model, facet::Geometry geometry, view::View view, const scene::Scene& look,
               unsigned mirror_depth);

  TraceSubject(const TraceSubject&) = delete;
  TraceSubject& operator=(const TraceSubject&) = delete;

  [[nodiscard]] const software::TraceScene& scene() const { return scene_; }
  [[nodiscard]] std::size_t primitive_count() const { return model_.primitives.size(); }
  /// Throws InputError if the point's item buffer is filled by list priority, which cannot draw the model.
  [[nodiscard]] software::TraceOptions options_of(const TracePoint& point) const;
  /// Number of pixels for which list priority differs from the machines.
  [[nodiscard]] std::uint64_t item_faults() const { return priority_drawing().faults; }

 private:
  /// Cost of drawing the picture by list priority, and its wrong pixels.
  struct PriorityDrawing {
    software::PriorityPass pass;
    std::uint64_t faults = 0;
  };
  /// Draws the picture on the first call.
  const PriorityDrawing& priority_drawing() const;

  const model::Tree& model_;
  facet::Geometry geometry_;
  view::View view_;
  software::Tree tree_;
  software::TraceScene scene_;
  unsigned mirror_depth_;
  std::vector<software::TraceLight> lights_;
  std::vector<std::uint8_t> mirrors_;
  mutable std::optional<PriorityDrawing> drawn_first_;
};

/// Builds the directory and traces the picture once to count operations, then measures the time.
TraceRow measure_trace(const TracePoint& point, const Inputs& inputs, const TraceSubject& subject);

}  // namespace csgsim::studies

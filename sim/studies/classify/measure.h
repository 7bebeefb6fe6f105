// Points, rows and measurements of classification methods.
// Used by csgsim classify.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "sim/software/work.h"
#include "sim/studies/inputs.h"
#include "sim/studies/operations_cell.h"

namespace csgsim::studies {

/// A way to classify the rays of a picture.
struct ClassifyPoint {
  std::string method;
  std::string coherence;  ///< `none` if the method has no coherence
  std::string shape;      ///< shape of the tree
  std::string reduced;    ///< how trees are pruned in advance

  bool operator==(const ClassifyPoint&) const = default;

  static void columns(auto& point, const auto& visit) {
    visit("method", point.method);
    visit("coherence", point.coherence);
    visit("shape", point.shape);
    visit("reduced", point.reduced);
  }
};

/// Results of a point. Operations are counted by kind, so that they can be priced for any processor.
struct ClassifyRow {
  static constexpr std::size_t point_columns = 4;

  ClassifyPoint point;
  Inputs inputs;
  std::uint64_t primitives = 0;
  std::uint64_t halfspaces = 0;
  std::uint64_t tree_levels = 0;
  std::uint64_t rays = 0;
  std::uint64_t met_rays = 0;
  std::uint64_t hit_rays = 0;
  std::uint64_t sequences = 0;
  std::uint64_t different_sequences = 0;
  std::uint64_t combinations = 0;
  std::uint64_t max_points = 0;
  std::uint64_t points = 0;
  std::uint64_t evaluations = 0;
  std::uint64_t looked_up = 0;
  std::uint64_t precomputed = 0;
  std::uint64_t pruned_nodes = 0;
  std::uint64_t node_visits = 0;
  std::uint64_t early_outs = 0;
  std::uint64_t list_steps = 0;
  std::uint64_t list_elements = 0;
  std::uint64_t ties = 0;
  std::uint64_t words = 0;
  std::uint64_t halfspace_tests = 0;
  OperationsCell ray_operations;           ///< to intersect rays and primitives
  OperationsCell sort_operations;          ///< to sort the intersections
  OperationsCell operations;               ///< to classify the intersections
  OperationsCell traversal_operations;     ///< subset of `operations`: flips and evaluations of the tree
  double wall_seconds_rays = 0;            ///< time on this computer to find and sort the intersections
  double wall_seconds_classification = 0;  ///< time on this computer to classify them
  std::string surfaces;                    ///< hash of depth and owner of every pixel
  std::string reason;

  [[nodiscard]] bool is_drawn() const { return reason.empty(); }

  static void columns(auto& row, const auto& visit) {
    ClassifyPoint::columns(row.point, visit);
    Inputs::columns(row.inputs, visit);
    visit("primitives", row.primitives);
    visit("halfspaces", row.halfspaces);
    visit("tree_levels", row.tree_levels);
    visit("rays", row.rays);
    visit("met_rays", row.met_rays);
    visit("hit_rays", row.hit_rays);
    visit("sequences", row.sequences);
    visit("different_sequences", row.different_sequences);
    visit("combinations", row.combinations);
    visit("most_points", row.max_points);
    visit("points", row.points);
    visit("evaluations", row.evaluations);
    visit("looked_up", row.looked_up);
    visit("precomputed", row.precomputed);
    visit("pruned_nodes", row.pruned_nodes);
    visit("node_visits", row.node_visits);
    visit("early_outs", row.early_outs);
    visit("list_steps", row.list_steps);
    visit("list_elements", row.list_elements);
    visit("ties", row.ties);
    visit("words", row.words);
    visit("halfspace_tests", row.halfspace_tests);
    visit("ray_operations", row.ray_operations);
    visit("sort_operations", row.sort_operations);
    visit("operations", row.operations);
    visit("traversal_operations", row.traversal_operations);
    visit("wall_seconds_rays", row.wall_seconds_rays);
    visit("wall_seconds_classification", row.wall_seconds_classification);
    visit("surfaces", row.surfaces);
    visit("reason", row.reason);
  }
};

software::PricedSeconds seconds_of(const ClassifyRow& row, const software::Priced& processor);

/// Data shared by all rows of a picture.
struct Scene {
  const model::Tree& tree;
  const facet::Geometry& geometry;
  const view::View& view;
  std::optional<software::Survey>& survey;  ///< survey of its rays; created for the first measured row
};

/// Draws the picture twice: once to count operations, once to measure time. If the method cannot draw it, the row holds
/// the reason.
ClassifyRow measure(const ClassifyPoint& point, const Inputs& inputs, const Scene& scene);

}  // namespace csgsim::studies

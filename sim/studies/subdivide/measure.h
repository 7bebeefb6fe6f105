// Rows and measurements of subdivided pictures.
// Used by csgsim subdivide.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>

#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/machines/machine.h"
#include "sim/studies/inputs.h"

namespace csgsim::studies {

/// The remaining work in each square of a subdivided picture (thesis 7.3.3, 7.4.3). Means are over the touched squares.
struct Squares {
  std::uint64_t count = 0;
  std::uint64_t touched = 0;                          ///< touched by the pixel rectangle of a primitive
  double primitives = 0;                              ///< mean number of primitives that touch a square
  double halfspaces = 0;                              ///< mean number of their half-spaces
  double kept_primitives = 0;                         ///< mean number drawn after pruning
  double kept_halfspaces = 0;                         ///< mean number drawn after pruning
  double comparisons = 0;                             ///< mean number of comparisons of primitives with Z1
  std::optional<std::uint64_t> clocks{};              ///< clocks of the frame; empty if no machine draws it this way
  std::optional<std::uint64_t> instruction_clocks{};  ///< total over the renderers; empty if the machine has none

  static void columns(auto& squares, const auto& visit) {
    visit("count", squares.count);
    visit("touched", squares.touched);
    visit("primitives_mean", squares.primitives);
    visit("halfspaces_mean", squares.halfspaces);
    visit("kept_primitives_mean", squares.kept_primitives);
    visit("kept_halfspaces_mean", squares.kept_halfspaces);
    visit("comparisons_mean", squares.comparisons);
    visit("clocks", squares.clocks);
    visit("instruction_clocks", squares.instruction_clocks);
  }
};

/// Seconds per stage of a frame (thesis table 7.3); empty if the machine does not report stages.
struct Stages {
  std::optional<std::uint64_t> halfspace_tests{};  ///< tests of the first pruning that cost the machine time
  /// Half-spaces of all primitives that touch a segment, the tests that would be necessary without pruning.
  std::optional<std::uint64_t> halfspaces_touching{};
  std::optional<double> broadcast_halfspaces{};  ///< mean over the drawn segments
  std::optional<double> transformation{};        ///< seconds to transform half-spaces
  std::optional<double> first_pruning{};
  std::optional<double> second_pruning{};
  std::optional<double> communication{};  ///< receiving the model from the host, broadcasting and sharing
  /// The nodes' work at pixels. The next three members are its parts, in proportion to the clocks at pixels.
  std::optional<double> rendering{};
  std::optional<double> scan_conversion{};
  std::optional<double> classification{};
  std::optional<double> depth_sort{};
  std::optional<double> total{};

  static void columns(auto& stages, const auto& visit) {
    visit("first_halfspace_tests", stages.halfspace_tests);
    visit("halfspaces_touching", stages.halfspaces_touching);
    visit("broadcast_halfspaces_mean", stages.broadcast_halfspaces);
    visit("seconds_transformation", stages.transformation);
    visit("seconds_first_pruning", stages.first_pruning);
    visit("seconds_second_pruning", stages.second_pruning);
    visit("seconds_communication", stages.communication);
    visit("seconds_rendering", stages.rendering);
    visit("seconds_scan_conversion", stages.scan_conversion);
    visit("seconds_classification", stages.classification);
    visit("seconds_depth_sort", stages.depth_sort);
    visit("seconds_total", stages.total);
  }
};

/// The remaining work for one subdivision of a picture.
struct SubdivideRow {
  static constexpr std::size_t point_columns = 2;

  unsigned subdivisions = 0;  ///< number of binary subdivisions into segments
  std::optional<double>
      tolerance{};  ///< faceting tolerance of curved solids, model units; empty: the same for all points
  Inputs inputs;
  std::uint64_t primitives = 0;  ///< primitives of the model
  std::uint64_t halfspaces = 0;  ///< half-spaces of the model, including quadrics
  Squares segments;
  Squares subsegments;
  Stages stages;

  [[nodiscard]] bool has_stages() const { return stages.total.has_value(); }

  static void columns(auto& row, const auto& visit) {
    const auto visit_part = [&](const std::string& name, auto& part) {
      std::remove_cvref_t<decltype(part)>::columns(
          part, [&](const char* column, auto& member) { visit((name + "_" + column).c_str(), member); });
    };
    visit("subdivisions", row.subdivisions);
    visit("tolerance", row.tolerance);
    Inputs::columns(row.inputs, visit);
    visit("primitives", row.primitives);
    visit("halfspaces", row.halfspaces);
    visit_part("segments", row.segments);
    visit_part("subsegments", row.subsegments);
    visit_part("stages", row.stages);
  }
};

/// The subject of a measurement and its options.
struct Subdivided {
  const model::Tree& tree;
  const facet::Geometry& scene;
  const view::View& view;
  const machines::Machine& machine;  ///< must be of a kind that draws square by square
  emit::Options options;
};

/// Measures `levels` binary subdivisions; the caller sets the point and the inputs. Throws InputError if the model does
/// not fit the machine.
SubdivideRow measure_squares(const Subdivided& subdivided, unsigned levels);

}  // namespace csgsim::studies

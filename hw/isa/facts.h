// Names and statistics of a Program.
// Used by hw/wave, host/emit and sim.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hw/isa/depth_scale.h"
#include "hw/isa/field_role.h"
#include "hw/isa/program.h"

namespace csgsim::isa {

/// Counts of the model, for the statistics.
struct ModelFacts {
  std::string file;
  std::uint64_t primitives = 0;
  std::uint64_t unions = 0;
  std::uint64_t differences = 0;
  std::uint64_t intersections = 0;
  std::uint64_t halfspaces = 0;

  bool operator==(const ModelFacts&) const = default;
};

/// The options and results of compilation, for the statistics.
struct CompileFacts {
  std::string strategy;
  std::string colouring;
  std::uint32_t z_bits = 0;
  std::uint32_t fraction_bits = 0;
  double edge_on_fraction = 0;       ///< fraction of a pixel
  std::uint32_t stack_bits = 0;      ///< bits of pixel memory that the classification uses
  std::uint32_t tree_depth = 0;      ///< levels of the deepest active tree
  std::uint64_t rendered = 0;        ///< scan-conversions of primitives whose surface goes into Z1
  std::uint64_t classified = 0;      ///< scan-conversions of active-tree primitives that are compared with Z1
  std::uint64_t depth_tests = 0;     ///< comparisons of Z1 with Z2
  std::vector<std::string> effects;  ///< flat shading first, then the effects that the scene uses

  bool operator==(const CompileFacts&) const = default;
};

/// Statistics of a pruning during compilation. An item is a pair of primitives for `space` and `separation`, a
/// primitive in a block for `halfspaces`, and a surface for `hidden`.
struct PruningFacts {
  std::string name;               ///< as in --pruning
  std::uint64_t tried = 0;        ///< items to which it was applied
  std::uint64_t decided = 0;      ///< tried items that turned out to need no instructions
  std::uint64_t left = 0;         ///< items to which it was not applied, because the test was not worth its time
  std::uint64_t saved = 0;        ///< estimated instructions for the decided items
  std::uint64_t nanoseconds = 0;  ///< time of the host for the tried items; 0 for an ideal host

  bool operator==(const PruningFacts&) const = default;
};

/// Names and parameters of a Program for statistics, pictures and waves. No hardware reads them.
struct Facts {
  std::vector<NamedField> fields;
  std::vector<std::string> primitives;  ///< one name per primitive
  /// The primitive of each piece, in order of pieces (hw/isa/pieces.h); origins name pieces. Empty if each primitive is
  /// one piece.
  std::vector<std::uint32_t> primitive_of_piece{};
  DepthScale depth_scale;
  ModelFacts model;
  CompileFacts compile;
  std::vector<PruningFacts> prunings{};  ///< prunings that were considered

  bool operator==(const Facts&) const = default;
};

/// The first named field with the given role; width 0 if there is none.
Field find_field(const Program& program, FieldRole role);

}  // namespace csgsim::isa

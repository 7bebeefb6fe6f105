#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/software/cost/operations.h"
#include "sim/software/methods/counts.h"

namespace csgsim::software {

/// What the time of a picture goes into (thesis, table 5.1).
enum class Phase : std::uint8_t {
  preprocessing,    ///< clipping of polygons, once a model
  transformation,   ///< of polygons into the picture
  sorting,          ///< buckets and polygons in order of depth, or what takes the place of that
  scan_conversion,  /// of polygons, and the CSG test
  depth_test,
  initialisation,  ///< of what pixels have
};

struct PhaseRow {
  const char* name;
  const char* meaning;
};

/// In the order of the enumerators.
inline constexpr std::array phase_rows{
    PhaseRow{"preprocessing", "preprocessing"}, PhaseRow{"transformation", "transformation"},
    PhaseRow{"sorting", "retrieval and sort"},  PhaseRow{"scan_conversion", "scan conversion and CSG test"},
    PhaseRow{"depth_test", "depth test"},       PhaseRow{"initialisation", "initialisation of buffers"},
};

inline constexpr std::size_t phases = phase_rows.size();
static_assert(phases == static_cast<std::size_t>(Phase::initialisation) + 1);

/// Memory of a method, words of 32 bits.
struct DisplayWords {
  std::uint64_t polygons = 0;   ///< in space and in the picture
  std::uint64_t buckets = 0;    ///< and the directory of them
  std::uint64_t pixels = 0;     ///< what pixels have: depths, pointers, lists of events, what is seen
  std::uint64_t sequences = 0;  ///< the tree of sequences of surfaces, and the CSG tree

  [[nodiscard]] std::uint64_t all() const { return polygons + buckets + pixels + sequences; }
};

/// What drawing a picture facet by facet takes.
struct DisplayCounts {
  std::uint64_t polygons = 0;        ///< of the model
  std::uint64_t pieces = 0;          ///< that clipping them against each other makes of them
  std::uint64_t shared = 0;          ///< of these, in several cells
  std::uint64_t references = 0;      ///< parts of them in cells, in all
  std::uint64_t crossing_tests = 0;  ///< pairs of polygons that were held against each other
  std::uint64_t overlap_tests = 0;   ///< of a polygon and a cell
  std::uint64_t drawn_polygons = 0;  ///< that have pixels
  std::uint64_t pixel_events = 0;    ///< surfaces that were found at pixels, each time that they were
  std::uint64_t passes = 0;          ///< over all facets
  std::uint64_t spans = 0;           ///< of rows, that were evaluated at their ends
  std::uint64_t splits = 0;          ///< of spans in which the order of surfaces may change
  std::uint64_t cells = 0;           ///< with polygons in them
  std::uint64_t drawn_cells = 0;     ///< of these, in the viewing cone
  std::uint64_t looked_parts = 0;    ///< of space, cells among them, that were looked at for their order
  std::uint64_t overfull_cells = 0;  ///< with more polygons than a bucket takes
  std::uint64_t conflicts = 0;       ///< polygons that were drawn before one that they may hide, since no order is left
  Counts csg;                        ///< of classification; its operations are of all phases
  DisplayWords words;
  std::array<Operations, phases> operations{};

  [[nodiscard]] const Operations& of(Phase phase) const { return operations[static_cast<std::size_t>(phase)]; }
};

/// Counts operations by phase. `Count` is what a method is compiled with: CountingMethod or UncountedMethod.
template <class Count>
class Ledger {
 public:
  Count& operator[](Phase phase) { return counts_[static_cast<std::size_t>(phase)]; }

  /// Adds up what was counted.
  void tell(DisplayCounts& counts) const {
    counts.csg = {};
    for (std::size_t phase = 0; phase < phases; ++phase) {
      const Counts one = counts_[phase].counts_so_far();
      counts.operations[phase] = one.operations;
      counts.csg.points += one.points;
      counts.csg.evaluations += one.evaluations;
      counts.csg.precomputed += one.precomputed;
      counts.csg.looked_up += one.looked_up;
      counts.csg.node_visits += one.node_visits;
      counts.csg.early_outs += one.early_outs;
      counts.csg.list_steps += one.list_steps;
      counts.csg.list_elements += one.list_elements;
      counts.csg.ties += one.ties;
      counts.csg.operations += one.operations;
    }
  }

 private:
  std::array<Count, phases> counts_{};
};

}  // namespace csgsim::software

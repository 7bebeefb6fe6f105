// Phases, memory and counts of the display methods.
// Used by sim/studies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/software/cost/operations.h"
#include "sim/software/methods/counts.h"

namespace csgsim::software {

/// Phases of the time of a picture (thesis, table 5.1).
enum class Phase : std::uint8_t {
  preprocessing,    ///< clipping of polygons, once per model
  transformation,   ///< transformation of polygons into the picture
  sorting,          ///< depth order of buckets and polygons, or an equivalent step
  scan_conversion,  ///< scan conversion of polygons, and the CSG test
  depth_test,
  initialisation,  ///< initialization of pixel data
};

struct PhaseRow {
  const char* name;
  const char* meaning;
};

/// Rows in the order of the enumerators.
inline constexpr std::array phase_rows{
    PhaseRow{"preprocessing", "preprocessing"}, PhaseRow{"transformation", "transformation"},
    PhaseRow{"sorting", "retrieval and sort"},  PhaseRow{"scan_conversion", "scan conversion and CSG test"},
    PhaseRow{"depth_test", "depth test"},       PhaseRow{"initialisation", "initialisation of buffers"},
};

inline constexpr std::size_t phases = phase_rows.size();
static_assert(phases == static_cast<std::size_t>(Phase::initialisation) + 1);

/// Memory of a method in 32-bit words.
struct DisplayWords {
  std::uint64_t polygons = 0;   ///< in space and in the picture
  std::uint64_t buckets = 0;    ///< buckets and their directory
  std::uint64_t pixels = 0;     ///< data of pixels: depths, pointers, lists of events, visible surfaces
  std::uint64_t sequences = 0;  ///< the tree of surface sequences, and the CSG tree

  [[nodiscard]] std::uint64_t all() const { return polygons + buckets + pixels + sequences; }
};

/// Counts of drawing a picture facet by facet.
struct DisplayCounts {
  std::uint64_t polygons = 0;        ///< polygons of the model
  std::uint64_t pieces = 0;          ///< polygons after clipping against each other
  std::uint64_t shared = 0;          ///< clipped polygons in several cells
  std::uint64_t references = 0;      ///< total number of polygon parts in cells
  std::uint64_t crossing_tests = 0;  ///< tested pairs of polygons
  std::uint64_t overlap_tests = 0;   ///< tests of a polygon against a cell
  std::uint64_t drawn_polygons = 0;  ///< polygons with pixels
  std::uint64_t pixel_events = 0;    ///< surfaces found at pixels, counted each time
  std::uint64_t passes = 0;          ///< passes over all facets
  std::uint64_t spans = 0;           ///< spans of rows evaluated at their ends
  std::uint64_t splits = 0;          ///< spans split because the order of surfaces may change
  std::uint64_t cells = 0;           ///< cells with polygons
  std::uint64_t drawn_cells = 0;     ///< cells with polygons in the viewing cone
  std::uint64_t visited_parts = 0;   ///< parts of space, including cells, visited to determine their order
  std::uint64_t overfull_cells = 0;  ///< cells with more polygons than the bucket size
  std::uint64_t conflicts = 0;       ///< polygons drawn before others that may hide them, because no order exists
  Counts csg;                        ///< classification counts; `operations` covers all phases
  DisplayWords words;
  std::array<Operations, phases> operations{};

  [[nodiscard]] const Operations& of(Phase phase) const { return operations[static_cast<std::size_t>(phase)]; }
};

/// Counts operations by phase. `Count` is CountingMethod or UncountedMethod.
template <class Count>
class Ledger {
 public:
  Count& operator[](Phase phase) { return counts_[static_cast<std::size_t>(phase)]; }

  /// Sets the operations of each phase, and the sum of the phases' classification counts. Their words, pruned nodes and
  /// traversals are not summed.
  void store_counts(DisplayCounts& counts) const {
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

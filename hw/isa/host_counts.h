// Counts of host and division work for a Program.
// Used by hw/division, hw/host, hw/multi_processor, hw/pixel_square, host/csg, host/effects, host/emit, sim/observe,
// sim/session, sim/studies and sim/suite.
#pragma once

#include <cstdint>
#include <vector>

namespace csgsim::isa {

/// Counts of the part of the model in a region, for the statistics.
struct SegmentFacts {
  std::uint32_t primitives = 0;       ///< primitives that are active in the region
  std::uint32_t halfspaces = 0;       ///< half-spaces of those primitives
  std::uint32_t kept_primitives = 0;  ///< primitives that remain after pruning
  std::uint32_t kept_halfspaces = 0;  ///< half-spaces of those primitives' surfaces that remain after pruning
  std::uint32_t comparisons = 0;      ///< comparisons of primitives with the surface in Z1

  constexpr bool operator==(const SegmentFacts&) const = default;
};

/// Work of the host before it writes instructions, counted by the host itself; docs/host.md has the rules. A whole
/// frame has at most max_prepared of each.
struct Preparation {
  std::uint64_t planes = 0;      ///< planes transformed to the picture
  std::uint64_t points = 0;      ///< points of solids transformed to the picture
  std::uint64_t colours = 0;     ///< colours computed
  std::uint64_t boxes = 0;       ///< tests of a box against another
  std::uint64_t halfspaces = 0;  ///< tests of a half-space against the corners of a rectangle
  std::uint64_t values = 0;      ///< comparisons of plane values at single pixels
  std::uint64_t supports = 0;    ///< tests of a point against a direction in space
  std::uint64_t nodes = 0;       ///< visits of tree nodes
  std::uint64_t products = 0;    ///< distinct coordinates multiplied by a number of the camera's matrix
  std::uint64_t quotients = 0;   ///< divisions by a distance or a slope in perspective or depth

  Preparation& operator+=(const Preparation& more) {
    planes += more.planes;
    points += more.points;
    colours += more.colours;
    boxes += more.boxes;
    halfspaces += more.halfspaces;
    values += more.values;
    supports += more.supports;
    nodes += more.nodes;
    products += more.products;
    quotients += more.quotients;
    return *this;
  }
  constexpr bool operator==(const Preparation&) const = default;
};

inline constexpr std::uint64_t max_prepared = std::uint64_t{1} << 48;

/// The work of a machine that divides the model itself, for one surface in a region or for several surfaces where only
/// the boxes are tested; docs/machines/pixel-square.md has the rules. Each count has 64 bits. The machine tests first,
/// then writes.
struct DivisionStep {
  std::uint64_t boxes = 0;         ///< tests of a primitive's box against the region's
  std::uint64_t lists = 0;         ///< lists of half-spaces read, without empty lists
  std::uint64_t halfspaces = 0;    ///< half-spaces in those lists, each tested at the four corners of a rectangle
  std::uint64_t cells = 0;         ///< tests of a side's half-space against the leaders of a cell
  std::uint64_t nodes = 0;         ///< visits of tree nodes
  std::uint64_t instructions = 0;  ///< instructions of the region that this step writes

  DivisionStep& operator+=(const DivisionStep& more) {
    boxes += more.boxes;
    lists += more.lists;
    halfspaces += more.halfspaces;
    cells += more.cells;
    nodes += more.nodes;
    instructions += more.instructions;
    return *this;
  }
  constexpr bool operator==(const DivisionStep&) const = default;
};

/// The work of a machine that divides the model itself for a region, as counted by the host.
struct DivisionCounts {
  std::vector<DivisionStep> steps;
  std::uint64_t group_boxes = 0;       ///< boxes tested before the first region of a group
  std::uint64_t group_lists = 0;       ///< lists read before the first region of a group
  std::uint64_t group_halfspaces = 0;  ///< half-spaces tested before the first region of a group
  std::uint64_t group_cells = 0;       ///< cell tests before the first region of a group
  std::uint64_t group_entries = 0;     ///< primitives and half-spaces kept for the group, counted with its first region

  /// The sum of all steps.
  [[nodiscard]] DivisionStep sum() const {
    DivisionStep all;
    for (const DivisionStep& step : steps) all += step;
    return all;
  }
  bool operator==(const DivisionCounts&) const = default;
};

}  // namespace csgsim::isa

#pragma once

#include <cstdint>
#include <vector>

namespace csgsim::isa {

/// Counts of the part of the model in a region, for the stats.
struct SegmentFacts {
  std::uint32_t primitives = 0;       ///< active in the region
  std::uint32_t halfspaces = 0;       ///< of those primitives
  std::uint32_t kept_primitives = 0;  ///< of the primitives, those that pruning leaves to be drawn
  std::uint32_t kept_halfspaces = 0;  ///< of the half-spaces, those that pruning leaves to those primitives' surfaces
  std::uint32_t comparisons = 0;      ///< of primitives with Z1, to classify it

  constexpr bool operator==(const SegmentFacts&) const = default;
};

/// What the host does before it writes instructions, as it counts it itself; docs/host.md has the rules. Of a whole
/// frame at most most_prepared of each.
struct Preparation {
  std::uint64_t planes = 0;      ///< transformed to the picture
  std::uint64_t points = 0;      ///< of solids, transformed to the picture
  std::uint64_t colours = 0;     ///< worked out
  std::uint64_t boxes = 0;       ///< held against another
  std::uint64_t halfspaces = 0;  ///< held against the corners of a rectangle
  std::uint64_t values = 0;      ///< of planes at single pixels, held against another
  std::uint64_t supports = 0;    ///< points held against a direction in space
  std::uint64_t nodes = 0;       ///< of the tree, looked at

  Preparation& operator+=(const Preparation& more) {
    planes += more.planes;
    points += more.points;
    colours += more.colours;
    boxes += more.boxes;
    halfspaces += more.halfspaces;
    values += more.values;
    supports += more.supports;
    nodes += more.nodes;
    return *this;
  }
  constexpr bool operator==(const Preparation&) const = default;
};

inline constexpr std::uint64_t most_prepared = std::uint64_t{1} << 48;

/// The work of a machine that divides the model itself, for one surface in a region, or for several surfaces whose
/// boxes alone are tested; docs/machines/pixel-square.md has the rules. Each count has 64 bits. The machine tests
/// first, then writes.
struct DivisionStep {
  std::uint64_t boxes = 0;         ///< of primitives, held against the region's
  std::uint64_t lists = 0;         ///< of half-spaces that are read, empty ones left out
  std::uint64_t halfspaces = 0;    ///< in them, each tested at the four corners of a rectangle
  std::uint64_t cells = 0;         ///< times that a half-space of a side is held against the leaders of a cell
  std::uint64_t nodes = 0;         ///< of the tree, looked at
  std::uint64_t instructions = 0;  ///< of the region, those that come next

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

/// What such a machine does for a region, as the host counts it.
struct DivisionCounts {
  std::vector<DivisionStep> steps;
  std::uint64_t group_boxes = 0;       ///< before the first region of a group
  std::uint64_t group_lists = 0;       ///< the same
  std::uint64_t group_halfspaces = 0;  ///< the same
  std::uint64_t group_cells = 0;       ///< the same
  std::uint64_t group_entries = 0;     ///< primitives and half-spaces that the group leaves, with its first region

  /// All steps together.
  [[nodiscard]] DivisionStep sum() const {
    DivisionStep all;
    for (const DivisionStep& step : steps) all += step;
    return all;
  }
  bool operator==(const DivisionCounts&) const = default;
};

}  // namespace csgsim::isa

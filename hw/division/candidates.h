// Primitives and half-spaces from which a square is divided, and their selection for a group of squares.
// Used by hw/multi_processor.
#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/datapath.h"
#include "hw/division/display_model.h"

namespace csgsim::division {

/// Input of a square's division: the whole model, or the survivors of its group of squares.
struct Candidates {
  std::vector<std::uint32_t> primitives;  ///< listed primitives, in ascending order
  /// Per primitive of the model: the numbers of its listed half-spaces.
  std::vector<std::vector<std::uint32_t>> halfspaces;
  std::vector<bool> listed;  ///< whether each primitive of the model is listed

  /// Number of entries of the divider's list: one per primitive and one per half-space.
  [[nodiscard]] std::uint64_t entry_count() const;
};

/// Candidates that list the whole model.
Candidates all_candidates(const DisplayModel& model);

/// First level (thesis 7.4.2): the part of the whole model that can matter in any square of a group. Compares the
/// rectangle of every primitive with the group's, and tests the half-spaces of each overlapping primitive at the
/// corners of the overlap. Drops primitives that are disjoint from the group or have a half-space that contains nothing
/// of the overlap at any depth. Drops half-spaces that contain the whole overlap at every depth, and those that cannot
/// be the extreme of their side, because a leader (cells.h) exceeds them everywhere.
///
/// Squares of the group get the same instructions as from the whole model.
Candidates survivors(Datapath& path, const Candidates& candidates, const Rectangle& group);

}  // namespace csgsim::division

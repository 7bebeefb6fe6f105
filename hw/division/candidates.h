#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/datapath.h"
#include "hw/division/display_model.h"

namespace csgsim::division {

/// What a square is divided from: the whole model, or what its group of squares leaves of it.
struct Candidates {
  std::vector<std::uint32_t> primitives;               ///< those in the list, ascending
  std::vector<std::vector<std::uint32_t>> halfspaces;  ///< one list a primitive of the model, of their numbers
  std::vector<bool> listed;                            ///< one a primitive of the model

  /// Entries of the divider's list: one a primitive and one a half-space.
  [[nodiscard]] std::uint64_t entries() const;
};

/// The whole model.
Candidates all_of(const DisplayModel& model);

/// First level (thesis 7.4.2): what of the whole model can matter in any square of a group. Every primitive's rectangle
/// is held against the group's, and the half-spaces of those that touch it are held against the corners of what they
/// share. Left out are primitives disjoint from it or with a half-space that holds nothing of it at any depth,
/// half-spaces that hold all of it at every depth, and those that a leader of the primitive's side is beyond.
///
/// Squares of the group are given the same instructions as from the whole model.
Candidates survivors(Datapath& path, const Candidates& all, const Rectangle& group);

}  // namespace csgsim::division

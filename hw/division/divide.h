// The divider: computes the instructions of a square, or of a group of squares, from a display model.
// Used by hw/multi_processor and hw/pixel_square.
#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/candidates.h"
#include "hw/division/counts.h"
#include "hw/division/datapath.h"
#include "hw/division/display_model.h"
#include "hw/division/tree.h"
#include "hw/isa/instruction.h"
#include "hw/isa/program.h"

namespace csgsim::division {

/// The division of one square.
struct SquareDivision {
  /// Empty if the square shows only the background and is not the whole picture.
  std::vector<isa::Instruction> instructions;
  /// One step per surface whose boxes overlap the square and each other. A step includes the boxes visited since the
  /// previous surface; the operations after the last surface form a separate step, if there are any.
  std::vector<Counts> steps;

  [[nodiscard]] Counts counts() const;
  [[nodiscard]] PeakUsage peak_usage() const { return peak_usage_of(steps); }
};

/// State of the divider apart from planes and half-spaces: computed once, as the model is received.
class Divider {
 public:
  /// The model must be valid (validate()). Its planes and half-spaces are not stored.
  explicit Divider(const DisplayModel& model);

  /// Divides the square from the whole model, or from the survivors of the group that contains it.
  SquareDivision divide(const isa::Region& square, const Candidates& candidates, Datapath& path) const;
  SquareDivision divide(const isa::Region& square, Datapath& path) const { return divide(square, all_, path); }

  /// Performs the first of two levels: selects the candidates for the squares of a group.
  [[nodiscard]] Candidates survivors(const isa::Region& group, Datapath& path) const {
    return division::survivors(path, all_, rectangle_of(group));
  }

  [[nodiscard]] const Candidates& all() const { return all_; }

 private:
  ModelHeader header_;
  std::vector<bool> joined_;  ///< whether each primitive is joined with the previous one
  Tree tree_;
  Candidates all_;
};

/// The divisions of a group's squares, in the order in which they were made, and the operations for the whole group.
struct DividedGroup {
  std::vector<SquareDivision> squares;
  Counts group;
  std::uint64_t entries = 0;  ///< entries of the candidate list from which the squares were divided
  /// Whether the survivors fit the list; if not, each square is divided from the whole model.
  bool fits = true;
};

/// Divides a group in two levels, with a list of `list_entries` entries between them.
DividedGroup divide_group(const Divider& divider, const isa::Region& group, const std::vector<isa::Region>& squares,
                          std::uint64_t list_entries, Datapath& path);

}  // namespace csgsim::division

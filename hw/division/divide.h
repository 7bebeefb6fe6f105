#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/candidates.h"
#include "hw/division/counts.h"
#include "hw/division/display_model.h"
#include "hw/division/tree.h"
#include "hw/isa/instruction.h"
#include "hw/isa/program.h"

namespace csgsim::division {

/// What the divider makes of one square.
struct Divided {
  std::vector<isa::Instruction> instructions;  ///< none, if the square shows the background and is not the picture
  Counts counts;
  AtHand at_hand;
};

/// The divider of the pixel-square machine, without its clocks: a model comes once, then squares are divided from it.
class Divider {
 public:
  /// The model has to be sound (validate).
  explicit Divider(DisplayModel model);

  /// One level: the square from the whole model.
  [[nodiscard]] Divided divide(const isa::Region& square) const { return divide(square, all_); }

  /// The second of two levels: the square from the survivors of a group that it lies in.
  [[nodiscard]] Divided divide(const isa::Region& square, const Candidates& from) const;

  /// The first of two levels.
  [[nodiscard]] Candidates survivors(const isa::Region& group, Counts& counts) const {
    return division::survivors(model_, rectangle_of(group), counts);
  }

  [[nodiscard]] const DisplayModel& model() const { return model_; }
  [[nodiscard]] const Candidates& all() const { return all_; }

 private:
  DisplayModel model_;
  Tree tree_;
  Candidates all_;
};

/// The squares of a group, in the order in which they are divided, and what the group cost.
struct DividedGroup {
  std::vector<Divided> squares;
  Counts group;
  std::uint64_t entries = 0;  ///< of the list that the squares were divided from
  bool fits = true;           ///< the survivors fitted the list; if not, each square is divided from the whole model
};

/// Two levels, with a list of that many entries between them.
DividedGroup divide_group(const Divider& divider, const isa::Region& group, const std::vector<isa::Region>& squares,
                          std::uint64_t list_entries);

}  // namespace csgsim::division

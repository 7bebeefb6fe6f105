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

/// What the divider makes of one square.
struct Divided {
  std::vector<isa::Instruction> instructions;  ///< none, if the square shows the background and is not the picture
  /// What it does for each surface whose boxes have something in common with the square and each other, with the boxes
  /// that it has looked at since the one before; at the end what is left to do, if anything is.
  std::vector<Counts> steps;

  [[nodiscard]] Counts counts() const;
  [[nodiscard]] AtHand at_hand() const { return at_hand_of(steps); }
};

/// What it knows of a model besides the records: worked out once, as the model comes.
class Divider {
 public:
  /// The model has to be sound (validate). Of its planes and half-spaces nothing is kept.
  explicit Divider(const DisplayModel& model);

  /// The square from the whole model, or from the survivors of a group that it lies in.
  Divided divide(const isa::Region& square, const Candidates& from, Datapath& path) const;
  Divided divide(const isa::Region& square, Datapath& path) const { return divide(square, all_, path); }

  /// The first of two levels.
  [[nodiscard]] Candidates survivors(const isa::Region& group, Datapath& path) const {
    return division::survivors(path, all_, rectangle_of(group));
  }

  [[nodiscard]] const Candidates& all() const { return all_; }

 private:
  ModelHeader header_;
  std::vector<bool> joined_;  ///< a primitive each
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
                          std::uint64_t list_entries, Datapath& path);

}  // namespace csgsim::division

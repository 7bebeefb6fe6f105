#pragma once

#include <cstdint>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::testing {

/// Decides when a primitive's surface is the model's, by the operators as stated in the model.
class TreeRules {
 public:
  /// Keeps a reference to the tree.
  explicit TreeRules(const model::Tree& tree);

  /// Whether the model contains a point, given in `held` which primitives contain it.
  [[nodiscard]] bool holds(const std::vector<bool>& held) const;

  /// Whether the primitive is on the right of an odd number of differences, so that its back is the visible side.
  [[nodiscard]] bool is_subtracted(std::uint32_t primitive) const { return places_[leaf_of_[primitive]].is_subtracted; }

  /// Whether the primitive's surface can be the model's just behind a point: no operator up to the root removes it. A
  /// union hides nothing (its other operands have separate surfaces); an intersection or difference hides points
  /// outside its other operands; under the right of a difference the roles are exchanged. `held` lists the primitives
  /// that contain the point.
  [[nodiscard]] bool shows(std::uint32_t primitive, const std::vector<bool>& held) const;

 private:
  /// The constant properties of a node.
  struct Place {
    std::uint32_t parent = model::no_index;
    bool is_subtracted = false;
  };

  const model::Tree& tree_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> leaf_of_;
};

}  // namespace csgsim::testing

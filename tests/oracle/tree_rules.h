#pragma once

#include <cstdint>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::testing {

/// When a primitive's surface is the model's, by the operators as the model states them.
class TreeRules {
 public:
  /// Keeps a reference to the tree.
  explicit TreeRules(const model::Tree& tree);

  /// Whether the model holds a point. `held` says of each primitive whether it does.
  [[nodiscard]] bool holds(const std::vector<bool>& held) const;

  /// Whether the primitive is on the right of an odd number of differences: then its back is what can be seen.
  [[nodiscard]] bool taken_away(std::uint32_t primitive) const { return places_[leaf_of_[primitive]].taken_away; }

  /// Whether the primitive's surface can be the model's just behind a point: up to the root no operator takes it away.
  /// A union hides nothing (its other operands have surfaces of their own); an intersection or difference hides what is
  /// outside its other operands; under the right of a difference the parts are exchanged. `held` says of each primitive
  /// whether it holds the point.
  [[nodiscard]] bool shows(std::uint32_t primitive, const std::vector<bool>& held) const;

 private:
  /// What is fixed about a node.
  struct Place {
    std::uint32_t parent = model::no_index;
    bool taken_away = false;
  };

  const model::Tree& tree_;
  std::vector<Place> places_;
  std::vector<std::uint32_t> leaf_of_;
};

}  // namespace csgsim::testing

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/coherences/list_structure.h"
#include "sim/software/traversals/status.h"
#include "sim/software/tree/owners.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// The list structure of a picture, whose back pointers tell what a ray is in (thesis 4.5.3, 5.3.1); where the class of
/// a point is not known, the status tree finds it out.
template <class Count>
class Sequences {
 public:
  static constexpr std::uint32_t none = ListElements<Count>::none;

  /// Keeps a reference to the tree, which is not constant.
  Sequences(const Tree& tree, Count& count)
      : count_(count), elements_(tree, count), status_(tree), owners_(tree), held_(tree.leaf_of.size()) {}

  std::uint32_t after(std::uint32_t element, std::uint32_t primitive) {
    return elements_.after(element, primitive, count_);
  }

  /// Whether the points behind an element are in the solid. `is_first`: behind one surface alone.
  bool is_in(std::uint32_t element, bool is_first) {
    const auto evaluate = [&] {
      const std::vector<std::uint32_t> held = held_at(element);
      for (const std::uint32_t primitive : held) status_.flip(primitive, count_);
      count_.evaluation();
      const bool is_in = status_.evaluate(count_);
      for (const std::uint32_t primitive : held) status_.flip(primitive, count_);
      return is_in;
    };
    return elements_.is_in(element, is_first, evaluate, count_);
  }

  /// Primitives that a ray is in behind an element: those that are met an odd number of times on the way back.
  std::vector<std::uint32_t> held_at(std::uint32_t element) {
    std::vector<std::uint32_t> met;
    for (std::uint32_t at = element; at != none; at = elements_.father_of(at))
      met.push_back(elements_.primitive_of(at));
    elements_.count_back(met.size(), count_);
    for (const std::uint32_t primitive : met) held_[primitive] ^= 1U;
    std::vector<std::uint32_t> held;
    for (const std::uint32_t primitive : met) {
      if (held_[primitive] != 0) held.push_back(primitive);
      held_[primitive] = 0;
    }
    return held;
  }

  std::uint32_t owner(std::span<const Event> before, std::span<const Event> at) {
    return owners_.seen(before, at, count_);
  }

  [[nodiscard]] std::uint64_t words() const { return elements_.words() + status_.words(); }

 private:
  Count& count_;
  ListElements<Count> elements_;
  StatusTree<Count> status_;
  Owners<Count> owners_;
  std::vector<std::uint8_t> held_;
};

}  // namespace csgsim::software

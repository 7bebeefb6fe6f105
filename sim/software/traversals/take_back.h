// Undoing of flips of a traversal.
// Used by evaluations.h and by methods that evaluate single points.
#pragma once

#include <cstdint>
#include <span>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// Flips each of these primitives.
template <class Traversal, class Count>
void flip_all(Traversal& traversal, std::span<const std::uint32_t> primitives, Count& count) {
  count(Operation::call, primitives.size());
  for (const std::uint32_t primitive : primitives) traversal.flip(primitive, count);
}

/// Resets a traversal to a point outside all primitives; `in` are the primitives that contain the current point. Uses
/// the traversal's own `clear` if it has one, and otherwise leaves each primitive.
template <class Traversal, class Count>
void undo_flips(Traversal& traversal, std::span<const std::uint32_t> containing_primitives, Count& count) {
  if constexpr (requires { traversal.clear(count); }) {
    traversal.clear(count);
  } else {
    flip_all(traversal, containing_primitives, count);
  }
}

}  // namespace csgsim::software

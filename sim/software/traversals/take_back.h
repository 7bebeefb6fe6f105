#pragma once

#include <cstdint>
#include <span>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// Flips each of these primitives, by a call each.
template <class Traversal, class Count>
void flip_all(Traversal& traversal, std::span<const std::uint32_t> primitives, Count& count) {
  count(Operation::call, primitives.size());
  for (const std::uint32_t primitive : primitives) traversal.flip(primitive, count);
}

/// A traversal is outside all primitives again; `in` are those that it was in. By a step of its own (`clear`), if it
/// has one, else by leaving each.
template <class Traversal, class Count>
void take_back(Traversal& traversal, std::span<const std::uint32_t> in, Count& count) {
  if constexpr (requires { traversal.clear(count); }) {
    traversal.clear(count);
  } else {
    flip_all(traversal, in, count);
  }
}

}  // namespace csgsim::software

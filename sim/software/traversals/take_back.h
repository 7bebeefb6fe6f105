#pragma once

#include <cstdint>
#include <span>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// A traversal is outside all primitives again; `in` are those that it was in. By a step of its own (`clear`), if it
/// has one, else by leaving each.
template <class Traversal, class Count>
void take_back(Traversal& traversal, std::span<const std::uint32_t> in, Count& count) {
  if constexpr (requires { traversal.clear(count); }) {
    traversal.clear(count);
  } else {
    for (const std::uint32_t primitive : in) {
      count(Operation::call);
      traversal.flip(primitive, count);
    }
  }
}

}  // namespace csgsim::software

#pragma once

#include <verilated.h>

#include <concepts>
#include <cstddef>
#include <cstdint>

#include "tests/rtl/vector.h"

namespace csgsim::rtl {

/// The value on wires, which Verilator represents as a number or as words of 32 bits.
template <std::unsigned_integral Number>
void assign(Vector& to, Number from) {
  to.assign(1, from);
}

template <std::size_t Words>
void assign(Vector& to, const VlWide<Words>& from) {
  to.assign((Words + 1) / 2, 0);
  for (std::size_t i = 0; i < Words; ++i) to[i / 2] |= std::uint64_t{from[i]} << (i % 2 * 32);
}

/// A rising edge of the clock.
template <class Top>
void step(Top& top) {
  top.clk = 0;
  top.eval();
  top.clk = 1;
  top.eval();
}

}  // namespace csgsim::rtl

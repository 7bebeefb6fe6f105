#pragma once

#include <cstdint>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::emit {

/// Which bits of pixel memory hold what.
struct Layout {
  isa::Field depth;      ///< Z2: the nearest surface so far
  isa::Field candidate;  ///< Z1: the surface being classified
  isa::Field colour;
  isa::Field mask;                ///< 1 where Z1 holds a surface that is still visible
  std::vector<isa::Field> stack;  ///< results of the classification, one bit each
};

/// What has to fit.
struct Needs {
  unsigned z_bits = 0;
  unsigned colour_bits = 0;
  unsigned stack_bits = 0;  ///< besides the mask
};

/// Throws InputError that says how many bits are missing, and what to give up, if the memory does not hold them.
Layout plan_layout(const Needs& needs, std::uint32_t memory_bits);

std::vector<isa::NamedField> named_fields(const Layout& layout);

}  // namespace csgsim::emit

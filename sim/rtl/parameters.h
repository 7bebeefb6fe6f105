#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::rtl {

/// A parameter of the module `pixel_planes` of hw/rtl.
struct Parameter {
  std::string_view name;
  std::uint32_t value = 0;
  std::string_view figure;  ///< of the machine's description that it comes from; empty: chosen here
};

/// Pixels of a chip, which share word lines and their decoders, where the machine has as many.
inline constexpr std::uint32_t most_chip_pixels = 64;

/// The machine in parameters, in the order of the module. Pixels have the flag for roots where the trees are of degree
/// 2, or the Program, if there is one, takes a root. Throws InputError, with the mend, for a machine that the Verilog
/// does not have: another kind, trees of several bits or with fewer registers.
std::vector<Parameter> parameters_of(const machines::Machine& machine, const isa::Program* program = nullptr);

}  // namespace csgsim::rtl

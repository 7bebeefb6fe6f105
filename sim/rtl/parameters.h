// Verilog parameters of a machine.
// Used by design.cpp.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/machine.h"

namespace csgsim::rtl {

/// A parameter of the module `pixel_planes` in hw/rtl.
struct Parameter {
  std::string_view name;
  std::uint32_t value = 0;
  std::string_view figure;  ///< key in the machine description; empty if verilog_parameters() chooses the value
};

/// Maximum number of pixels of a chip, which share word lines and their decoders.
inline constexpr std::uint32_t max_chip_pixels = 64;

/// The module parameters of a machine, in the order of the module. Pixels have the flag for roots if the trees have
/// degree 2 or the Program (if not null) contains the instruction `root`. Throws InputError with a fix for machines
/// that the Verilog does not support: another kind, trees that process several bits per clock or have fewer registers.
std::vector<Parameter> verilog_parameters(const machines::Machine& machine, const isa::Program* program = nullptr);

}  // namespace csgsim::rtl

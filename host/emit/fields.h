// Parts of fields of pixel memory.
// Used by host/effects.
#pragma once

#include <array>
#include <cstdint>

#include "hw/isa/colour_format.h"
#include "hw/isa/instruction.h"

namespace csgsim::emit {

/// The `width` bits of a field from bit `first_bit` on.
constexpr isa::Field subfield(isa::Field field, unsigned first_bit, unsigned width) {
  return {static_cast<std::uint16_t>(field.base + first_bit), static_cast<std::uint16_t>(width)};
}

/// The red, green and blue parts of a colour field.
constexpr std::array<isa::Field, 3> colour_channels(isa::Field colour) {
  const std::array<unsigned, 3> widths = isa::channel_widths(colour.width);
  return {subfield(colour, widths[2] + widths[1], widths[0]), subfield(colour, widths[2], widths[1]),
          subfield(colour, 0, widths[2])};
}

}  // namespace csgsim::emit

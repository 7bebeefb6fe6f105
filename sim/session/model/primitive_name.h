// Resolves primitives and pixels named in options.
// Used by sim/session, sim/app and sim/viewer.
#pragma once

#include <cstdint>
#include <string>

#include "hw/isa/program.h"

namespace csgsim::session {

/// The primitive that an option names by its index, `3` or `p3`, by its name, `cylinder@9:9`, or by its line in the
/// model's file, `@9` or `cylinder@9`, if the line has only one. Throws UsageError and suggests the nearest name.
std::uint32_t parse_primitive(const isa::Program& program, const std::string& text, const std::string& option);

/// A pixel of a picture.
struct Pixel {
  std::uint32_t x = 0;
  std::uint32_t y = 0;
};

/// The pixel that an option names as `x,y`. Throws UsageError.
Pixel parse_pixel(const isa::Program& program, const std::string& text, const std::string& option);

}  // namespace csgsim::session

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hw/isa/program.h"
#include "sim/observe/frame.h"
#include "sim/report/page.h"

namespace csgsim::report {

/// Of what stands out: the pages' (page.css).
inline constexpr std::array<std::uint8_t, 3> mark_colour{192, 85, 16};

/// A frame as it is shown.
Picture picture_of(const observe::Frame& frame, const isa::Program& program, std::string caption, std::string alt);

/// Which primitive is seen, a colour each (observe::owner_colour). Owners are primitives (observe::of_primitives).
Picture owners_of(const observe::Frame& frame, std::string caption, std::string alt);

/// A Program and the picture that it draws.
struct DrawnProgram {
  const isa::Program& program;
  const observe::Frame& frame;
};

/// How two pictures of one size differ.
struct Difference {
  Picture picture;                     ///< A's in light grey, with the pixels marked that differ
  std::uint64_t pixels = 0;            ///< that show another colour or primitive
  std::vector<std::uint32_t> differs;  ///< of each pixel in row order: 1 if it does, else 0
  std::size_t first = 0;               ///< pixel that differs, in row order
};

Difference difference_of(const DrawnProgram& a, const DrawnProgram& b, std::string caption, std::string alt);

}  // namespace csgsim::report

// Frames and their differences as PNG pictures.
// Used by sim/report, sim/app, sim/session and sim/viewer.
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

/// Highlight colour of the pages (page.css).
inline constexpr std::array<std::uint8_t, 3> mark_colour{192, 85, 16};

/// The frame as displayed.
Picture picture_of(const observe::Frame& frame, const isa::Program& program, std::string caption, std::string alt);

/// The visible primitives, in one colour each (observe::owner_colour). Owners are primitives
/// (observe::with_primitive_owners).
Picture owners_of(const observe::Frame& frame, std::string caption, std::string alt);

/// A Program and its picture.
struct DrawnProgram {
  const isa::Program& program;
  const observe::Frame& frame;
};

/// The difference of two pictures of one size.
struct Difference {
  Picture picture;                     ///< A in light grey, with the differing pixels marked
  std::uint64_t pixels = 0;            ///< pixels that differ in colour or primitive
  std::vector<std::uint32_t> differs;  ///< 1 for each differing pixel, else 0, in row order
  std::size_t first = 0;               ///< first differing pixel, in row order
};

/// Compares two pictures of the same size; `caption` and `alt` are those of the resulting picture.
Difference difference_of(const DrawnProgram& a, const DrawnProgram& b, std::string caption, std::string alt);

}  // namespace csgsim::report

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hw/isa/program.h"

namespace csgsim::scan_line {

/// Input of a frame; all references must outlive the run. Line i belongs to chain i mod (number of chains).
struct PictureLines {
  std::span<const isa::Segment> lines;        ///< one row each, all of equal width
  std::span<const isa::RowExtent> extents{};  ///< row extents of the primitives in the host's list
  isa::Field colour;                          ///< field that the refresh displays
  std::uint32_t background = 0;               ///< colour of a line without instructions

  [[nodiscard]] std::uint32_t pixels() const { return lines.empty() ? 0 : lines.front().region.width; }
};

}  // namespace csgsim::scan_line

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hw/isa/program.h"

namespace csgsim::scan_line {

/// What is drawn; all of it has to live until the run is done. Line i belongs to chain i mod chains.
struct PictureLines {
  std::span<const isa::Segment> lines;        ///< each of one row, all equally wide
  std::span<const isa::RowExtent> extents{};  ///< of what the host keeps in its list
  isa::Field colour;                          ///< which the refresh shows
  std::uint32_t background = 0;               ///< which it shows for a line without instructions

  [[nodiscard]] std::uint32_t pixels() const { return lines.empty() ? 0 : lines.front().region.width; }
};

}  // namespace csgsim::scan_line

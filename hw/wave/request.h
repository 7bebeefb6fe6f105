// Parameters of a wave.
// Used by hw and sim/waves.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "hw/isa/program.h"

namespace csgsim::wave {

/// A pixel of the picture.
struct Pixel {
  std::uint32_t x = 0;
  std::uint32_t y = 0;

  constexpr bool operator==(const Pixel&) const = default;
};

/// A level of a multiplier tree on the path from the root, level 0, to a probed pixel.
struct TreeLevel {
  enum class Axis : std::uint8_t { x, y };

  Axis axis = Axis::x;
  unsigned level = 0;

  constexpr bool operator==(const TreeLevel&) const = default;
};

/// A range of clocks of a frame, counted from its first clock, 0; `end` is the first clock after it.
struct Window {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;

  constexpr bool operator==(const Window&) const = default;
};

/// The parts of a run to record.
struct Request {
  std::vector<Window> windows;  ///< in ascending order, none empty, with gaps between them
  std::vector<Pixel> pixels;
  std::vector<TreeLevel> tree_levels;           ///< levels to show for each pixel
  std::function<void(std::string_view)> write;  ///< receives the file's text piece by piece
};

}  // namespace csgsim::wave

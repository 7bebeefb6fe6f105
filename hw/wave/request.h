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

/// A level of a multiplier tree, on the way from the root to a probed pixel: level 0 is the root.
struct TreeLevel {
  enum class Axis : std::uint8_t { x, y };

  Axis axis = Axis::x;
  unsigned level = 0;

  constexpr bool operator==(const TreeLevel&) const = default;
};

/// Clocks of a frame, from the first on, 0; `end` is the first that no longer belongs to it.
struct Window {
  std::uint64_t begin = 0;
  std::uint64_t end = 0;

  constexpr bool operator==(const Window&) const = default;
};

/// What to record of a run.
struct Request {
  std::vector<Window> windows;  ///< in order, none empty, none touching the next
  std::vector<Pixel> pixels;
  std::vector<TreeLevel> tree_levels;           ///< to be shown for each of the pixels
  std::function<void(std::string_view)> write;  ///< takes the file's text, piece by piece
};

}  // namespace csgsim::wave

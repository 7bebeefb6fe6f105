#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Machines of which kinds have a figure.
struct Kinds {
  bool frame_buffer = true;
  bool scan_line = true;
  bool pixel_square = true;

  [[nodiscard]] constexpr bool has(Kind kind) const {
    return kind == Kind::frame_buffer ? frame_buffer : kind == Kind::scan_line ? scan_line : pixel_square;
  }
};

/// One key of a machine description: a table with `value`, `unit`, `provenance` and `source`.
struct FigureSchema {
  Kinds kinds;
  std::string_view key;
  std::string_view unit;
  std::int64_t least;  ///< of the value
  std::int64_t most;   ///< of the value
  std::string_view meaning;
  void (*store)(Machine& machine, std::int64_t value);  ///< puts a value within range where the simulator looks
  std::span<const std::string_view> names{};            ///< the value is one of these strings, counted from 0
};

/// Every figure that a description has to give, if it has that kind, besides its `name`, `description` and `kind`.
std::span<const FigureSchema> schema();

}  // namespace csgsim::machines

#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "hw/machines/machine.h"

namespace csgsim::machines {

/// One key of a machine description: a table with `value` (an integer), `unit`, `provenance` and `source`.
struct FigureSchema {
  std::string_view key;
  std::string_view unit;
  std::int64_t least;  ///< of the value
  std::int64_t most;   ///< of the value
  std::string_view meaning;
  void (*store)(Machine& machine, std::int64_t value);  ///< puts a value within range where the simulator looks
};

/// Every figure that a description has to give, besides its `name` and `description`.
std::span<const FigureSchema> schema();

}  // namespace csgsim::machines

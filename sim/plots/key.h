// The key (legend) of a plot.
// Used by the layouts of charts and bars.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "sim/plots/drawing.h"

namespace csgsim::plots {

enum class Sample : std::uint8_t { line, mark, level, fill, none };

/// An entry of a plot's key.
struct KeyEntry {
  std::string text;
  Sample sample = Sample::none;
  palette::Look look{};
};

/// Adds the entries in columns between `left` and `right`, starting at `top`; returns the y coordinate at which the key
/// ends.
double add_key(Drawing& drawing, std::span<const KeyEntry> entries, double left, double right, double top);

}  // namespace csgsim::plots

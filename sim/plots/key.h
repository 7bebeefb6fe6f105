#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "sim/plots/drawing.h"

namespace csgsim::plots {

enum class Sample : std::uint8_t { line, mark, level, fill, none };

/// A line of a plot's key.
struct KeyEntry {
  std::string text;
  Sample sample = Sample::none;
  palette::Look look{};
};

/// Adds the entries in columns between two edges, from `top` on; returns where the key ends.
double add_key(Drawing& drawing, std::span<const KeyEntry> entries, double left, double right, double top);

}  // namespace csgsim::plots

// Numbers and tables printed by studies.
// Used by sim/studies/explore and sim/studies/sensitivity.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace csgsim::studies {

/// Whole and large numbers with grouped digits, others with four digits.
std::string value_text(double value);

enum class Align : std::uint8_t { left, right };

/// Prints a table with a line per row and columns as wide as necessary. Aligned left, the last column is not padded.
void print_cells(const std::vector<std::vector<std::string>>& lines, Align align = Align::right);

}  // namespace csgsim::studies

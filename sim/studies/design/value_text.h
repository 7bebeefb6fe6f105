// Numbers and tables printed by studies.
// Used by sim/studies/explore and sim/studies/sensitivity.
#pragma once

#include <string>
#include <vector>

namespace csgsim::studies {

/// Whole and large numbers with grouped digits, others with four digits.
std::string value_text(double value);

/// Prints a table with a line per row, columns as wide as necessary, aligned right.
void print_cells(const std::vector<std::vector<std::string>>& lines);

}  // namespace csgsim::studies

// Formats tables as text in aligned columns.
// Used by sim/studies.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::session {

/// Formats rows in columns as wide as their widest cell, two blanks apart. `alignments` has one character per column:
/// `<` aligns left, `>` right. In a row with fewer cells, the last cell may extend beyond its column. Lines have no
/// trailing blanks.
std::string format_columns(std::span<const std::vector<std::string>> rows, std::string_view alignments);

}  // namespace csgsim::session

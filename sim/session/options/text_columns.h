#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::session {

/// Rows in columns as wide as their widest cell, with two blanks between them. `sides` has a sign for each column: `<`
/// where its cells stand at the left, `>` where they do at the right. Of a row with fewer cells the last runs on beyond
/// its column. No line ends in blanks.
std::string in_columns(std::span<const std::vector<std::string>> rows, std::string_view sides);

}  // namespace csgsim::session

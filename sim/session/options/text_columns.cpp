#include "sim/session/options/text_columns.h"

#include <algorithm>
#include <cstddef>

namespace csgsim::session {

namespace {

/// Number of characters: UTF-8 bytes other than continuation bytes.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

bool extends_beyond(const std::vector<std::string>& row, std::size_t column, std::size_t columns) {
  return row.size() < columns && column + 1 == row.size();
}

std::vector<std::size_t> widths_of(std::span<const std::vector<std::string>> rows, std::size_t columns) {
  std::vector<std::size_t> widths(columns);
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (!extends_beyond(row, i, columns)) widths[i] = std::max(widths[i], width_of(row[i]));
    }
  }
  return widths;
}

}  // namespace

std::string format_columns(std::span<const std::vector<std::string>> rows, std::string_view alignments) {
  const std::vector<std::size_t> widths = widths_of(rows, alignments.size());
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool is_free = extends_beyond(row, i, alignments.size());
      const std::string blanks(is_free ? 0 : widths[i] - width_of(row[i]), ' ');
      line += (i == 0 ? "" : "  ") + (alignments[i] == '>' ? blanks + row[i] : row[i] + blanks);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace csgsim::session

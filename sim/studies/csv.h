// CSV files of studies that are extended row by row.
// Used by the tables and shards of studies.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <vector>

#include "hw/base/error.h"

namespace csgsim::studies {

/// A CSV file that is extended row by row, so that an interrupted study can be resumed: a second start reads the
/// existing rows.
class CsvFile {
 public:
  /// Opens the file, or creates it with these header lines. Removes a partial last line left by an interrupted write.
  /// Throws InputError if the file begins differently, is too long, or cannot be read or written.
  CsvFile(std::filesystem::path path, std::string header);

  /// The lines below the header that the file had when it was opened.
  [[nodiscard]] const std::vector<std::string>& existing_lines() const { return found_; }

  /// Throws InputError with the place of the line existing_lines()[line_index], and the reason why it cannot be used.
  [[noreturn]] void reject_line(std::size_t line_index, std::string_view reason) const;

  /// Appends a line (or several separated by line breaks) and syncs the file. On failure it removes the partial line,
  /// if the file can be truncated, and throws InputError.
  void append(const std::string& line) const;

  /// Atomically replaces all lines below the header.
  void replace(const std::vector<std::string>& lines) const;

 private:
  std::filesystem::path path_;
  std::string begin_;
  std::vector<std::string> found_;
};

/// The table of a study: plain CSV with the column names in the first line. Its title, which identifies the study, is
/// the only line of a file with the same name and the extension .study. Tables written by csgsim 0.1.0 before December
/// 2026 start with the title as a comment; they are converted. Throws InputError as CsvFile does, and if the title
/// differs.
CsvFile open_study_table(const std::filesystem::path& path, const std::string& title, const std::string& header_line);

/// The cells of a line. Throws InputError if a quote is not closed or the text contains a line break.
std::vector<std::string> split_cells(std::string_view line);

/// The part of the line that holds the first `cell_count` cells.
std::string_view first_cells(std::string_view line, std::size_t cell_count);

/// Text as a cell, quoted if necessary. Throws InputError if the text contains a line break.
std::string to_cell(const std::string& text);

template <class Number>
requires std::is_arithmetic_v<Number> std::string to_cell(Number number) { return fmt::format("{}", number); }

/// An empty optional becomes an empty cell.
template <class Number>
std::string to_cell(const std::optional<Number>& number) {
  return number ? to_cell(*number) : std::string{};
}

inline void from_cell(const std::string& cell, std::string& text) { text = cell; }

/// Throws InputError if the cell is not a finite number.
template <class Number>
requires std::is_arithmetic_v<Number>
void from_cell(const std::string& cell, Number& number) {
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  bool is_number = error == std::errc{} && end == cell.data() + cell.size();
  if constexpr (std::is_floating_point_v<Number>) is_number = is_number && std::isfinite(number);
  if (!is_number)
    throw InputError("'" + cell +
                     (std::is_integral_v<Number> ? "' is not a whole number" : "' is not a finite number"));
}

template <class Number>
void from_cell(const std::string& cell, std::optional<Number>& number) {
  number.reset();
  if (!cell.empty()) from_cell(cell, number.emplace());
}

}  // namespace csgsim::studies

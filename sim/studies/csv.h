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

/// A file of CSV that grows by a line at a time, so that an interrupted study can go on: a second start reads what is
/// there.
class CsvFile {
 public:
  /// Opens the file, or begins it with these lines; part of a line, which an interrupted write has left, is cut off.
  /// Throws InputError if the file begins otherwise, is too long or cannot be read or written.
  CsvFile(std::filesystem::path path, std::string begin);

  /// The lines that were there when it was opened, below those that it begins with.
  [[nodiscard]] const std::vector<std::string>& found() const { return found_; }

  /// Throws InputError that says which of the lines found cannot be used, and why.
  [[noreturn]] void refuse(std::size_t found, std::string_view why) const;

  /// Adds a line, or several with line breaks between them, and has it on the disk. Throws InputError if it cannot: no
  /// part of it is left then, unless the file cannot even be shortened.
  void append(const std::string& line) const;

  /// Puts other lines in place of all below those that it begins with, at once: nobody sees part of them.
  void replace(const std::vector<std::string>& lines) const;

 private:
  std::filesystem::path path_;
  std::string begin_;
  std::vector<std::string> found_;
};

/// The table of a study: plain CSV, whose first line names the columns. Its title, which says what study it is, is a
/// line in a file beside it that ends in .study; tables of csgsim 0.1.0 from before December 2026 have it as a comment
/// above all, and are made plain. Throws InputError as CsvFile does, and where the title is another.
CsvFile study_table(const std::filesystem::path& path, const std::string& title, const std::string& header);

/// The cells of a line. Throws InputError where a quote is left open, or where it is not one line.
std::vector<std::string> split_cells(std::string_view line);

/// The line up to the end of its first cells, so many of them.
std::string_view first_cells(std::string_view line, std::size_t cells);

/// Text as a cell: in quotes where it has to be. Throws InputError for text of several lines.
std::string to_cell(const std::string& text);

template <class Number>
requires std::is_arithmetic_v<Number> std::string to_cell(Number number) { return fmt::format("{}", number); }

/// Nothing as an empty cell.
template <class Number>
std::string to_cell(const std::optional<Number>& number) {
  return number ? to_cell(*number) : std::string{};
}

inline void from_cell(const std::string& cell, std::string& text) { text = cell; }

/// Throws InputError; also for what is not finite, which nobody measures.
template <class Number>
requires std::is_arithmetic_v<Number>
void from_cell(const std::string& cell, Number& number) {
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
  bool is_number = error == std::errc{} && end == cell.data() + cell.size();
  if constexpr (std::is_floating_point_v<Number>) is_number = is_number && std::isfinite(number);
  if (!is_number) throw InputError("'" + cell + "' is no number");
}

template <class Number>
void from_cell(const std::string& cell, std::optional<Number>& number) {
  number.reset();
  if (!cell.empty()) from_cell(cell, number.emplace());
}

}  // namespace csgsim::studies

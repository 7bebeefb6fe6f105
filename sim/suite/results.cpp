#include "sim/suite/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

#include "hw/base/error.h"
#include "hw/base/nearest.h"
#include "hw/isa/opcodes.h"

namespace csgsim::suite {

namespace {

constexpr std::size_t name_column = 0;
constexpr std::size_t machine_column = 1;
constexpr std::size_t hash_digits = 16;

struct FixedColumn {
  std::string_view name;
  Cell cell;
  Scope scope;
};

constexpr auto fixed_columns = std::to_array<FixedColumn>({
    {"case", Cell::text, Scope::run},
    {"machine", Cell::text, Scope::run},
    {"simulator", Cell::text, Scope::run},
    {"level", Cell::text, Scope::run},
    {"host", Cell::text, Scope::run},
    {"seconds", Cell::seconds, Scope::run},
    {"picture", Cell::hash, Scope::picture},
    {"program", Cell::hash, Scope::program},
    {"memory_bits", Cell::number, Scope::program},
    {"clocks", Cell::number, Scope::machine},
    {"shown_clocks", Cell::number, Scope::machine},
    {"interval_clocks", Cell::number, Scope::machine},
    {"pixel_operations", Cell::number, Scope::machine},
    {"enabled_operations", Cell::number, Scope::machine},
    {"instructions", Cell::number, Scope::program},
    {"skipped", Cell::number, Scope::program},
});

std::vector<Column> make_columns() {
  std::vector<Column> all;
  all.reserve(fixed_columns.size() + isa::opcode_table.size());
  for (const FixedColumn& one : fixed_columns) all.push_back({std::string(one.name), one.cell, one.scope});
  for (const isa::OpcodeInfo& row : isa::opcode_table)
    all.push_back({std::string(row.name), Cell::number, Scope::program});
  return all;
}

/// The number that all of the text stands for; nothing if it is none or does not fit.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return number;
}

bool is_duration(std::string_view text) {
  const auto number = number_in<double>(text);
  return number && std::isfinite(*number) && *number >= 0;
}

bool is_hash(std::string_view text) {
  return text.size() == hash_digits &&
         std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

/// What is wrong with a cell that is not empty; empty if nothing.
std::string_view problem_of(std::string_view text, Cell cell) {
  switch (cell) {
    case Cell::text: return "";
    case Cell::seconds: return is_duration(text) ? "" : "not a number of seconds; write one such as 1.5";
    case Cell::number: return number_in<std::uint64_t>(text) ? "" : "not a whole number below 2^64; write digits only";
    case Cell::hash: return is_hash(text) ? "" : "not a hash; write 16 hexadecimal digits in lower case";
  }
  return "";
}

struct Piece {
  std::string text;
  std::size_t column = 1;  ///< of its first character, counted from 1
};

class TableReader {
 public:
  TableReader(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  std::vector<Row> read() {
    std::vector<Row> rows;
    while (!text_.empty()) {
      const std::string_view line = next_line();
      if (line.empty() || line.front() == '#') continue;
      const std::vector<Piece> pieces = split(line);
      if (order_.empty())
        read_header(pieces);
      else
        rows.push_back(read_row(pieces, rows));
    }
    if (order_.empty())
      throw InputError(fmt::format("{}:1:1: the table has no line of column names; begin it with case,machine", file_));
    return rows;
  }

 private:
  [[noreturn]] void fail(std::size_t column, std::string_view message) const {
    throw InputError(fmt::format("{}:{}:{}: {}", file_, line_, column, message));
  }

  std::string_view next_line() {
    const std::size_t end = std::min(text_.find('\n'), text_.size());
    std::string_view line = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++line_;
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }

  [[nodiscard]] std::vector<Piece> split(std::string_view line) const {
    std::vector<Piece> pieces(1);
    std::size_t quote = 0;  // column of the open quote
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool is_doubled = quote != 0 && line.substr(i).starts_with("\"\"");
      if (is_doubled) {
        pieces.back().text += line[++i];
      } else if (line[i] == '"') {
        quote = quote == 0 ? i + 1 : 0;
      } else if (line[i] == ',' && quote == 0) {
        pieces.push_back({"", i + 2});
      } else {
        pieces.back().text += line[i];
      }
    }
    if (quote != 0) fail(quote, "the quote is not closed; close it in the same line");
    return pieces;
  }

  void read_header(const std::vector<Piece>& pieces) {
    std::vector<std::string> known;
    for (const Column& column : columns()) known.push_back(column.name);
    for (const Piece& piece : pieces) {
      const auto found = std::ranges::find(known, piece.text);
      if (found == known.end()) fail(piece.column, unknown_name_text("column", piece.text, known));
      const auto position = static_cast<std::size_t>(found - known.begin());
      if (std::ranges::find(order_, position) != order_.end())
        fail(piece.column, fmt::format("the column '{}' occurs twice; remove one", piece.text));
      order_.push_back(position);
    }
    for (const std::size_t needed : {name_column, machine_column})
      if (std::ranges::find(order_, needed) == order_.end())
        fail(1, fmt::format("the column '{}' is missing; add it", known[needed]));
  }

  [[nodiscard]] Row read_row(const std::vector<Piece>& pieces, std::span<const Row> earlier) const {
    if (pieces.size() != order_.size())
      fail(1, fmt::format("the line has {} cells and the table {} columns; write one cell per column", pieces.size(),
                          order_.size()));
    Row row;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const Column& column = columns()[order_[i]];
      const Piece& piece = pieces[i];
      if (piece.text.empty()) {
        if (order_[i] <= machine_column) fail(piece.column, fmt::format("'{}' is empty; name one", column.name));
        continue;
      }
      if (const std::string_view problem = problem_of(piece.text, column.cell); !problem.empty())
        fail(piece.column, fmt::format("{}: '{}' is {}", column.name, piece.text, problem));
      // Leading zeros are dropped, so that equal numbers are equal texts.
      row.cells[order_[i]] =
          column.cell == Cell::number ? std::to_string(*number_in<std::uint64_t>(piece.text)) : piece.text;
    }
    if (find_row(earlier, row.name(), row.machine()) != nullptr)
      fail(1, fmt::format("there is a second line of {} on {}; remove one", row.name(), row.machine()));
    return row;
  }

  std::string_view text_;
  std::string_view file_;
  std::size_t line_ = 0;
  std::vector<std::size_t> order_;  ///< positions in columns() of the table's columns
};

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"#\r") == std::string::npos) return text;
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? std::string("\"\"") : std::string(1, c);
  return cell + "\"";
}

}  // namespace

std::span<const Column> columns() {
  static const std::vector<Column> all = make_columns();
  return all;
}

std::size_t column_named(std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(columns(), name, &Column::name) - columns().begin());
}

std::vector<Row> read_results(std::string_view text, std::string_view file) { return TableReader(text, file).read(); }

std::string results_text(std::span<const Row> rows) {
  std::vector<std::size_t> written;
  for (std::size_t i = 0; i < columns().size(); ++i) {
    const bool is_filled = std::ranges::any_of(rows, [&](const Row& row) { return !row.cells[i].empty(); });
    if (i <= machine_column || is_filled) written.push_back(i);
  }
  std::string text;
  const auto add_line = [&](auto cell) {
    for (const std::size_t i : written) text += (i == written.front() ? "" : ",") + quoted(cell(i));
    text += "\n";
  };
  add_line([](std::size_t i) { return columns()[i].name; });
  for (const Row& row : rows) add_line([&](std::size_t i) { return row.cells[i]; });
  return text;
}

const Row* find_row(std::span<const Row> rows, std::string_view name, std::string_view machine) {
  const auto found =
      std::ranges::find_if(rows, [&](const Row& row) { return row.name() == name && row.machine() == machine; });
  return found == rows.end() ? nullptr : &*found;
}

}  // namespace csgsim::suite

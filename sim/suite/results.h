// Results of the benchmark suite as CSV, those of csgsim and of other simulators.
// Used by sim/suite.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::suite {

/// The values that a column accepts.
enum class Cell : std::uint8_t {
  text,
  seconds,  ///< a decimal number
  number,   ///< a whole number below 2^64
  hash,     ///< 16 hexadecimal digits in lower case: 64-bit FNV-1a (hw/base/hash.h)
};

/// What a value depends on, and so with which values it is compared.
enum class Scope : std::uint8_t {
  run,      ///< describes the run; never compared
  picture,  ///< the same on every machine
  program,  ///< the same on every machine that runs the same Program
  machine,
};

struct Column {
  std::string name;
  Cell cell = Cell::text;
  Scope scope = Scope::run;
};

/// All columns, in the order in which they are written: `case`, `machine`, those of the run, the picture, the Program
/// and the machine, and one per instruction for how often it was executed.
std::span<const Column> columns();

/// Position of the column with that name, which must exist.
std::size_t column_named(std::string_view name);

/// The results of one case on one machine: a cell per column; empty if it is not given.
struct Row {
  std::vector<std::string> cells = std::vector<std::string>(columns().size());

  [[nodiscard]] const std::string& at(std::string_view column) const { return cells[column_named(column)]; }
  std::string& at(std::string_view column) { return cells[column_named(column)]; }
  [[nodiscard]] const std::string& name() const { return at("case"); }
  [[nodiscard]] const std::string& machine() const { return at("machine"); }

  bool operator==(const Row&) const = default;
};

/// Reads a table; `file` is its name in messages. The first line that is not empty and does not begin with # names the
/// columns, in any order; `case` and `machine` must be among them. Cells may be quoted, and may be empty except for
/// these two. Throws InputError of the form `file:line:column: what is wrong; what to do`.
std::vector<Row> read_results(std::string_view text, std::string_view file);

/// The table with all columns that any row fills.
std::string results_text(std::span<const Row> rows);

/// The row of that case and machine; null if there is none.
const Row* find_row(std::span<const Row> rows, std::string_view name, std::string_view machine);

}  // namespace csgsim::suite

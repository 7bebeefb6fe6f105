// Grids of designs and samples of them.
// Used by explore and advise.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/session/model/model_request.h"
#include "sim/studies/design/row.h"

namespace csgsim::studies {

/// Maximum number of designs of one command.
inline constexpr std::uint32_t max_designs = 10'000;

/// A machine parameter, or an option of render, with several values.
struct Dimension {
  std::string key;
  std::vector<std::string> values;

  bool operator==(const Dimension&) const = default;
};

/// Parses KEY=a,b,c, where a value may be a range of numbers such as 3..8. Throws InputError for another form,
/// a reversed range, or too many values.
Dimension parse_dimension(const std::string& text);

/// Whether the parameter sets the memory bits per pixel.
bool is_memory_figure(std::string_view key);

/// Selects the cells of a grid that become designs.
struct GridChoice {
  std::uint32_t points = 0;  ///< size of the sample; 0 for all cells
  std::uint32_t seed = 1;    ///< seed of the sample
};

/// Enumerates the cells of a grid, each once, evenly from the beginning: an additive recurrence with multiples of a
/// different irrational number for each axis (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences"),
/// from a starting point given by the seed. It is the same on every computer, and a longer sample extends the shorter
/// one.
class GridSequence {
 public:
  /// `sizes`: number of values of each axis, none 0. Their product must be below 2^63.
  GridSequence(std::vector<std::size_t> sizes, std::uint64_t seed);

  /// The value indices of the next cell, one per axis; empty after the last cell.
  std::optional<std::vector<std::size_t>> next();

 private:
  [[nodiscard]] std::uint64_t draw_cell();  ///< number of a cell in grid order, possibly one drawn before

  std::vector<std::size_t> sizes_;
  std::vector<std::uint64_t> steps_;   ///< step of each axis, in units of 2^-64
  std::vector<std::uint64_t> places_;  ///< position on each axis, in units of 2^-64
  std::uint64_t cells_ = 1;
  std::uint64_t first_untried_ = 0;  ///< in grid order; used once drawing rarely finds new cells
  std::set<std::uint64_t> visited_;
};

/// The cell with that number in grid order, where the last axis varies fastest.
std::vector<std::size_t> grid_cell(const std::vector<std::size_t>& sizes, std::uint64_t number);

/// The requested designs: combinations of values, applied to `base`. Combinations that draw the same picture, such as
/// different stack bits with a strategy without a stack, are one design.
class DesignGrid {
 public:
  /// All combinations of values that were already checked, in order. Strategies without a stack get the minimum number
  /// of stack bits.
  DesignGrid(session::ModelRequest base, std::vector<Dimension> dimensions);

  /// All combinations, or a sample. Throws UsageError if the grid has more than max_designs cells and no sample is
  /// requested, and for a value that is invalid in every combination.
  DesignGrid(session::ModelRequest base, std::vector<Dimension> dimensions, const GridChoice& choice);

  /// The designs in the order in which they were added.
  [[nodiscard]] const std::vector<session::ModelRequest>& designs() const { return designs_; }

  /// Adds at most `max_count` designs that differ from one of these (given by index) in one dimension, by the previous
  /// or next value in its list.
  void add_neighbours(std::span<const std::size_t> designs, std::size_t max_count);

 private:
  using Cell = std::vector<std::size_t>;  ///< index into the values of each dimension

  void add_all();
  void add_sample(const GridChoice& choice);
  void add(Cell cell);

  session::ModelRequest base_;
  std::vector<Dimension> dimensions_;
  std::vector<std::size_t> sizes_;
  std::vector<session::ModelRequest> designs_;
  std::vector<Cell> cells_;                              ///< one per design
  std::set<std::pair<std::string, DesignPoint>> known_;  ///< size and point, which identify a design
};

}  // namespace csgsim::studies

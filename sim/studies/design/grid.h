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

/// Designs that one command may ask for.
inline constexpr std::uint32_t most_designs = 10'000;

/// A figure of the machine, or an option of render, that takes several values.
struct Dimension {
  std::string key;
  std::vector<std::string> values;

  bool operator==(const Dimension&) const = default;
};

/// Reads KEY=a,b,c, where a value may be a range of numbers, 3..8. Throws InputError.
Dimension dimension_in(const std::string& text);

/// Whether the figure says how many memory bits a pixel of its machine has.
bool is_memory_figure(std::string_view key);

/// Which cells of a grid are designs.
struct GridChoice {
  std::uint32_t points = 0;  ///< so many of a sample; 0 for all
  std::uint32_t seed = 1;    ///< of the sample
};

/// Cells of a grid, each once, in an order that begins all over the grid: an additive recurrence, the multiples
/// of a different irrational number for each axis (Roberts 2018, "The unreasonable effectiveness of quasirandom
/// sequences"), from a place that the seed determines. It is the same on every machine, and a longer sample begins with
/// the shorter one.
class GridSequence {
 public:
  /// `sizes`: how many values each axis has, none of them 0. Their product has to be below 2^63.
  GridSequence(std::vector<std::size_t> sizes, std::uint64_t seed);

  /// The values of the next cell, one an axis; nothing when every cell has been told.
  std::optional<std::vector<std::size_t>> next();

 private:
  [[nodiscard]] std::uint64_t drawn_cell();

  std::vector<std::size_t> sizes_;
  std::vector<std::uint64_t> steps_;   ///< of each axis, in parts of 2^64
  std::vector<std::uint64_t> places_;  ///< where each axis is, in parts of 2^64
  std::uint64_t cells_ = 1;
  std::uint64_t first_untried_ = 0;  ///< in the order of the grid, once drawing finds few new ones
  std::set<std::uint64_t> told_;
};

/// The cell of that number in the order of the grid, whose last axis varies fastest.
std::vector<std::size_t> grid_cell(const std::vector<std::size_t>& sizes, std::uint64_t number);

/// Designs that are asked for: combinations of the values, each put into `base`. Combinations that draw alike, as those
/// of stack bits with a strategy that has none, are one.
class DesignGrid {
 public:
  /// Every combination of values that were checked, in their order. Strategies without a stack have the fewest stack
  /// bits.
  DesignGrid(session::ModelRequest base, std::vector<Dimension> dimensions);

  /// Every combination, or a sample of them. Throws UsageError for a grid of more than most_designs cells where no
  /// sample is asked for, and for a value that is wrong whatever the others are.
  DesignGrid(session::ModelRequest base, std::vector<Dimension> dimensions, const GridChoice& choice);

  /// In the order in which they were asked for.
  [[nodiscard]] const std::vector<session::ModelRequest>& designs() const { return designs_; }

  /// Asks for those besides that differ from one of these, by their numbers, in one key, by the value before or behind
  /// in its list; for so many at most.
  void add_neighbours(std::span<const std::size_t> designs, std::size_t most);

 private:
  using Cell = std::vector<std::size_t>;  ///< a place in the list of each dimension

  void add_all();
  void add_sample(const GridChoice& choice);
  void add(Cell cell);

  session::ModelRequest base_;
  std::vector<Dimension> dimensions_;
  std::vector<std::size_t> sizes_;
  std::vector<session::ModelRequest> designs_;
  std::vector<Cell> cells_;                              ///< of the designs
  std::set<std::pair<std::string, DesignPoint>> known_;  ///< size and point: what tells them apart
};

}  // namespace csgsim::studies

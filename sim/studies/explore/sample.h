#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

namespace csgsim::studies {

/// Cells of a grid, each once, in an order that begins all over the grid: an additive recurrence, for each axis the
/// multiples of an irrational number of its own (Roberts 2018, "The unreasonable effectiveness of quasirandom
/// sequences"), from a place that the seed says. It is the same on every machine, and a longer sample begins with the
/// shorter one.
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

}  // namespace csgsim::studies

#include "sim/studies/explore/sample.h"

#include <cmath>
#include <utility>

namespace csgsim::studies {

namespace {

/// Cells that were told already, one after the other, before the rest of the grid is gone through in its order.
constexpr unsigned most_repeats = 64;

/// The root above 1 of x^(axes + 1) = x + 1.
double root_of(std::size_t axes) {
  double x = 2;
  for (int i = 0; i < 64; ++i) x = std::pow(1 + x, 1.0 / static_cast<double>(axes + 1));
  return x;
}

/// A bit mixer: the finaliser of SplitMix64 (Steele, Lea and Flood 2014).
std::uint64_t mixed(std::uint64_t number) {
  number += 0x9e3779b97f4a7c15U;
  number = (number ^ number >> 30U) * 0xbf58476d1ce4e5b9U;
  number = (number ^ number >> 27U) * 0x94d049bb133111ebU;
  return number ^ number >> 31U;
}

/// Of so many, that at this part of 2^64. As many as fit into 32 bits.
std::size_t value_at(std::uint64_t place, std::size_t values) {
  return static_cast<std::size_t>((place >> 32U) * std::uint64_t{values} >> 32U);
}

}  // namespace

std::vector<std::size_t> grid_cell(const std::vector<std::size_t>& sizes, std::uint64_t number) {
  std::vector<std::size_t> values(sizes.size());
  for (std::size_t axis = sizes.size(); axis-- > 0;) {
    values[axis] = static_cast<std::size_t>(number % sizes[axis]);
    number /= sizes[axis];
  }
  return values;
}

GridSequence::GridSequence(std::vector<std::size_t> sizes, std::uint64_t seed) : sizes_(std::move(sizes)) {
  const double root = root_of(sizes_.size());
  double part = 1;
  for (std::size_t axis = 0; axis < sizes_.size(); ++axis) {
    part /= root;
    // The last bits of a power differ from library to library; half of them are enough here.
    steps_.push_back(static_cast<std::uint64_t>(std::llround(std::ldexp(part, 32))) << 32U);
    places_.push_back(mixed(mixed(seed) + axis));
    cells_ *= sizes_[axis];
  }
}

std::uint64_t GridSequence::drawn_cell() {
  std::uint64_t cell = 0;
  for (std::size_t axis = 0; axis < sizes_.size(); ++axis) {
    places_[axis] += steps_[axis];
    cell = cell * sizes_[axis] + value_at(places_[axis], sizes_[axis]);
  }
  return cell;
}

std::optional<std::vector<std::size_t>> GridSequence::next() {
  if (told_.size() == cells_) return std::nullopt;
  for (unsigned i = 0; first_untried_ == 0 && i < most_repeats; ++i) {
    const std::uint64_t cell = drawn_cell();
    if (told_.insert(cell).second) return grid_cell(sizes_, cell);
  }
  while (!told_.insert(first_untried_).second) ++first_untried_;
  return grid_cell(sizes_, first_untried_++);
}

}  // namespace csgsim::studies

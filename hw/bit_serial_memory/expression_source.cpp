#include "hw/bit_serial_memory/expression_source.h"

#include <algorithm>

namespace csgsim::bit_serial_memory {

void ExpressionSource::begin(const isa::Linear& linear, const isa::Linear& squares) {
  linear_ = linear;
  squares_ = squares;
  for (std::vector<std::uint64_t>& values : values_) values.clear();
}

void ExpressionSource::compute_values(std::uint64_t slot) {
  const auto number = [](std::int64_t of) { return static_cast<std::uint64_t>(of); };
  std::vector<std::uint64_t>& values = values_[slot];
  values.reserve(slots_.columns(slot));
  for (std::uint64_t column = 0; column < slots_.columns(slot); ++column) {
    const std::uint64_t pixel = slot * slots_.row_columns + column;
    const std::uint64_t x = pixel % width_;
    const std::uint64_t y = pixel / width_;
    values.push_back(number(linear_.a) * x + number(linear_.b) * y + number(linear_.c) + number(squares_.a) * x * x +
                     number(squares_.b) * x * y + number(squares_.c) * y * y);
  }
}

void ExpressionSource::bits(std::uint64_t slot, unsigned bit, std::span<std::uint64_t> words) {
  if (values_[slot].empty()) compute_values(slot);
  std::ranges::fill(words, 0);
  for (std::size_t column = 0; column < values_[slot].size(); ++column)
    words[column / 64] |= (values_[slot][column] >> bit & 1U) << column % 64;
}

}  // namespace csgsim::bit_serial_memory

#pragma once

#include <array>
#include <cstdint>

#include "hw/bit_serial_memory/row_command.h"

namespace csgsim::bit_serial_memory {

/// Number of bits of an index less than `count`.
constexpr unsigned count_bits(std::uint32_t count) {
  unsigned bits = 0;
  while (count > (std::uint32_t{1} << bits)) ++bits;
  return bits;
}

/// Layout of a subarray's rows: pixel memory comes first, one bit per row; rows used by instructions follow.
struct RowMap {
  static constexpr unsigned sum_rows = 62;    ///< maximum number of bits of an expression
  static constexpr unsigned spare_rows = 40;  ///< more than a root needs

  std::uint32_t memory_bits = 0;
  unsigned x_bits = 0;  ///< number of rows that hold the columns' x
  unsigned y_bits = 0;  ///< number of rows that hold the columns' y

  RowMap() = default;
  RowMap(std::uint32_t pixel_memory_bits, std::uint32_t width, std::uint32_t height)
      : memory_bits(pixel_memory_bits), x_bits(count_bits(width)), y_bits(count_bits(height)) {}

  [[nodiscard]] constexpr Row zero() const { return at(0); }
  [[nodiscard]] constexpr Row one() const { return at(1); }
  [[nodiscard]] constexpr Row enable() const { return at(2); }
  [[nodiscard]] constexpr Row select() const { return at(3); }
  [[nodiscard]] constexpr Row carry() const { return at(4); }
  /// Rows for intermediate results within an operation.
  [[nodiscard]] constexpr Row scratch(unsigned i) const { return at(5 + i); }
  static constexpr unsigned scratch_rows = 4;
  /// T0 to T3 of Ambit, which can be activated three at a time.
  [[nodiscard]] constexpr Row t(unsigned i) const { return at(9 + i); }
  /// The two rows of Ambit that also have a negated word line.
  [[nodiscard]] constexpr Row dual(unsigned i) const { return at(13 + i); }
  [[nodiscard]] constexpr Row sum(unsigned bit) const { return at(15 + bit); }
  [[nodiscard]] constexpr Row spare(unsigned i) const { return at(15 + sum_rows + i); }
  [[nodiscard]] constexpr Row x(unsigned bit) const { return at(15 + sum_rows + spare_rows + bit); }
  [[nodiscard]] constexpr Row y(unsigned bit) const { return static_cast<Row>(x(x_bits) + bit); }
  [[nodiscard]] constexpr unsigned rows() const { return y(y_bits); }

  constexpr bool operator==(const RowMap&) const = default;

 private:
  [[nodiscard]] constexpr Row at(unsigned place) const { return static_cast<Row>(memory_bits + place); }
};

}  // namespace csgsim::bit_serial_memory

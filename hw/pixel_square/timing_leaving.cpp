#include "hw/pixel_square/timing_leaving.h"

#include <algorithm>

#include "hw/base/quotient.h"

namespace csgsim::pixel_square {

std::uint64_t header_words(std::uint64_t port_bits) {
  constexpr std::uint64_t bits = 64;
  return quotient_up(bits, port_bits);
}

LeavingSquare::LeavingSquare(const isa::Region& region, std::uint32_t colour_bits, std::uint64_t port_bits)
    : top_(region.y),
      port_bits_(port_bits),
      row_bits_(std::uint64_t{region.width} * colour_bits),
      bits_(row_bits_ * region.height),
      header_words_(header_words(port_bits)),
      words_(header_words_ + quotient_up(bits_, port_bits)) {}

std::optional<LeavingSquare::Rows> LeavingSquare::rows() const {
  if (word_ < header_words_) return std::nullopt;
  const std::uint64_t first = (word_ - header_words_) * port_bits_;
  const std::uint64_t last = std::min(first + port_bits_, bits_) - 1;
  return Rows{static_cast<std::uint32_t>(first / row_bits_), static_cast<std::uint32_t>(last / row_bits_)};
}

std::optional<std::uint32_t> LeavingSquare::picture_row() const {
  const std::optional<Rows> of_word = rows();
  return of_word ? std::optional(top_ + of_word->first) : std::nullopt;
}

Time RowLatch::there(std::uint32_t row) {
  for (; rows_ <= row; ++rows_) {
    over_ = std::max(latched_, wanted_);
    latched_ = over_ + clocks_;
  }
  return over_;
}

}  // namespace csgsim::pixel_square

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
      header_words_(header_words(port_bits)),
      words_(header_words_ + quotient_up(row_bits_ * region.height, port_bits)),
      bits_(row_bits_ * region.height) {}

std::optional<LeavingSquare::Rows> LeavingSquare::rows() const {
  if (header_words_ > 0) return std::nullopt;
  const std::uint64_t last = at_ + std::min(port_bits_, bits_) - 1;
  return Rows{row_, last < row_bits_ ? row_ : row_ + static_cast<std::uint32_t>(last / row_bits_)};
}

std::optional<std::uint32_t> LeavingSquare::picture_row() const {
  return header_words_ > 0 ? std::nullopt : std::optional(top_ + row_);
}

void LeavingSquare::advance() {
  --words_;
  if (header_words_ > 0) {
    --header_words_;
    return;
  }
  bits_ -= std::min(port_bits_, bits_);
  at_ += port_bits_;
  for (; at_ >= row_bits_; at_ -= row_bits_) ++row_;
}

void LeavingSquare::skip_header() {
  words_ -= header_words_;
  header_words_ = 0;
}

Time RowLatch::transfer_edge(std::uint32_t row) {
  for (; rows_ <= row; ++rows_) {
    transferred_ = std::max(latched_, needed_);
    latched_ = transferred_ + clocks_;
  }
  return transferred_;
}

}  // namespace csgsim::pixel_square

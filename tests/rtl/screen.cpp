#include "tests/rtl/screen.h"

namespace csgsim::rtl {

void Screen::show(const Outputs& outputs) {
  if (!outputs.video_valid) return;
  if (outputs.video_frame) picture_.clear();
  if (outputs.video_row) column_ = 0;
  for (std::uint32_t i = 0; i < pixels_ && column_ < width_; ++i, ++column_) {
    std::uint32_t colour = 0;
    for (std::uint32_t bit = 0; bit < colour_bits_; ++bit) {
      const std::uint32_t wire = i * colour_bits_ + bit;
      colour |= static_cast<std::uint32_t>(outputs.video[wire / 64] >> wire % 64 & 1U) << bit;
    }
    picture_.push_back(colour);
  }
}

}  // namespace csgsim::rtl

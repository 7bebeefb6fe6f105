#include "hw/pixel_square/screen.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw/base/error.h"
#include "hw/base/quotient.h"

namespace csgsim::pixel_square {

Screen::Screen(const Figures& figures, std::uint64_t clock_hz)
    : rate_(figures.pictures >= 2 ? 0 : figures.refresh_rate),
      clock_hz_(clock_hz),
      bits_(figures.refresh_bits),
      clocks_(figures.refresh_clocks) {}

void Screen::begin(const machines::Size& picture, std::uint32_t colour_bits) {
  row_bits_ = std::uint64_t{picture.width} * colour_bits;
  picture_bits_ = row_bits_ * picture.height;
  step_ = rate_ * quotient_up(picture_bits_, bits_);
  phase_ = 0;
  next_ = 0;
  left_ = 0;
}

void Screen::advance(std::uint64_t clocks) {
  left_ -= static_cast<std::uint32_t>(std::min<std::uint64_t>(left_, clocks));
  phase_ += clocks * step_;
  if (phase_ < clock_hz_) return;
  phase_ -= clock_hz_;
  left_ = clocks_;
  at_ = next_;
  next_ += bits_;
  if (next_ >= picture_bits_) next_ = 0;
}

std::uint64_t Screen::clocks_to_change() const {
  const std::uint64_t to_turn = quotient_up(clock_hz_ - phase_, step_);
  return left_ == 0 ? to_turn : std::min<std::uint64_t>(left_, to_turn);
}

std::optional<std::uint32_t> Screen::row() const {
  if (left_ == 0) return std::nullopt;
  return static_cast<std::uint32_t>(at_ / row_bits_);
}

std::uint64_t turns_per_picture(const machines::Size& picture, std::uint32_t colour_bits, const Figures& figures) {
  if (figures.refresh_rate == not_shown || figures.pictures >= 2) return 0;
  return quotient_up(std::uint64_t{picture.width} * picture.height * colour_bits, figures.refresh_bits);
}

void check_screen(const isa::FrameHeader& header, const machines::Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  const std::uint64_t turns =
      figures.refresh_rate * turns_per_picture({header.shape.width, header.shape.height}, header.colour.width, figures);
  if (turns == 0 || turns <= (machine.clock_hz - 1) / figures.refresh_clocks) return;
  throw InputError(fmt::format(
      "the screen takes {} turns per second of {} clocks each, but the frame buffer has {} clocks per second, "
      "which leaves none for drawing; increase refresh.bits, or set frame_buffer.pictures to 2",
      turns, figures.refresh_clocks, machine.clock_hz));
}

}  // namespace csgsim::pixel_square

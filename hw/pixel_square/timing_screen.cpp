#include "hw/pixel_square/timing_screen.h"

#include <algorithm>

#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/screen.h"

namespace csgsim::pixel_square {

namespace {

/// Wide enough for products of two rates.
__extension__ using Wide = unsigned __int128;

}  // namespace

ScreenTiming::ScreenTiming(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  const isa::FrameHeader header = isa::frame_header(program);
  turns_per_picture_ = turns_per_picture({header.shape.width, header.shape.height}, header.colour.width, figures);
  turns_per_second_ = turns_per_picture_ * figures.refresh_rate;
  clock_hz_ = machine.clock_hz;
  turn_clocks_ = figures.refresh_clocks;
  turn_bits_ = figures.refresh_bits;
  row_bits_ = std::uint64_t{header.shape.width} * header.colour.width;
  banks_ = figures.banks;
}

/// Number of turns that have begun up to edge `now`.
std::uint64_t ScreenTiming::turns_until(Time now) const {
  return static_cast<std::uint64_t>(Wide{now} * turns_per_second_ / clock_hz_);
}

Time ScreenTiming::turn_start(std::uint64_t turn) const {
  return static_cast<Time>((Wide{turn} * clock_hz_ + turns_per_second_ - 1) / turns_per_second_);
}

void ScreenTiming::advance_to_turn(std::uint64_t turn) {
  next_ = turn_start(turn + 1);
  if (turn == 0) return;
  end_ = turn_start(turn) + turn_clocks_;
  const std::uint64_t row = (turn - 1) % turns_per_picture_ * turn_bits_ / row_bits_;
  bank_ = static_cast<std::uint32_t>(row % banks_);
}

std::optional<std::uint32_t> ScreenTiming::occupied_bank(Time now) {
  if (turns_per_second_ == 0) return std::nullopt;
  if (now >= next_) advance_to_turn(turns_until(now));
  return now < end_ ? std::optional(bank_) : std::nullopt;
}

std::uint64_t ScreenTiming::clocks_until(Time last_edge) const {
  if (turns_per_second_ == 0) return 0;
  const std::uint64_t turns = turns_until(last_edge);
  if (turns == 0) return 0;
  return (turns - 1) * turn_clocks_ + std::min(turn_clocks_, last_edge - turn_start(turns) + 1);
}

}  // namespace csgsim::pixel_square

#include "hw/pixel_planes/scan_out.h"

#include <algorithm>
#include <utility>

#include "hw/array/add_plane.h"
#include "hw/base/quotient.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_planes {

ScanOut::ScanOut(sc_core::sc_module_name name, const sc_core::sc_time& period, array::PlaneShape shape,
                 std::uint32_t pixels_per_clock, ScanOutPort port)
    : sc_core::sc_module(name),
      period_(period),
      shape_(shape),
      pixels_(pixels_per_clock),
      port_(port),
      latch_row_(shape.width),
      shift_row_(shape.width),
      shifted_(shape.width) {
  SC_HAS_PROCESS(ScanOut);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << pictures.data_written();
}

void ScanOut::on_clock() {
  if (state_ == State::asleep) return wake();
  if (state_ == State::awake && !begin()) {
    state_ = State::asleep;
    return;
  }
  act();
  const bool finished = row_ == shape_.height && latched_ == 0 && shifted_ == shape_.width;
  if (finished) frames.write(++frames_done_);
  state_ = finished ? State::awake : State::showing;
  sleep();
}

/// Performs the shifts of the clocks slept through, then acts for the current clock.
void ScanOut::act() {
  const std::uint64_t now = systemc::edges(period_);
  shift(now - std::exchange(acted_at_, now) - 1);
  transfer();
  shift(1);
  latch();
}

/// Sleeps while a latched row waits for the previous row, until the last clock in which the latter is shifted out.
void ScanOut::sleep() {
  const std::uint32_t clocks = quotient_up(shape_.width - shifted_, pixels_);
  if (latches() || clocks < 2) return next_trigger(clock.posedge_event());
  next_trigger(sc_core::sc_time::from_value(clocks * period_.value()));
}

std::uint32_t ScanOut::video() const {
  const std::uint64_t shifted = shifted_ + (systemc::edges(period_) - acted_at_) * pixels_;
  return shifted == shifted_ || shifted_ == shape_.width
             ? video_
             : shift_row_[static_cast<std::size_t>(std::min<std::uint64_t>(shifted, shape_.width)) - 1];
}

/// Called when a picture arrives between two edges.
void ScanOut::wake() {
  state_ = State::awake;
  next_trigger(clock.posedge_event());
}

/// Begins the next picture. Returns false if there is none.
bool ScanOut::begin() {
  FinishedPicture next;
  if (!pictures.nb_read(next)) return false;
  colour_ = next.colour;
  row_ = 0;
  requested_ = 0;
  latched_ = 0;
  shifted_ = shape_.width;
  acted_at_ = systemc::edges(period_) - 1;
  picture_.clear();
  picture_.reserve(std::size_t{shape_.width} * shape_.height);
  std::fill(latch_row_.begin(), latch_row_.end(), 0U);
  return true;
}

/// Moves a latched row to the shift register as soon as that is empty.
void ScanOut::transfer() {
  if (latched_ != colour_.width || shifted_ != shape_.width) return;
  std::swap(latch_row_, shift_row_);
  std::fill(latch_row_.begin(), latch_row_.end(), 0U);
  requested_ = 0;
  latched_ = 0;
  shifted_ = 0;
  ++row_;
}

void ScanOut::shift(std::uint64_t clocks) {
  const std::uint64_t end = std::min<std::uint64_t>(shifted_ + clocks * pixels_, shape_.width);
  for (; shifted_ < end; ++shifted_) picture_.push_back(shift_row_[shifted_]);
  if (!picture_.empty()) video_ = picture_.back();
}

void ScanOut::latch() {
  if (!latches()) return;
  if (port_ == ScanOutPort::own) {
    latch_refresh_bit({static_cast<std::uint16_t>(colour_.base + latched_), static_cast<std::uint16_t>(row_)});
  } else {
    if (const std::optional<RefreshStep> step = refresh->refreshed()) latch_refresh_bit(*step);
    request_bit();
  }
}

void ScanOut::request_bit() {
  if (requested_ == colour_.width) return;
  const RefreshStep step{static_cast<std::uint16_t>(colour_.base + requested_), static_cast<std::uint16_t>(row_)};
  if (refreshes.nb_write(step)) ++requested_;
}

void ScanOut::latch_refresh_bit(RefreshStep refresh_step) {
  array::add_plane(refresh->memory_row(refresh_step.address, refresh_step.row), refresh_step.address - colour_.base,
                   latch_row_);
  ++latched_;
  if (latched_ == colour_.width && row_ + 1 == shape_.height) latched.nb_write(true);
}

}  // namespace csgsim::pixel_planes

#include "hw/pixel_planes/scan_out.h"

#include <algorithm>
#include <utility>

namespace csgsim::pixel_planes {

ScanOut::ScanOut(sc_core::sc_module_name name, array::PlaneShape shape)
    : sc_core::sc_module(name), shape_(shape), latch_row_(shape.width), shift_row_(shape.width), shifted_(shape.width) {
  SC_HAS_PROCESS(ScanOut);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << start_;
}

void ScanOut::begin(isa::Field colour) {
  colour_ = colour;
  row_ = 0;
  latched_ = 0;
  shifted_ = shape_.width;
  clocks_ = 0;
  picture_.clear();
  picture_.reserve(std::size_t{shape_.width} * shape_.height);
  std::fill(latch_row_.begin(), latch_row_.end(), 0U);
  start_.notify(sc_core::SC_ZERO_TIME);
}

void ScanOut::on_clock() {
  if (start_.triggered()) return next_trigger(clock.posedge_event());
  ++clocks_;
  transfer();
  shift();
  latch();
  const bool finished = row_ == shape_.height && latched_ == 0 && shifted_ == shape_.width;
  if (finished) return frames.write(++frames_done_);
  next_trigger(clock.posedge_event());
}

/// A latched row goes into the shift register as soon as that is empty.
void ScanOut::transfer() {
  if (latched_ != colour_.width || shifted_ != shape_.width) return;
  std::swap(latch_row_, shift_row_);
  std::fill(latch_row_.begin(), latch_row_.end(), 0U);
  latched_ = 0;
  shifted_ = 0;
  ++row_;
}

void ScanOut::shift() {
  if (shifted_ == shape_.width) return;
  const std::uint32_t colour = shift_row_[shifted_++];
  video.write(colour);
  picture_.push_back(colour);
}

void ScanOut::latch() {
  if (row_ == shape_.height || latched_ == colour_.width) return;
  const std::span<const std::uint64_t> bits = refresh->memory_row(colour_.base + latched_, row_);
  for (std::uint32_t x = 0; x < shape_.width; ++x) {
    const auto bit = static_cast<std::uint32_t>(bits[x / array::word_bits] >> (x % array::word_bits)) & 1U;
    latch_row_[x] |= bit << latched_;
  }
  ++latched_;
}

}  // namespace csgsim::pixel_planes

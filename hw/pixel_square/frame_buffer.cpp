#include "hw/pixel_square/frame_buffer.h"

#include <algorithm>

namespace csgsim::pixel_square {

using machines::SquareActivity;

FrameBuffer::FrameBuffer(sc_core::sc_module_name name, machines::Size picture, std::uint32_t renderers)
    : sc_core::sc_module(name),
      colours("colours", renderers),
      size_(picture),
      picture_(std::size_t{picture.width} * picture.height) {
  SC_HAS_PROCESS(FrameBuffer);
  SC_METHOD(on_clock);
  dont_initialize();
  sensitive << clock.pos();
}

void FrameBuffer::begin(const FrameContents& contents) {
  contents_ = contents;
  squares_ = 0;
  turn_ = 0;
  counter_.clear();
}

void FrameBuffer::on_clock() { counter_.count(act()); }

SquareActivity FrameBuffer::act() {
  const std::size_t ports = colours.size() + 1;
  for (std::size_t i = 0; i < ports; ++i) {
    const std::size_t port = turn_ + i < ports ? turn_ + i : turn_ + i - ports;
    if (!serve(port)) continue;
    turn_ = port + 1 == ports ? 0 : port + 1;
    return SquareActivity::working;
  }
  return SquareActivity::waiting_for_renderer;
}

bool FrameBuffer::serve(std::size_t port) {
  if (port == colours.size()) {
    ClearWord word;
    if (!clears.nb_read(word)) return false;
    clear(word.region);
    return true;
  }
  if (colours[port].num_available() == 0) return false;
  ColourWord word;
  colours[port].nb_read(word);
  store(word);
  return true;
}

void FrameBuffer::store(const ColourWord& word) {
  for (std::uint32_t i = 0; i < word.count; ++i) {
    const std::uint64_t pixel = (word.first + i) / contents_.colour_bits;
    const std::uint64_t bit = (word.first + i) % contents_.colour_bits;
    const std::uint64_t x = word.region.x + pixel % word.region.width;
    const std::uint64_t y = word.region.y + pixel / word.region.width;
    std::uint32_t& colour = picture_[y * size_.width + x];
    if (bit == 0) colour = 0;
    colour |= static_cast<std::uint32_t>(word.bits[i / 64] >> (i % 64) & 1U) << bit;
  }
  if (word.last) count_square();
}

void FrameBuffer::clear(const isa::Region& region) {
  for (std::size_t y = region.y; y < std::size_t{region.y} + region.height; ++y) {
    std::fill_n(&picture_[y * size_.width + region.x], region.width, contents_.background);
  }
  count_square();
}

void FrameBuffer::count_square() {
  if (++squares_ == contents_.squares) frames.write(++frames_done_);
}

}  // namespace csgsim::pixel_square

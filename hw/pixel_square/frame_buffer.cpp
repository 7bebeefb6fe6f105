#include "hw/pixel_square/frame_buffer.h"

#include <algorithm>

namespace csgsim::pixel_square {

FrameBuffer::FrameBuffer(sc_core::sc_module_name name, std::uint32_t renderers, std::uint32_t port_bits)
    : systemc::ClockedModule(name), colours("colours", renderers), port_bits_(port_bits), incoming_(renderers + 1) {}

void FrameBuffer::begin(const FrameContents& contents) {
  if (contents.picture != contents_.picture) {
    picture_.assign(std::size_t{contents.picture.width} * contents.picture.height, 0);
  }
  contents_ = contents;
  incoming_.assign(incoming_.size(), {});
  squares_ = 0;
  turn_ = 0;
  served_.reset();
  clocks_ = {};
}

void FrameBuffer::end_of_elaboration() {
  // No range-based loop: to clang the iterators compare ambiguously in C++20.
  std::for_each(colours.begin(), colours.end(), [&](const auto& port) { words_written_ |= port.data_written_event(); });
  words_written_ |= clears.data_written_event();
}

/// Sleeps while no port has a word.
void FrameBuffer::on_clock() {
  if (!clock.posedge()) return;
  served_.reset();
  const std::size_t ports = incoming_.size();
  for (std::size_t i = 0; i < ports; ++i) {
    const std::size_t port = turn_ + i < ports ? turn_ + i : turn_ + i - ports;
    if (!serve(port)) continue;
    served_ = port;
    turn_ = port + 1 == ports ? 0 : port + 1;
    return clocks_.add(SquareActivity::working);
  }
  next_trigger(words_written_);
}

bool FrameBuffer::serve(std::size_t port) {
  const bool is_sender = port == colours.size();
  if (is_sender && incoming_[port].gathered == header_bits) {
    clear(incoming_[port]);
    return true;
  }
  auto& fifo = is_sender ? clears : colours[port];
  if (fifo.num_available() == 0) return false;
  PortWord word;
  fifo.nb_read(word);
  take(port, word);
  return true;
}

void FrameBuffer::take(std::size_t port, const PortWord& word) {
  Incoming& square = incoming_[port];
  if (square.gathered == header_bits) return store(square, word.bits);
  take_header(square, word);
  if (square.gathered == header_bits) finish_if_whole(square);
}

void FrameBuffer::take_header(Incoming& square, const PortWord& word) const {
  const unsigned count = std::min<unsigned>(port_bits_, header_bits - square.gathered);
  square.header |= word.bits.front() << square.gathered;
  square.gathered += count;
  if (square.gathered == header_bits) square.region = region_of(square.header);
}

/// The bits follow those before; those beyond the square's are padding.
void FrameBuffer::store(Incoming& square, const std::vector<std::uint64_t>& bits) {
  const std::uint64_t end = std::min(square.next_bit + port_bits_, colour_bits(square));
  for (std::uint64_t i = 0; square.next_bit < end; ++i, ++square.next_bit) {
    std::uint32_t& colour = pixel(square, square.next_bit / contents_.colour_bits);
    const std::uint64_t place = square.next_bit % contents_.colour_bits;
    if (place == 0) colour = 0;
    colour |= static_cast<std::uint32_t>(bits[i / 64] >> (i % 64) & 1U) << place;
  }
  finish_if_whole(square);
}

void FrameBuffer::clear(Incoming& square) {
  std::vector<std::uint64_t> bits((port_bits_ + 63U) / 64U);
  const std::uint64_t count = std::min<std::uint64_t>(port_bits_, colour_bits(square) - square.next_bit);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t place = (square.next_bit + i) % contents_.colour_bits;
    put_bits(bits, i, 1, contents_.background >> place & 1U);
  }
  store(square, bits);
}

void FrameBuffer::finish_if_whole(Incoming& square) {
  served_square_ = square.region;
  if (square.next_bit < colour_bits(square)) return;
  square = {};
  if (++squares_ == contents_.squares) frames.write(++frames_done_);
}

std::uint64_t FrameBuffer::colour_bits(const Incoming& square) const {
  return std::uint64_t{square.region.width} * square.region.height * contents_.colour_bits;
}

std::uint32_t& FrameBuffer::pixel(const Incoming& square, std::uint64_t index) {
  const std::uint64_t x = square.region.x + index % square.region.width;
  const std::uint64_t y = square.region.y + index / square.region.width;
  return picture_[static_cast<std::size_t>(y * contents_.picture.width + x)];
}

}  // namespace csgsim::pixel_square

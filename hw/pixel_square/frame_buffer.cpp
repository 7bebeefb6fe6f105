#include "hw/pixel_square/frame_buffer.h"

#include <algorithm>
#include <utility>

#include "hw/array/plane.h"
#include "hw/pixel_square/figures.h"
#include "hw/systemc/kernel.h"

namespace csgsim::pixel_square {

namespace {

std::uint64_t bits_of(std::span<const std::uint64_t> bits, std::uint64_t from, unsigned count) {
  const auto place = static_cast<unsigned>(from % 64);
  std::uint64_t value = bits[from / 64] >> place;
  if (place + count > 64) value |= bits[from / 64 + 1] << (64 - place);
  return value & array::low_bits(count);
}

}  // namespace

FrameBuffer::FrameBuffer(sc_core::sc_module_name name, const machines::Machine& machine)
    : systemc::ClockedModule(name),
      colours("colours", machines::kind_figures<Figures>(machine).renderers),
      clears("clears", has_ring(machines::kind_figures<Figures>(machine))
                           ? machines::kind_figures<Figures>(machine).processors
                           : 1),
      period_(systemc::period_of(machine)),
      port_bits_(colour_word_bits(machines::kind_figures<Figures>(machine))),
      incoming_(colours.size() + clears.size()),
      screen_(machines::kind_figures<Figures>(machine), machine.clock_hz),
      free_(machines::kind_figures<Figures>(machine).banks) {}

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
  screen_.begin(contents.picture, contents.colour_bits);
  acted_at_ = systemc::edges(period_);
  begun_.notify(sc_core::SC_ZERO_TIME);
}

void FrameBuffer::end_of_elaboration() {
  // No range-based loop: clang reports an ambiguous iterator comparison in C++20.
  const auto add = [&](const auto& port) { words_written_ |= port.data_written_event(); };
  std::for_each(colours.begin(), colours.end(), add);
  std::for_each(clears.begin(), clears.end(), add);
  words_written_ |= begun_;
}

/// Sleeps while all ports are empty and the screen neither begins nor ends a turn.
void FrameBuffer::on_clock() {
  if (!clock.posedge()) return;
  const std::uint64_t now = systemc::edges(period_);
  count_clocks(now - std::exchange(acted_at_, now));
  serve_ports();
  if (served_) return clocks_.add(SquareActivity::working);
  if (screen_.row()) clocks_.add(SquareActivity::refreshing);
  if (!any_pending()) sleep();
}

/// Accounts for the elapsed clocks; the frame buffer slept through all but the last.
void FrameBuffer::count_clocks(std::uint64_t clocks) {
  if (screen_.row()) clocks_.add(SquareActivity::refreshing, clocks - 1);
  screen_.advance(clocks);
}

void FrameBuffer::sleep() {
  if (!screen_.takes_turns()) return next_trigger(words_written_);
  const std::uint64_t clocks = screen_.clocks_to_change();
  if (clocks > 1) next_trigger(sc_core::sc_time::from_value(clocks * period_.value()), words_written_);
}

void FrameBuffer::serve_ports() {
  served_.reset();
  free_.assign(free_.size(), true);
  free_left_ = free_.size();
  if (const std::optional<std::uint32_t> row = screen_.row()) {
    free_[bank_of(*row)] = false;
    --free_left_;
  }
  const std::size_t ports = incoming_.size();
  const std::size_t first = turn_;
  for (std::size_t i = 0; i < ports && free_left_ > 0; ++i) {
    const std::size_t port = first + i < ports ? first + i : first + i - ports;
    if (!try_serve(port)) continue;
    --free_left_;
    served_ = port;
    turn_ = port + 1 == ports ? 0 : port + 1;
  }
}

bool FrameBuffer::try_serve(std::size_t port) {
  if (!has_pending(port) || !try_claim_bank(port)) return false;
  if (is_clear_port(port) && incoming_[port].gathered == header_bits) {
    clear(incoming_[port]);
    return true;
  }
  PortWord word;
  port_words(port).nb_read(word);
  accept_word(port, word);
  return true;
}

sc_core::sc_fifo_in<PortWord>& FrameBuffer::port_words(std::size_t port) {
  return is_clear_port(port) ? clears[port - colours.size()] : colours[port];
}

bool FrameBuffer::has_pending(std::size_t port) {
  return (is_clear_port(port) && incoming_[port].gathered == header_bits) || port_words(port).num_available() > 0;
}

bool FrameBuffer::any_pending() {
  for (std::size_t port = 0; port < incoming_.size(); ++port)
    if (has_pending(port)) return true;
  return false;
}

/// Claims the bank in which the port's next word begins, and returns whether it was free; a header word needs no bank.
bool FrameBuffer::try_claim_bank(std::size_t port) {
  const Incoming& square = incoming_[port];
  if (square.gathered < header_bits) return true;
  const std::uint32_t bank = bank_of(row_of(square));
  if (!free_[bank]) return false;
  free_[bank] = false;
  return true;
}

void FrameBuffer::accept_word(std::size_t port, const PortWord& word) {
  Incoming& square = incoming_[port];
  if (square.gathered == header_bits) return store_colours(square, span_of(word.bits));
  take_header(square, word);
  served_square_ = square.region;
  if (square.gathered == header_bits) finish_if_complete(square);
}

void FrameBuffer::take_header(Incoming& square, const PortWord& word) const {
  const unsigned count = std::min<unsigned>(port_bits_, header_bits - square.gathered);
  square.header |= word.bits.front() << square.gathered;
  square.gathered += count;
  if (square.gathered == header_bits) square.region = region_of(square.header);
}

/// Appends the bits to those already stored; bits beyond the square's end are padding.
void FrameBuffer::store_colours(Incoming& square, std::span<const std::uint64_t> bits) {
  const Cursor next = for_each_colour(square, [&](const Cursor& at, std::uint64_t from, unsigned count) {
    std::uint32_t& colour = pixel(square, at);
    if (at.place == 0) colour = 0;
    colour |= static_cast<std::uint32_t>(bits_of(bits, from, count)) << at.place;
  });
  square.next_bit += remaining_word_bits(square);
  square.next = next;
  finish_if_complete(square);
}

void FrameBuffer::clear(Incoming& square) {
  PortBits bits((port_bits_ + 63U) / 64U);
  for_each_colour(square, [&](const Cursor& at, std::uint64_t from, unsigned count) {
    put_bits(span_of(bits), from, count, contents_.background >> at.place & array::low_bits(count));
  });
  store_colours(square, span_of(bits));
}

/// Number of bits of the next word that belong to the square.
std::uint64_t FrameBuffer::remaining_word_bits(const Incoming& square) const {
  return std::min<std::uint64_t>(port_bits_, colour_bits(square) - square.next_bit);
}

/// Calls visit(at, from, count) for each pixel with colour bits in the next word: `count` bits, starting with bit
/// `from` of the word, belong at position `at`. Returns the position at which the following word begins.
template <class Visit>
FrameBuffer::Cursor FrameBuffer::for_each_colour(const Incoming& square, const Visit& visit) const {
  Cursor at = square.next;
  const std::uint64_t end = remaining_word_bits(square);
  for (std::uint64_t from = 0; from < end;) {
    const auto count = static_cast<unsigned>(std::min<std::uint64_t>(contents_.colour_bits - at.place, end - from));
    visit(at, from, count);
    from += count;
    at.place += count;
    if (at.place < contents_.colour_bits) continue;
    at.place = 0;
    if (++at.x < square.region.width) continue;
    at.x = 0;
    ++at.y;
  }
  return at;
}

void FrameBuffer::finish_if_complete(Incoming& square) {
  served_square_ = square.region;
  if (square.next_bit < colour_bits(square)) return;
  square = {};
  if (++squares_ == contents_.squares) frames.write(++frames_done_);
}

std::uint64_t FrameBuffer::colour_bits(const Incoming& square) const {
  return std::uint64_t{square.region.width} * square.region.height * contents_.colour_bits;
}

std::uint32_t& FrameBuffer::pixel(const Incoming& square, const Cursor& position) {
  const std::size_t row = std::size_t{square.region.y} + position.y;
  return picture_[row * contents_.picture.width + square.region.x + position.x];
}

}  // namespace csgsim::pixel_square

#pragma once

#include <cstdint>
#include <systemc>
#include <vector>

#include "hw/link/frame_words.h"
#include "hw/machines/kind.h"
#include "hw/machines/machine.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"
#include "hw/pixel_square/port_word.h"
#include "hw/systemc/clock.h"
#include "hw/systemc/kernel.h"
#include "hw/systemc/retirement.h"

namespace csgsim::testing {

/// A machine of 2 x 2 pixels of 8 bits per square and a picture of 4 x 2, with a link of 32 bits.
inline machines::Machine square_machine(const pixel_square::Figures& figures, const machines::Link& link = {
                                                                                  .width = 32,
                                                                                  .word_clocks = 1,
                                                                                  .fifo_depth = 64,
                                                                                  .latency = 0,
                                                                              }) {
  machines::Machine machine = machines::blank_machine(pixel_square::kind);
  machine.name = "squares";
  machine.array = {2, 2, 8};
  machine.picture = {4, 2};
  machine.clock_hz = 10'000'000;
  machine.link = link;
  machine.own = figures;
  return machine;
}

/// Clocked test bench that advances edge by edge; a value written between two edges is visible at the next.
class Bench {
 public:
  explicit Bench(const machines::Machine& machine) : clock("clock", systemc::period_of(machine)) {}

  /// Advances by `count` edges, including all their delta cycles.
  void edges(std::uint64_t count) {
    if (!begun_) sc_core::sc_start(clock.period() / 2);
    begun_ = true;
    for (std::uint64_t i = 0; i < count; ++i) sc_core::sc_start(clock.period());
  }

  systemc::Clock clock;

 private:
  bool begun_ = false;
};

/// Records the reported squares.
class SquareListener final : public systemc::RunListener {
 public:
  void after_segment(std::uint32_t segment, const systemc::PixelView& /*pixels*/) override {
    squares.push_back(segment);
  }

  std::vector<std::uint32_t> squares;
};

/// Removes and returns all words of a FIFO.
template <class Word>
std::vector<Word> drained(sc_core::sc_fifo<Word>& fifo) {
  std::vector<Word> words;
  for (Word word; fifo.nb_read(word);) words.push_back(word);
  return words;
}

/// Returns the bits of words of port_bits bits each, in the order in which they travel.
inline std::vector<bool> bits_of(const std::vector<pixel_square::PortWord>& words, std::uint32_t port_bits) {
  std::vector<bool> bits;
  for (const pixel_square::PortWord& word : words)
    for (std::uint32_t i = 0; i < port_bits; ++i) bits.push_back((word.bits.at(i / 64) >> (i % 64) & 1U) != 0);
  return bits;
}

/// Appends a number of `count` bits, least significant first.
inline void add_bits(std::vector<bool>& bits, std::uint64_t value, unsigned count) {
  for (unsigned i = 0; i < count; ++i) bits.push_back((value >> i & 1U) != 0);
}

/// Returns a square as it travels in words of port_bits bits: x, y, width and height of 16 bits each, then, starting a
/// new word, the colours of colour_bits bits each; zeros fill the last word.
inline std::vector<bool> travelling(const isa::Region& region, const std::vector<std::uint32_t>& colours,
                                    unsigned colour_bits, std::uint32_t port_bits) {
  std::vector<bool> bits;
  const auto fill_word = [&] {
    while (bits.size() % port_bits != 0) bits.push_back(false);
  };
  for (const std::uint32_t number : {region.x, region.y, region.width, region.height}) add_bits(bits, number, 16);
  fill_word();
  for (const std::uint32_t colour : colours) add_bits(bits, colour, colour_bits);
  fill_word();
  return bits;
}

/// Splits bits into words of port_bits bits.
inline std::vector<pixel_square::PortWord> in_words(const std::vector<bool>& bits, std::uint32_t port_bits) {
  std::vector<pixel_square::PortWord> words;
  for (std::size_t i = 0; i < bits.size(); ++i) {
    const std::size_t place = i % port_bits;
    if (place == 0) words.push_back({pixel_square::PortBits((port_bits + 63) / 64)});
    if (bits[i]) words.back().bits[place / 64] |= std::uint64_t{1} << place % 64;
  }
  return words;
}

}  // namespace csgsim::testing

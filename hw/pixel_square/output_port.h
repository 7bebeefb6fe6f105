#pragma once

#include <cstdint>
#include <deque>
#include <systemc>

#include "hw/pixel_planes/pixel_ports.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/output_buffer.h"
#include "hw/pixel_square/port_word.h"

namespace csgsim::pixel_square {

/// Sends finished squares to the frame buffer: a word a clock, as long as there is room, from the first clock in which
/// the square no longer moves.
///
/// With two buffers a square leaves from the second, where bit planes come in and colours go out. With a backing store
/// it leaves from there, behind those that wait in it. With one buffer it leaves
/// from the pixels' memory: each row is latched, `latch_bits` bits of all its pixels a clock, and goes over into a
/// register when it is latched and the next word of colours cannot be made without it; while words are made of that,
/// the next row is latched. A square that moves or leaves rests in the pixels' memory.
class OutputPort final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_in<std::uint64_t> begun{"begun"};    ///< squares that have begun to move or to leave
  sc_core::sc_in<std::uint64_t> header{"header"};  ///< of the last of these
  sc_core::sc_in<bool> moving{"moving"};           ///< it is not whole in the output buffer
  sc_core::sc_port<pixel_planes::RefreshPort> memory{"memory"};
  sc_core::sc_fifo_out<PortWord> colours{"colours"};
  sc_core::sc_out<std::uint64_t> left{"left"};  ///< squares whose last word has left

  OutputPort(sc_core::sc_module_name name, const Figures& figures);

  /// `colour`: what of a pixel's memory leaves.
  void begin(isa::Field colour) { colour_ = colour; }

 private:
  void act();
  void begin_square();
  void transfer();
  void latch();
  void send();

  const std::uint32_t latch_bits_;  ///< no_latch: the square is in the buffer at once
  isa::Field colour_;
  const std::uint32_t port_bits_;
  std::deque<OutputBuffer> squares_;  ///< that have not left
  std::uint32_t latched_ = 0;         ///< bit planes of the row in the latch
  std::uint32_t rows_to_latch_ = 0;   ///< of the square, the one in the latch included
  std::uint64_t left_count_ = 0;
};

}  // namespace csgsim::pixel_square

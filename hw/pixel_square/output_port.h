#pragma once

#include <cstdint>
#include <deque>
#include <systemc>

#include "hw/pixel_planes/pixel_ports.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/output_buffer.h"
#include "hw/pixel_square/port_word.h"

namespace csgsim::pixel_square {

/// Sends finished squares to the frame buffer, one word per clock while there is room. Sending starts in the first
/// clock after the square has moved.
/// - Two buffers: a square leaves from the second buffer, which bit planes enter and colours leave.
/// - Backing store: a square leaves from there, after the squares that already wait in it.
/// - One buffer: a square leaves from the pixels' memory. Each row is latched, `latch_bits` bits of all its pixels per
///   clock. It is transferred to a register once it is latched and the next word of colours needs it. While words are
///   sent from that register, the next row is latched.
///
/// The pixels do not change a square that is moving or leaving.
class OutputPort final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_in<std::uint64_t> begun{"begun"};    ///< squares that have begun to move or to leave
  sc_core::sc_in<std::uint64_t> header{"header"};  ///< header of the last of these
  /// Whether that square has not yet arrived completely in the output buffer.
  sc_core::sc_in<bool> moving{"moving"};
  sc_core::sc_port<pixel_planes::RefreshPort> memory{"memory"};
  sc_core::sc_fifo_out<PortWord> colours{"colours"};
  sc_core::sc_out<std::uint64_t> left{"left"};  ///< squares whose last word has left

  OutputPort(sc_core::sc_module_name name, const Figures& figures);

  /// `colour`: field of a pixel's memory that is sent.
  void begin(isa::Field colour) { colour_ = colour; }

 private:
  void act();
  void begin_square();
  void transfer();
  void latch();
  void send();

  const std::uint32_t latch_bits_;  ///< no_latch: a whole square is loaded at once
  isa::Field colour_;
  const std::uint32_t port_bits_;
  std::deque<OutputBuffer> squares_;  ///< squares that have not left completely
  std::uint32_t latched_ = 0;         ///< latched bit planes of the row in the latch
  std::uint32_t rows_to_latch_ = 0;   ///< rows of the square not completely latched, including the row in the latch
  std::uint64_t left_count_ = 0;
};

}  // namespace csgsim::pixel_square

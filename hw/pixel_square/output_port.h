#pragma once

#include <cstdint>
#include <systemc>

#include "hw/pixel_planes/pixel_processors.h"
#include "hw/pixel_square/output_buffer.h"
#include "hw/pixel_square/port_word.h"

namespace csgsim::pixel_square {

/// Sends finished squares to the frame buffer, from an output buffer or from the pixels' own memory: a word a clock, as
/// long as there is room, from the first clock in which the square no longer moves. A square that moves or leaves rests
/// in the pixels' memory, so that it is read once, when it is begun.
class OutputPort final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_in<std::uint64_t> begun{"begun"};    ///< squares that have begun to move or to leave
  sc_core::sc_in<std::uint64_t> header{"header"};  ///< of the last of these
  sc_core::sc_in<bool> moving{"moving"};           ///< it is not whole in the output buffer
  sc_core::sc_port<pixel_planes::RefreshPort> memory{"memory"};
  sc_core::sc_fifo_out<PortWord> colours{"colours"};
  sc_core::sc_out<std::uint64_t> left{"left"};  ///< squares whose last word has left

  OutputPort(sc_core::sc_module_name name, std::uint32_t port_bits);

  /// `colour`: what of a pixel's memory leaves.
  void begin(isa::Field colour) { colour_ = colour; }

 private:
  void act();
  void send();

  isa::Field colour_;
  OutputBuffer buffer_;
  std::uint64_t left_count_ = 0;
};

}  // namespace csgsim::pixel_square

#pragma once

#include <cstddef>
#include <span>
#include <systemc>

#include "hw/isa/program.h"
#include "hw/pixel_planes/words.h"

namespace csgsim::pixel_planes {

/// The host's end of the link: keeps the FIFO to the controller filled with the program's instructions, and closes the
/// program with an end word. Where the controller jumps, it goes on from there within the same clock period.
class HostLink final : public sc_core::sc_module {
 public:
  sc_core::sc_fifo_out<HostWord> link{"link"};
  sc_core::sc_fifo_in<std::uint64_t> jumps{"jumps"};

  explicit HostLink(sc_core::sc_module_name name);

  /// Starts to send. The segments have to live until the program is done.
  void send(std::span<const isa::Segment> segments);

 private:
  void fill();
  void go_on_from(std::uint64_t ordinal);
  HostWord next_word();

  std::span<const isa::Segment> segments_;
  std::size_t segment_ = 0;
  std::size_t index_ = 0;      ///< within the segment
  std::uint64_t ordinal_ = 0;  ///< within the program
  bool sending_ = false;
  sc_core::sc_event start_{"start"};
};

}  // namespace csgsim::pixel_planes

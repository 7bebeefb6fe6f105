#pragma once

#include <cstddef>
#include <span>
#include <systemc>

#include "hw/isa/program.h"
#include "hw/pixel_planes/words.h"

namespace csgsim::pixel_planes {

/// The host's end of the link: keeps the FIFO to the controller filled with the program's instructions, and closes the
/// program with an end word.
class HostLink final : public sc_core::sc_module {
 public:
  sc_core::sc_fifo_out<HostWord> link{"link"};

  explicit HostLink(sc_core::sc_module_name name);

  /// Starts to send. The segments have to live until the program is done.
  void send(std::span<const isa::Segment> segments);

 private:
  void fill();
  HostWord next_word();

  std::span<const isa::Segment> segments_;
  std::size_t segment_ = 0;
  std::size_t index_ = 0;
  std::uint64_t ordinal_ = 0;
  bool sending_ = false;
  sc_core::sc_event start_{"start"};
};

}  // namespace csgsim::pixel_planes

// The machine's end of a link.
// Used by hw/pixel_planes, hw/pixel_square and hw/scan_line.
#pragma once

#include <optional>
#include <systemc>

#include "hw/isa/link_word.h"
#include "hw/isa/wire.h"

namespace csgsim::link {

/// The machine's end of a link: a shift register that collects words until a command is complete, and holds the command
/// until it is taken. The owner of the port must call clock() at each edge, after examining the command: a command
/// whose last word arrives at an edge can be taken at the next edge, and the edge at which it is taken makes room for a
/// word.
class Receiver {
 public:
  explicit Receiver(unsigned link_width) : decoder_(link_width), link_width_(link_width) {}

  /// Whether the register contains a complete command.
  [[nodiscard]] bool holds() const { return command_.has_value(); }

  /// Puts a command into the empty register.
  void put(const isa::Command& command) { command_ = command; }

  /// Removes and returns the command in the register.
  isa::Command take();

  /// A clock edge: reads a word, if available, unless a complete command is held.
  void clock(sc_core::sc_fifo_in<isa::LinkWord>& link);

  /// Empties the FIFO and the register. After a request to continue at another instruction, it must be called in place
  /// of clock() at the edge of the request and at the next edge, so that all words sent before the host received the
  /// request are removed.
  void drop(sc_core::sc_fifo_in<isa::LinkWord>& link);

 private:
  isa::WireDecoder decoder_;
  unsigned link_width_;
  std::optional<isa::Command> command_;
};

}  // namespace csgsim::link

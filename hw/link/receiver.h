#pragma once

#include <optional>
#include <systemc>

#include "hw/isa/link_word.h"
#include "hw/isa/wire.h"

namespace csgsim::link {

/// The machine's end of a link: a shift register that gathers words until the command in it is whole, and holds it
/// until it is taken. Whoever owns the port clocks it, after having looked at the command: then a command whose last
/// word came at an edge can be taken at the next, and the edge at which it is taken makes room for a word.
class Receiver {
 public:
  explicit Receiver(unsigned link_width) : decoder_(link_width), link_width_(link_width) {}

  /// Is a whole command in the register?
  [[nodiscard]] bool holds() const { return command_.has_value(); }

  /// Puts a command into the empty register.
  void put(const isa::Command& command) { command_ = command; }

  /// The command in the register, which becomes empty.
  isa::Command take();

  /// An edge: takes a word if there is one and no whole command is held.
  void clock(sc_core::sc_fifo_in<isa::LinkWord>& link);

  /// Empties the FIFO and the register. After a request for other words it has to be done at the edge of the request
  /// and at the next, instead of clock: then no word is left that was sent before the host knew of it.
  void drop(sc_core::sc_fifo_in<isa::LinkWord>& link);

 private:
  isa::WireDecoder decoder_;
  unsigned link_width_;
  std::optional<isa::Command> command_;
};

}  // namespace csgsim::link

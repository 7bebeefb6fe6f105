#pragma once

#include <cstddef>
#include <systemc>
#include <vector>

#include "hw/pixel_planes/control_word.h"

namespace csgsim::pixel_planes {

/// `length` registers between controller and pixels, so that a control word arrives with the bits that entered the
/// multiplier trees in its clock. With length 0 a wire.
class ControlDelay final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};
  sc_core::sc_in<ControlWord> in{"in"};
  sc_core::sc_out<ControlWord> out{"out"};
  sc_core::sc_out<bool> question{"question"};  ///< the word that comes out asks for the wired OR

  ControlDelay(sc_core::sc_module_name name, unsigned length);

 private:
  void shift();
  void send(const ControlWord& word);

  const unsigned length_;
  std::vector<ControlWord> registers_;  ///< a ring
  std::size_t oldest_ = 0;
  unsigned empty_ = 0;  ///< words without a step that have come in one after another
};

}  // namespace csgsim::pixel_planes

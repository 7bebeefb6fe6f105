#pragma once

#include <systemc>

#include "hw/pixel_planes/pixel_processors.h"
#include "hw/pixel_planes/words.h"

namespace csgsim::pixel_planes {

/// The wired OR of all enable bits: within the clock in which a question is at the pixels, the answer is at the
/// controller.
class GlobalOr final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> question{"question"};
  sc_core::sc_port<EnableLines> enable{"enable"};
  sc_core::sc_out<Answer> answer{"answer"};

  explicit GlobalOr(sc_core::sc_module_name name);

 private:
  void reduce();
};

}  // namespace csgsim::pixel_planes

#include "hw/pixel_planes/global_or.h"

namespace csgsim::pixel_planes {

GlobalOr::GlobalOr(sc_core::sc_module_name name) : sc_core::sc_module(name) {
  SC_HAS_PROCESS(GlobalOr);
  SC_METHOD(reduce);
  dont_initialize();
  sensitive << question << enable;
}

void GlobalOr::reduce() {
  const bool asked = question.read();
  answer.write({.valid = asked, .any_enabled = asked && enable->any_enabled()});
}

}  // namespace csgsim::pixel_planes

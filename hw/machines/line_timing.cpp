#include <stdexcept>

#include "hw/machines/timing.h"

namespace csgsim::machines {

FrameTiming time_lines(const isa::Program& /*program*/, const Machine& /*machine*/) {
  throw std::logic_error("not there yet");
}

}  // namespace csgsim::machines

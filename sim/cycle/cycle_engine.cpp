#include <stdexcept>

#include "sim/cycle/kinds.h"

namespace csgsim::sim {

std::unique_ptr<Engine> make_cycle_engine(const machines::Machine& machine) {
  switch (machine.kind) {
    case machines::Kind::frame_buffer: return make_pixel_planes_engine(machine);
    case machines::Kind::scan_line: return make_scan_line_engine(machine);
    case machines::Kind::pixel_square: return make_pixel_square_engine(machine);
  }
  throw std::logic_error("a machine of no kind");
}

}  // namespace csgsim::sim

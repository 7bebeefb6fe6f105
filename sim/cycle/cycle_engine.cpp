#include <stdexcept>

#include "sim/cycle/engines.h"

namespace csgsim::sim {

namespace {

bool same_hardware(const machines::Machine& one, const machines::Machine& other) {
  return one.kind == other.kind && one.array == other.array && one.clock_hz == other.clock_hz &&
         one.memory_reads == other.memory_reads && one.alu_bits == other.alu_bits && one.scan_line == other.scan_line &&
         one.pixel_square == other.pixel_square;
}

}  // namespace

void claim_kernel(const machines::Machine& machine) {
  static const machines::Machine elaborated = machine;
  if (same_hardware(machine, elaborated)) return;
  throw std::logic_error("SystemC elaborates once a process, which has been done for " + elaborated.name +
                         "; simulate " + machine.name + " clock by clock in a process of its own");
}

std::unique_ptr<Engine> make_cycle_engine(const machines::Machine& machine) {
  switch (machine.kind) {
    case machines::Kind::frame_buffer: return make_pixel_planes_engine(machine);
    case machines::Kind::scan_line: return make_scan_line_engine(machine);
    case machines::Kind::pixel_square: break;
  }
  throw std::logic_error("no machine in SystemC of this kind");
}

}  // namespace csgsim::sim

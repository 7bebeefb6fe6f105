#include <stdexcept>

#include "sim/cycle/kinds.h"

namespace csgsim::sim {

namespace {

/// Names and sources of figures do not matter, nor does the picture, but to a frame buffer beside the renderers.
bool same_hardware(const machines::Machine& one, const machines::Machine& other) {
  return one.kind == other.kind && one.array == other.array && one.clock_hz == other.clock_hz &&
         one.memory_reads == other.memory_reads && one.alu_bits == other.alu_bits &&
         (one.kind != machines::Kind::pixel_square || one.picture == other.picture) &&
         one.scan_line == other.scan_line && one.pixel_square == other.pixel_square;
}

}  // namespace

void claim_elaboration(const machines::Machine& machine) {
  static const machines::Machine elaborated = machine;
  if (same_hardware(machine, elaborated)) return;
  throw std::logic_error("SystemC elaborates once a process, which has been done for " + elaborated.name +
                         "; simulate " + machine.name + " clock by clock in a process of its own");
}

}  // namespace csgsim::sim

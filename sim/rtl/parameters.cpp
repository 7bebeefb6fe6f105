#include "sim/rtl/parameters.h"

#include <fmt/format.h>

#include <algorithm>

#include "hw/base/error.h"
#include "hw/isa/colour_format.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/kind.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/kind.h"

namespace csgsim::rtl {

namespace {

void refuse_other_kind(const machines::Machine& machine) {
  if (machine.kind == &pixel_planes::kind) return;
  throw InputError(fmt::format("{} is of the kind {}, which has no Verilog; use a machine of the kind {}, such as {}",
                               machine.name, machine.kind->name, pixel_planes::kind.name, "pixel-planes-4"));
}

void refuse_above_one(const machines::Machine& machine, std::string_view figure, std::uint32_t value) {
  if (value == 1) return;
  throw InputError(fmt::format("{}: {} is {}, but the Verilog supports only 1; add --set {}=1", machine.name, figure,
                               value, figure));
}

bool takes_root(const isa::Program& program) {
  return std::ranges::any_of(program.segments, [](const isa::Segment& segment) {
    return std::ranges::any_of(segment.instructions, [](const isa::Instruction& instruction) {
      return instruction.opcode == isa::Opcode::root;
    });
  });
}

}  // namespace

std::vector<Parameter> verilog_parameters(const machines::Machine& machine, const isa::Program* program) {
  refuse_other_kind(machine);
  refuse_above_one(machine, "evaluator.bits", machine.evaluator_bits);
  refuse_above_one(machine, "evaluator.register_levels", machine.register_levels);
  const auto& own = machines::kind_figures<pixel_planes::Figures>(machine);
  const bool is_shared = own.scan_out_port == pixel_planes::ScanOutPort::shared;
  const bool has_roots = machine.evaluator_degree == 2 || (program != nullptr && takes_root(*program));
  const std::uint32_t pixels = machine.array.width * machine.array.height;
  return {
      {"WIDTH", machine.array.width, "array.width"},
      {"HEIGHT", machine.array.height, "array.height"},
      {"MEMORY_BITS", machine.array.memory_bits, "array.memory_bits"},
      {"MEMORY_READS", machine.memory_reads, "memory.reads"},
      {"ALU_BITS", machine.alu_bits, "alu.bits"},
      {"DEGREE", machine.evaluator_degree, "evaluator.degree"},
      {"ROOTS", has_roots ? 1U : 0U, ""},
      {"LINK", machine.link.width, "link.width"},
      {"FIFO_DEPTH", machine.link.fifo_depth, "link.fifo_depth"},
      {"CLEAR_CLOCKS", std::max(1U, machine.clear_clocks), "memory.clear_clocks"},
      {"HAS_OR", own.has_global_or ? 1U : 0U, "global_or.present"},
      {"FAN_IN", own.or_fan_in, "global_or.fan_in"},
      {"SCAN_PIXELS", std::min(own.scan_out_pixels, machine.array.width), "scan_out.pixels"},
      {"SCAN_SHARED", is_shared ? 1U : 0U, "scan_out.port"},
      {"BUFFERS", own.scan_out_buffers, "scan_out.buffers"},
      {"COLOUR_BITS", program != nullptr ? program->colour.width : isa::max_colour_bits, ""},
      {"CHIP", std::min(pixels, max_chip_pixels), ""},
  };
}

}  // namespace csgsim::rtl

#include "hw/bit_serial_memory/row_text.h"

#include <fmt/format.h>

#include <cstdint>
#include <string_view>

#include "hw/bit_serial_memory/figures.h"
#include "hw/bit_serial_memory/micro_program.h"
#include "hw/bit_serial_memory/slots.h"
#include "hw/isa/opcodes.h"

namespace csgsim::bit_serial_memory {

void print_row_map(std::ostream& out, const RowMap& map) {
  const auto rows = [&](std::string_view name, unsigned first, unsigned count) {
    out << fmt::format("rows {} {} {}\n", name, first, count);
  };
  rows("memory", 0, map.memory_bits);
  rows("zero", map.zero(), 1);
  rows("one", map.one(), 1);
  rows("enable", map.enable(), 1);
  rows("select", map.select(), 1);
  rows("carry", map.carry(), 1);
  rows("scratch", map.scratch(0), RowMap::scratch_rows);
  rows("triple", map.t(0), 4);
  rows("dual", map.dual(0), 2);
  rows("sum", map.sum(0), RowMap::sum_rows);
  rows("spare", map.spare(0), RowMap::spare_rows);
  rows("x", map.x(0), map.x_bits);
  rows("y", map.y(0), map.y_bits);
}

namespace {

void print(std::ostream& out, const RowCommands& commands) {
  for (const RowCommand& command : commands) out << text_of(command) << '\n';
}

}  // namespace

void print_row_commands(std::ostream& out, const isa::Program& program, const machines::Machine& machine) {
  const auto& figures = machines::kind_figures<Figures>(machine);
  const RowMap map(machine.array.memory_bits, program.shape.width, program.shape.height);
  const MicroDesign design = micro_design(figures);
  out << fmt::format("# {}: {} x {} pixels, pixel y * {} + x in column y * {} + x\n", machine.name, program.shape.width,
                     program.shape.height, program.shape.width, program.shape.width);
  print_row_map(out, map);
  std::uint64_t number = 0;
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    out << fmt::format("# segment {}: all pixel memory becomes 0\n", s);
    print(out, clear_program(map, design));
    for (const isa::Instruction& instruction : program.segments[s].instructions) {
      out << fmt::format("# i{} {}", number++, isa::name_of(instruction.opcode));
      const isa::Linear& linear = instruction.linear;
      if (linear.width > 0) out << fmt::format(" a={} b={} c={} width={}", linear.a, linear.b, linear.c, linear.width);
      out << '\n';
      print(out, micro_program(instruction, map, design));
    }
  }
  if (program.colour.width == 0) return;
  out << "# the picture goes to the host\n";
  print(out, send_program(program.colour));
}

}  // namespace csgsim::bit_serial_memory

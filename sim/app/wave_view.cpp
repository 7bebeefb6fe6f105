#include "sim/app/wave_view.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "hw/base/text.h"

namespace csgsim::app {

namespace {

/// GTKWave's flags for the way a signal is shown.
constexpr std::string_view as_bits = "@28\n";
constexpr std::string_view as_number = "@24\n";
constexpr std::string_view as_hexadecimal = "@22\n";
constexpr std::string_view as_text = "@820\n";
constexpr std::string_view as_comment = "@200\n";

/// Picoseconds a clock, rounded as SystemC does.
std::uint64_t period(std::uint64_t clock_hz) {
  return static_cast<std::uint64_t>(std::llround(1.0 / static_cast<double>(clock_hz) * 1e12));
}

std::string_view format_of(const isa::NamedField& named) {
  if (named.field.width == 1) return as_bits;
  const bool is_colour = named.role == isa::FieldRole::colour || named.role == isa::FieldRole::candidate_colour;
  return is_colour ? as_hexadecimal : as_number;
}

/// What GTKWave appends to the name of a bus.
std::string bus(unsigned width) { return width > 1 ? fmt::format("[{}:0]", width - 1) : ""; }

std::string pixel_view(const kernel::WaveProbe& probe, const std::vector<isa::NamedField>& fields, unsigned alu_bits) {
  const std::string pixel = fmt::format("SystemC.pixel_{}_{}.", probe.x, probe.y);
  std::string view = fmt::format("{}-pixel {},{}\n{}", as_comment, probe.x, probe.y, as_bits);
  for (const std::string_view wire : {"tree_bit", "carry", "enable"}) view += pixel + std::string(wire) + "\n";
  for (const std::string_view port : {"mem_read_x", "mem_written"})
    view += pixel + std::string(port) + bus(alu_bits) + "\n";
  for (const isa::NamedField& named : fields) {
    view += format_of(named);
    view += pixel + kernel::wave_identifier(named.name) + bus(named.field.width) + "\n";
  }
  return view;
}

}  // namespace

std::string gtkwave_view(const kernel::WaveRequest& request, const std::string& waveform,
                         const machines::Machine& machine) {
  const std::uint64_t start = (request.begin + 1) * period(machine.clock_hz);
  // A name that would end its line or its quotes is left out: the file is then named beside this one.
  const bool is_plain = printable(waveform) == waveform && waveform.find('"') == std::string::npos;
  std::string view = is_plain ? fmt::format("[dumpfile] \"{}\"\n", waveform) : "";
  view += fmt::format("[timestart] {}\n*-20.0 {}\n", start, start);
  view += as_bits;
  view += "SystemC.clock\n";
  view += as_text;
  view += "SystemC.controller.opcode_text[159:0]\nSystemC.controller.purpose_text[159:0]\n";
  view += as_number;
  view += "SystemC.controller.primitive[31:0]\nSystemC.controller.instruction[63:0]\nSystemC.controller.bit[31:0]\n";
  view += as_bits;
  view += "SystemC.root.a\nSystemC.root.b\nSystemC.root.c\n";
  view += as_text;
  view += "SystemC.pixels.function_text[159:0]\n";
  view += as_number;
  view += "SystemC.pixels.read_x[15:0]\nSystemC.pixels.write[15:0]\n";
  for (const kernel::WaveProbe& probe : request.probes) view += pixel_view(probe, request.fields, machine.alu_bits);
  return view;
}

}  // namespace csgsim::app

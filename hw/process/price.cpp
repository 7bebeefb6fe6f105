#include "hw/process/price.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "hw/machines/area.h"
#include "hw/machines/area_table.h"
#include "hw/machines/regions.h"

namespace csgsim::process {

using machines::Machine;

namespace {

constexpr double max_hz = 1e10;  ///< maximum clock rate of a machine description
constexpr double ps = 1e-12;     ///< s
constexpr double ns = 1e-9;      ///< s
constexpr double aj = 1e-18;     ///< J
constexpr double ff = 1e-15;     ///< F
constexpr double pw = 1e-12;     ///< W
constexpr double nm2 = 1e-12;    ///< mm²

/// A gate with two inputs: a NAND in static CMOS, and in nMOS with its load.
constexpr machines::Transistors gate_transistors{4, 3};

// Gates in series:
constexpr double full_adder_gates = 3;
constexpr double select_gates = 4;  ///< for the ALU's operands and operation
constexpr double carry_gates = 2;   ///< per bit of an adder
constexpr double turn_gates = 2;    ///< per level of the rotator at a port, which is a multiplexer

/// A parameter of the description as a number; empty if the kind does not have it or its value is ideal.
std::optional<std::uint64_t> figure_of(const Machine& machine, std::string_view key) {
  const auto found = std::ranges::find(machine.figures, key, &machines::Figure::key);
  if (found == machine.figures.end()) return std::nullopt;
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(found->value.data(), found->value.data() + found->value.size(), value);
  if (error != std::errc{} || end != found->value.data() + found->value.size()) return std::nullopt;
  return value;
}

/// Levels of a tree that combines `lines` lines with gates of `inputs` inputs.
double levels_of(std::uint64_t lines, std::uint64_t inputs) {
  double levels = 0;
  for (std::uint64_t reached = 1; reached < lines; reached *= inputs) ++levels;
  return levels;
}

machines::LogicFamily family_of(const Process& process) { return static_cast<machines::LogicFamily>(process.family); }

double in_family(const machines::Transistors& transistors, const Process& process) {
  return family_of(process) == machines::LogicFamily::cmos ? transistors.cmos : transistors.nmos;
}

/// mm² of a logic transistor with its share of wires.
double transistor_mm2(const Process& process) {
  return static_cast<double>(process.transistor_area) * 100 / static_cast<double>(process.utilization) * nm2;
}

/// mm² of a memory cell with its share of the periphery. A second read port adds two transistors.
double bit_mm2(std::uint32_t reads, const Process& process) {
  const auto transistors = static_cast<double>(process.cell_transistors);
  return static_cast<double>(process.cell_area) * (1 + 2 * (reads - 1.0) / transistors) *
         (1 + static_cast<double>(process.periphery) / 100) * nm2;
}

/// Joules to read or write a bit of a pixel's memory, whose bit lines are as long as the side of a square memory.
double access_joules(const Machine& machine, const Process& process) {
  return static_cast<double>(process.memory_energy) * aj *
         std::sqrt(machine.array.memory_bits / static_cast<double>(process.memory_bits));
}

/// The distance from one pixel to the next, mm.
double pitch_of(const PixelArea& pixel) { return std::sqrt(pixel.logic + pixel.memory); }

/// Gates in series in a decoder for all memory bits of a pixel, including the driver of a line.
double decoder_gates(const Machine& machine, const Process& process) {
  const double address_bits = levels_of(machine.array.memory_bits, 2);
  return levels_of(static_cast<std::uint64_t>(address_bits), process.gate_fan_in) + 1;
}

double pixel_path(const Machine& machine, const Process& process) {
  const double turns = levels_of(machine.alu_bits, 2);
  const double gates =
      decoder_gates(machine, process) + turn_gates * turns + select_gates + carry_gates * machine.alu_bits;
  return static_cast<double>(process.memory_access) + gates * static_cast<double>(process.gate_delay);
}

/// Stream bits that a node passes on to its children.
double stream_bits(const Machine& machine) {
  return (machine.evaluator_degree == 1 ? 2.0 : 4.0) * machine.evaluator_bits;
}

/// Flip-flops of a pixel and its node (docs/hardware.md, "Logic"): those of the streams, a carry for each adder, and,
/// if one stream bit enters per clock, one for the delayed slope. With wider streams the delay is part of the streams.
double register_bits(const Machine& machine) {
  const double operand_latch = machine.memory_reads == 1 ? machine.alu_bits : 0;
  const double carries = machine.evaluator_degree == 1 ? 1 : 3;
  const double flag_and_delay = machine.evaluator_degree == 1 ? 0 : machine.evaluator_bits == 1 ? 2 : 1;
  return 3 + operand_latch + stream_bits(machine) * machines::registered_node_fraction(machine) + carries +
         flag_and_delay;
}

/// Number of adders chained between two registers of a tree.
double adders_in_series(const Machine& machine) {
  const double levels = levels_of(std::max(machine.array.width, machine.array.height), 2);
  return std::clamp<double>(machine.register_levels, 1, std::max(levels, 1.0));
}

/// Gates in series: a carry ripples through an adder while the sums of its lower bits are already in the next adder.
double tree_gates(const Machine& machine) {
  return full_adder_gates * adders_in_series(machine) + carry_gates * (machine.evaluator_bits - 1.0);
}

/// Wire length in mm between these adders: `longest` * (1/2 + 1/4 + ...), each wire half as long as the previous one.
double tree_wires(const Machine& machine, double longest) {
  return longest * (1 - std::exp2(1 - adders_in_series(machine)));
}

/// Joules per pixel and clock. The cell of one transistor loses its bit when read, and is written again.
double pixel_joules(const Machine& machine, const PixelArea& pixel, const Process& process) {
  const double accesses = machine.memory_reads * (process.cell_transistors == 1 ? 2.0 : 1.0) + 1.0;
  const double adders = machine.alu_bits + (machine.evaluator_degree == 1 ? 1.0 : 3.0) * machine.evaluator_bits;
  return accesses * machine.alu_bits * access_joules(machine, process) +
         aj * (adders * static_cast<double>(process.adder_energy) +
               register_bits(machine) * static_cast<double>(process.register_energy)) +
         stream_bits(machine) * pitch_of(pixel) * wire_joules(process);
}

/// Transistors shared by all pixels of an array, summed over the arrays.
double shared_transistors(const Machine& machine, const Process& process) {
  const double arrays = static_cast<double>(figure_of(machine, "renderers.count").value_or(1));
  const double fifos = static_cast<double>(machine.link.fifo_depth) * machine.link.width / machines::fifo_bits;
  return arrays * (in_family(machines::controller_transistors, process) +
                   fifos * in_family(machines::fifo_transistors, process));
}

/// The fraction of the clocks in which all pixels refresh a row of their memory; a row has the bits of the ALU.
double refresh_share(const Machine& machine, const Process& process, double hz) {
  if (process.refresh_time == 0) return 0;
  const double rows = std::ceil(static_cast<double>(machine.array.memory_bits) / machine.alu_bits);
  return rows / (hz * static_cast<double>(process.refresh_time) * ns);
}

/// Watts of static gates, clock wires and refresh.
double idle_watts(const Machine& machine, const machines::Resources& resources, const PixelArea& pixel,
                  const Process& process) {
  const auto pixels = static_cast<double>(resources.processors);
  const double transistors = pixels * static_cast<double>(*machines::logic_transistors(machine, family_of(process))) +
                             shared_transistors(machine, process);
  const double gates = transistors / in_family(gate_transistors, process) * static_cast<double>(process.static_power);
  // A clock wire is charged and discharged in each clock.
  const double clock = pixels * static_cast<double>(process.clock_lines) * pitch_of(pixel) * 2 * wire_joules(process) *
                       static_cast<double>(machine.clock_hz);
  if (process.refresh_time == 0) return gates * pw + clock;
  // Each bit is read and written.
  const double refreshed = static_cast<double>(resources.memory_bits) * 2 * access_joules(machine, process);
  return gates * pw + clock + refreshed / (static_cast<double>(process.refresh_time) * ns);
}

}  // namespace

std::optional<PixelArea> pixel_mm2(const Machine& machine, const Process& process) {
  const std::optional<std::uint64_t> logic = machines::logic_transistors(machine, family_of(process));
  if (!logic) return std::nullopt;
  return PixelArea{static_cast<double>(*logic) * transistor_mm2(process),
                   machine.array.memory_bits * bit_mm2(machine.memory_reads, process)};
}

double wire_joules(const Process& process) {
  const double volts = static_cast<double>(process.supply) * 1e-3;
  return static_cast<double>(process.wire_capacitance) * ff * volts * volts / 2;
}

std::vector<ClockPath> clock_paths(const Machine& machine, const Process& process) {
  const std::optional<PixelArea> pixel = pixel_mm2(machine, process);
  if (!pixel) return {};
  const auto registered = static_cast<double>(process.register_delay);
  const auto gate = static_cast<double>(process.gate_delay);
  const auto wire = static_cast<double>(process.wire_delay);
  const double half_side = pitch_of(*pixel) * std::max(machine.array.width, machine.array.height) / 2;
  std::vector<ClockPath> paths{
      {"pixel", registered + pixel_path(machine, process)},
      {"trees", registered + tree_gates(machine) * gate + tree_wires(machine, half_side) * wire},
      {"wire", registered + half_side * wire}};
  if (machines::has_global_or(machine)) {
    const std::uint64_t pixels = std::uint64_t{machine.array.width} * machine.array.height;
    const std::uint64_t lines = std::min(pixels, figure_of(machine, "global_or.fan_in").value_or(pixels));
    paths.push_back({"global OR", registered + levels_of(lines, process.gate_fan_in) * gate});
  }
  return paths;
}

std::optional<Clock> clock_of(const Machine& machine, const Process& process) {
  const std::vector<ClockPath> paths = clock_paths(machine, process);
  if (paths.empty()) return std::nullopt;
  const ClockPath slowest = *std::ranges::max_element(paths, {}, &ClockPath::ps);
  const double hz = std::clamp(1 / (slowest.ps * ps), 1.0, max_hz);
  const double usable = std::max(hz * (1 - refresh_share(machine, process, hz)), 1.0);
  return Clock{static_cast<std::uint64_t>(std::llround(hz)), slowest, static_cast<std::uint64_t>(std::llround(usable))};
}

std::optional<double> machine_mm2(const Machine& machine, const machines::Resources& resources,
                                  const Process& process) {
  const std::optional<PixelArea> pixel = pixel_mm2(machine, process);
  if (!pixel) return std::nullopt;
  const std::uint64_t pixel_bits = resources.processors * machine.array.memory_bits;
  const double buffer_bits = static_cast<double>(resources.memory_bits - std::min(pixel_bits, resources.memory_bits));
  return static_cast<double>(resources.processors) * (pixel->logic + pixel->memory) +
         buffer_bits * bit_mm2(1, process) + shared_transistors(machine, process) * transistor_mm2(process);
}

std::uint64_t pixel_clocks(const isa::Program& program, const Machine& machine, std::span<const machines::Skip> skips) {
  std::uint64_t sum = 0;
  auto skip = skips.begin();
  for (std::uint32_t segment = 0; segment < program.segments.size(); ++segment) {
    const isa::Segment& one = program.segments[segment];
    std::uint64_t clocks = 0;
    for (std::uint32_t i = 0; i < one.instructions.size(); ++i) {
      clocks += machine.kind->clocks(one.instructions[i], machine);
      if (skip == skips.end() || *skip != machines::Skip{segment, i}) continue;
      ++skip;
      i += static_cast<std::uint32_t>(one.instructions[i].constant);
    }
    sum += clocks * one.region.width * one.region.height;
  }
  return sum;
}

std::optional<double> frame_joules(const Machine& machine, const machines::Resources& resources, const FrameWork& work,
                                   const Process& process) {
  const std::optional<PixelArea> pixel = pixel_mm2(machine, process);
  if (!pixel) return std::nullopt;
  return static_cast<double>(work.pixel_clocks) * pixel_joules(machine, *pixel, process) +
         idle_watts(machine, resources, *pixel, process) * work.seconds;
}

}  // namespace csgsim::process

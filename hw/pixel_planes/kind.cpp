#include "hw/pixel_planes/kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "hw/base/error.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/evaluator_check.h"
#include "hw/machines/shared_figures.h"

namespace csgsim::pixel_planes {

namespace {

using machines::Machine;
namespace shared = machines::shared;

constexpr auto schema = std::to_array<machines::FigureSchema>({
    shared::array_width,
    shared::array_height,
    shared::memory_bits,
    shared::clock_frequency,
    shared::memory_reads,
    shared::memory_writes,
    shared::alu_bits,
    machines::own_figure<Figures, &Figures::has_global_or>("global_or.present", "lines", 0, 1,
                                                           "wired OR of all enable bits, fed back to the controller"),
    machines::or_ideal(machines::own_figure<Figures, &Figures::or_fan_in>(
                           "global_or.fan_in", "lines", 2, 65536,
                           "inputs of each gate of that OR, followed by a register; ideal: it settles within a clock"),
                       0),
    machines::own_figure<Figures, &Figures::scan_out_pixels>("scan_out.pixels", "pixels", 1, isa::max_array_side,
                                                             "pixels shifted out of the video port per clock"),
    machines::own_figure<Figures, &Figures::scan_out_port>("scan_out.port", "", 0, 1,
                                                           "where a row's colour bits are read", scan_out_port_names),
    machines::own_figure<Figures, &Figures::scan_out_buffers>(
        "scan_out.buffers", "pictures", 1, 2,
        "pictures in pixel memory; with 2, a finished one is copied and displayed while the next is drawn"),
    shared::level_latency,
    shared::evaluator_degree,
    shared::evaluator_bits,
    shared::register_levels,
    shared::clear_clocks,
    shared::link_width,
    shared::link_word_clocks,
    shared::link_fifo_depth,
    shared::link_latency,
    shared::host_processor,
    shared::host_count,
});

}  // namespace

void Kind::complete(Machine& machine) const {
  machines::check_evaluator(machine);
  machine.picture = {machine.array.width, machine.array.height};
}

void Kind::set_picture(Machine& machine, machines::Size size) const {
  machine.array.width = size.width;
  machine.array.height = size.height;
}

bool Kind::has_global_or(const Machine& machine) const { return figures_of(machine).has_global_or; }

std::vector<isa::Region> Kind::regions(const Machine& machine) const {
  return {{0, 0, machine.array.width, machine.array.height}};
}

isa::Field Kind::second_buffer(std::uint32_t colour_bits, const Machine& machine) const {
  if (figures_of(machine).scan_out_buffers < 2) return {};
  const std::uint32_t width = std::min(colour_bits, machine.array.memory_bits);
  return {static_cast<std::uint16_t>(machine.array.memory_bits - width), static_cast<std::uint16_t>(width)};
}

namespace {

bool overlaps(const isa::Instruction& instruction, const isa::Field& shown) {
  return std::ranges::any_of(instruction.fields, [&](const isa::Field& field) { return field.overlaps(shown); });
}

[[noreturn]] void refuse(std::string_view what, const isa::Field& shown, const Machine& machine) {
  throw InputError(
      fmt::format("{} overlaps the {} bits from bit {} on, from which {} displays a picture while it draws the "
                  "next; compile the model for this machine, or use a machine with scan_out.buffers = 1",
                  what, shown.width, shown.base, machine.name));
}

}  // namespace

/// Segments may have any size: each is drawn in the corner of the array.
void Kind::check(const isa::Program& program, const Machine& machine) const {
  const isa::Field colour = isa::frame_header(program).colour;
  const isa::Field shown = second_buffer(colour.width, machine);
  if (shown.width == 0) return;
  if (colour.overlaps(shown)) refuse("the colour field", shown, machine);
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    const std::vector<isa::Instruction>& instructions = program.segments[s].instructions;
    const auto found = std::ranges::find_if(instructions, [&](const auto& one) { return overlaps(one, shown); });
    if (found == instructions.end()) continue;
    refuse(fmt::format("segment {}, instruction {}: {}", s, found - instructions.begin(), isa::name_of(found->opcode)),
           shown, machine);
  }
}

machines::Resources Kind::resources(const Machine& machine, const isa::FrameHeader& /*header*/) const {
  const std::uint64_t processors = std::uint64_t{machine.array.width} * machine.array.height;
  return {processors, processors * machine.array.memory_bits};
}

const Kind kind{"frame-buffer", schema};

}  // namespace csgsim::pixel_planes

#include "hw/pixel_planes/kind.h"

#include <array>

#include "hw/machines/shared_figures.h"
#include "hw/pixel_planes/figures.h"
#include "hw/pixel_planes/timing.h"

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
                                                           "wired OR of all enable bits, back to the controller"),
    machines::or_ideal(machines::own_figure<Figures, &Figures::or_fan_in>(
                           "global_or.fan_in", "lines", 2, 65536,
                           "inputs of a gate of that OR, with a register behind each; ideal: it settles in a clock"),
                       0),
    machines::own_figure<Figures, &Figures::scan_out_pixels>("scan_out.pixels", "pixels", 1, isa::max_array_side,
                                                             "that leave the video port in a clock"),
    machines::own_figure<Figures, &Figures::scan_out_port>("scan_out.port", "", 0, 1,
                                                           "where a row's colour bits are read", scan_out_port_names),
    shared::level_latency,
    shared::clear_clocks,
    shared::link_width,
    shared::link_word_clocks,
    shared::link_fifo_depth,
    shared::link_latency,
});

std::any own() { return Figures{}; }

void complete(Machine& machine) { machine.picture = {machine.array.width, machine.array.height}; }

void set_picture(Machine& machine, machines::Size size) {
  machine.array.width = size.width;
  machine.array.height = size.height;
}

bool has_global_or(const Machine& machine) { return machines::own<Figures>(machine).has_global_or; }

std::vector<isa::Region> regions(const Machine& machine) { return {{0, 0, machine.array.width, machine.array.height}}; }

machines::Resources resources(const Machine& machine, const isa::FrameHeader& /*header*/) {
  const std::uint64_t processors = std::uint64_t{machine.array.width} * machine.array.height;
  return {processors, processors * machine.array.memory_bits};
}

}  // namespace

const machines::Kind kind{
    .name = "frame-buffer",
    .schema = schema,
    .own = own,
    .complete = complete,
    .set_picture = set_picture,
    .has_global_or = has_global_or,
    .regions = regions,
    .clocks = instruction_clocks,
    .time = time_frame,
    .resources = resources,
};

}  // namespace csgsim::pixel_planes

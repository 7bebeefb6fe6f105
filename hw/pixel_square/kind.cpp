#include "hw/pixel_square/kind.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "hw/base/error.h"
#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/machines/evaluator_check.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/shared_figures.h"
#include "hw/pixel_square/screen.h"
#include "hw/pixel_square/storage_check.h"
#include "hw/pixel_square/timing_division.h"

namespace csgsim::pixel_square {

namespace {

using machines::Machine;
using machines::max_parameter_clocks;
using machines::own_figure;
namespace shared = machines::shared;

constexpr auto schema = std::to_array<machines::FigureSchema>({
    shared::array_width,
    shared::array_height,
    shared::memory_bits,
    shared::picture_width,
    shared::picture_height,
    shared::clock_frequency,
    shared::memory_reads,
    shared::memory_writes,
    shared::alu_bits,
    shared::level_latency,
    shared::evaluator_degree,
    shared::evaluator_bits,
    shared::register_levels,
    shared::clear_clocks,
    shared::link_width,
    shared::link_word_clocks,
    shared::link_fifo_depth,
    shared::link_latency,
    own_figure<Figures, &Figures::has_global_or>("global_or.present", "lines", 0, 1,
                                                 "wired OR of a renderer's enable bits, read by its controller"),
    machines::or_ideal(own_figure<Figures, &Figures::or_fan_in>(
                           "global_or.fan_in", "lines", 2, 65536,
                           "inputs of a gate of the global OR, with a register after each gate; ideal: a single gate"),
                       0),
    own_figure<Figures, &Figures::renderers>("renderers.count", "renderers", 1, 1024, "squares drawn in parallel"),
    own_figure<Figures, &Figures::buffers>("renderers.buffers", "squares", 1, 2,
                                           "finished or unfinished squares that a renderer holds"),
    machines::or_ideal(own_figure<Figures, &Figures::move_bits>(
                           "renderers.move_bits", "bit planes", 1, isa::max_field_width,
                           "bit planes of a finished square moved to the second buffer per clock"),
                       all_planes),
    machines::or_ideal(own_figure<Figures, &Figures::latch_bits>(
                           "renderers.latch_bits", "bit planes", 1, isa::max_field_width,
                           "bit planes of a row of a finished square latched per clock, with one buffer"),
                       no_latch),
    own_figure<Figures, &Figures::backing_bits>(
        "backing.bits", "bits", 0, 1U << 20U,
        "bits per pixel of a memory behind each renderer where finished squares wait, instead of a second buffer"),
    machines::or_ideal(
        own_figure<Figures, &Figures::backing_width>("backing.width", "bits", 1, 1U << 20U,
                                                     "bits of a finished square moved to the backing memory per clock"),
        all_planes),
    own_figure<Figures, &Figures::port_bits>(
        "port.width", "bits", 1, 65536,
        "bits of a colour word, which a bank of the frame buffer stores or clears per clock"),
    own_figure<Figures, &Figures::port_fifo_depth>("port.fifo_depth", "words", 1, max_parameter_clocks,
                                                   "depth of each FIFO before the frame buffer"),
    own_figure<Figures, &Figures::banks>(
        "frame_buffer.banks", "banks", 1, 1024,
        "banks that each store one word per clock; the picture's rows are interleaved over them"),
    own_figure<Figures, &Figures::pictures>(
        "frame_buffer.pictures", "pictures", 1, 2,
        "pictures held; with 2, one is shown while the other is drawn, so the screen never delays drawing"),
    machines::or_ideal(
        own_figure<Figures, &Figures::refresh_rate>("refresh.rate", "Hz", 1, 1000, "pictures shown per second"),
        not_shown),
    own_figure<Figures, &Figures::refresh_bits>("refresh.bits", "bits", 1, 1U << 24U,
                                                "bits of the picture that the screen reads per turn"),
    own_figure<Figures, &Figures::refresh_clocks>("refresh.clocks", "clocks", 1, 1000,
                                                  "clocks for which a turn of the screen occupies a bank"),
    own_figure<Figures, &Figures::order>("divider.order", "", 0, 2, "order in which squares are drawn",
                                         square_order_names),
    own_figure<Figures, &Figures::divider>("divider.kind", "", 0, 2,
                                           "host: the host divides the model a frame ahead; corners: the machine does; "
                                           "processors: graphics processors do, a frame ahead",
                                           divider_kind_names),
    own_figure<Figures, &Figures::processors>("processors.count", "processors", 1, 1024,
                                              "graphics processors that divide the model, square by square"),
    machines::or_ideal(
        own_figure<Figures, &Figures::ring_channels>("ring.channels", "channels", 1, 4096,
                                                     "words that the ring of processors carries concurrently"),
        all_channels),
    own_figure<Figures, &Figures::ring_bits>("ring.width", "bits", 1, isa::LinkWord::max_bits,
                                             "bits of a word of commands or colours on the ring"),
    own_figure<Figures, &Figures::ring_word_clocks>("ring.word_clocks", "clocks", 1, max_parameter_clocks,
                                                    "clocks between two words on a channel of the ring"),
    own_figure<Figures, &Figures::dividers>("divider.count", "dividers", 1, 64,
                                            "with corners: dividers, to which groups of squares are assigned "
                                            "round-robin, each with the following resources"),
    own_figure<Figures, &Figures::levels>("divider.levels", "levels", 1, 2,
                                          "with corners: 2 divides groups of squares first"),
    own_figure<Figures, &Figures::group_side>("divider.group", "squares", 1, 1024, "side of a group, in squares"),
    own_figure<Figures, &Figures::list_entries>(
        "divider.list", "entries", 0, 1'000'000'000,
        "capacity of the list of primitives and half-spaces that remain for a group"),
    own_figure<Figures, &Figures::model_bits>(
        "divider.memory", "bits", 1, 4'000'000'000,
        "memory for the model; if the model does not fit, its planes stay on the host"),
    machines::or_ideal(own_figure<Figures, &Figures::record_bits>("divider.port", "bits", 1, isa::LinkWord::max_bits,
                                                                  "bits of a model record read per clock"),
                       isa::LinkWord::max_bits),
    own_figure<Figures, &Figures::halfspaces>("divider.halfspaces", "half-spaces", 1, 1'000'000'000,
                                              "half-spaces held for a surface; the rest go to the model memory"),
    own_figure<Figures, &Figures::nodes>("divider.nodes", "nodes", 1, 1'000'000'000,
                                         "tree nodes held for a surface; the rest go to the model memory"),
    own_figure<Figures, &Figures::store_words>(
        "divider.store", "words", 1, 1'000'000'000,
        "capacity, in link words, of the store for commands that wait for the sender"),
    machines::or_ideal(
        own_figure<Figures, &Figures::box_clocks>("divider.box_clocks", "clocks", 0, max_parameter_clocks,
                                                  "clocks to compare the box of a primitive with a square's"),
        0),
    machines::or_ideal(
        own_figure<Figures, &Figures::halfspace_clocks>("divider.halfspace_clocks", "clocks", 0, max_parameter_clocks,
                                                        "clocks to test a half-space at four corners"),
        0),
    machines::or_ideal(own_figure<Figures, &Figures::cell_clocks>(
                           "divider.cell_clocks", "clocks", 0, max_parameter_clocks,
                           "clocks to compare a half-space of a side with the leaders of a cell"),
                       0),
    machines::or_ideal(
        own_figure<Figures, &Figures::node_clocks>("divider.node_clocks", "clocks", 0, max_parameter_clocks,
                                                   "clocks to visit a node of the tree"),
        0),
    machines::or_ideal(
        own_figure<Figures, &Figures::linear_clocks>(
            "divider.linear_clocks", "clocks", 0, max_parameter_clocks,
            "clocks to compute constant, width and shift of a linear instruction, in addition to its words"),
        0),
    shared::host_processor,
    shared::host_count,
});

}  // namespace

void Kind::complete(Machine& machine) const { machines::check_evaluator(machine); }

/// Graphics processors compile the model themselves.
std::uint32_t Kind::host_processor_count(const Machine& machine) const {
  const Figures& figures = figures_of(machine);
  return figures.divider == DividerKind::processors ? figures.processors : machine.host.count;
}

std::optional<machines::Division> Kind::division(const Machine& machine) const {
  const Figures& figures = figures_of(machine);
  if (figures.divider != DividerKind::corners) return std::nullopt;
  return machines::Division{figures.levels == 1 ? 0 : figures.group_side, figures.list_entries};
}

std::optional<Machine> Kind::subdivided(const Machine& machine, std::uint32_t levels, machines::Parts parts) const {
  const std::uint32_t parts_a_side = parts == machines::Parts::segments ? 1 : 4;
  Machine cut = machine;
  cut.array.width = quotient_up(machine.picture.width, parts_a_side << (levels + 1) / 2);
  cut.array.height = quotient_up(machine.picture.height, parts_a_side << levels / 2);
  return cut;
}

namespace {

/// Checks the limits of a divider in the machine.
void check_display_model(const isa::Program& program, const Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  if (figures.divider != DividerKind::corners) return;
  if (program.display_model.empty()) {
    throw InputError(fmt::format(
        "the Program has no display model for {} to divide; compile the model for this machine", machine.name));
  }
  check_storage(program, machine);
  check_countable(program, machine);
}

}  // namespace

namespace {

/// Rejects instructions whose answer the host needs: a renderer's answer reaches only its controller.
void check_answers(const isa::Program& program, const Machine& machine) {
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    const std::vector<isa::Instruction>& instructions = program.segments[s].instructions;
    const auto found = std::ranges::find(instructions, isa::Opcode::global_or, &isa::Instruction::opcode);
    if (found == instructions.end()) continue;
    throw InputError(
        fmt::format("segment {}, instruction {}: global_or returns an answer to the host, but the renderers of {} "
                    "cannot send one; omit global_or, or use a machine of kind frame-buffer, such as pixel-planes-4",
                    s, found - instructions.begin(), machine.name));
  }
}

/// Rejects a colour wider than the backing memory.
void check_backing(const isa::FrameHeader& header, const Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  if (figures.backing_bits == no_backing || header.colour.width <= figures.backing_bits) return;
  throw InputError(
      fmt::format("a pixel has {} bits of colour, but the backing memory of {} holds {}; increase "
                  "backing.bits, or set it to 0 to use a second buffer",
                  header.colour.width, machine.name, figures.backing_bits));
}

}  // namespace

void Kind::check(const isa::Program& program, const Machine& machine) const {
  check_answers(program, machine);
  check_backing(isa::frame_header(program), machine);
  machines::check_parts(program, machine);
  check_screen(isa::frame_header(program), machine);
  check_display_model(program, machine);
}

bool Kind::has_global_or(const Machine& machine) const {
  return figures_of(machine).has_global_or && figures_of(machine).divider != DividerKind::corners;
}

std::uint64_t Kind::clocks(const isa::Instruction& instruction, const Machine& machine) const {
  const std::uint64_t steps = machines::bit_serial_clocks(instruction, machine);
  if (!isa::needs_global_or(instruction.opcode) || figures_of(machine).or_fan_in == 0) return steps;
  std::uint64_t levels = 0;
  const std::uint64_t pixels = std::uint64_t{machine.array.width} * machine.array.height;
  for (std::uint64_t lines = pixels; lines > 1;
       lines = quotient_up(lines, std::uint64_t{figures_of(machine).or_fan_in}))
    ++levels;
  return steps + levels;
}

namespace {

/// Memory of all dividers, without the tree's nodes and the leaders of cells.
std::uint64_t divider_memory_bits(const Machine& machine) {
  constexpr std::uint64_t list_entry_bits = 32;
  const Figures& figures = machines::kind_figures<Figures>(machine);
  if (figures.divider != DividerKind::corners) return 0;
  const std::uint64_t list = figures.levels == 2 ? figures.list_entries * list_entry_bits : 0;
  return figures.dividers * (figures.model_bits + list + figures.halfspaces * halfspace_entry_bits(figures) +
                             figures.nodes * node_entry_bits + std::uint64_t{figures.store_words} * machine.link.width);
}

}  // namespace

machines::Resources Kind::resources(const Machine& machine, const isa::FrameHeader& header) const {
  const std::uint64_t processors =
      std::uint64_t{machine.array.width} * machine.array.height * figures_of(machine).renderers;
  const std::uint64_t pixels = std::uint64_t{header.shape.width} * header.shape.height;
  return {processors, processors * (std::uint64_t{machine.array.memory_bits} + figures_of(machine).backing_bits) +
                          figures_of(machine).pictures * pixels * header.colour.width + divider_memory_bits(machine)};
}

const Kind kind{"pixel-square", schema};

}  // namespace csgsim::pixel_square

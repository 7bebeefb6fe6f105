#include "hw/multi_processor/kind.h"

#include <algorithm>
#include <array>

#include "hw/base/quotient.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/shared_figures.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/processor_clocks.h"
#include "hw/multi_processor/regions.h"
#include "hw/multi_processor/timing.h"

namespace csgsim::multi_processor {

namespace {

using machines::FigureSchema;
using machines::Machine;
using machines::max_parameter_clocks;
using machines::or_priced;
using machines::own_figure;
namespace shared = machines::shared;

constexpr std::int64_t max_nodes_per_side = 16;
constexpr std::int64_t max_levels = 20;
constexpr std::int64_t max_memory_words = std::int64_t{1} << 31U;

template <auto part, auto member>
constexpr FigureSchema part_clocks(std::string_view key, std::string_view meaning) {
  return own_figure<Figures, part, member>(key, "clocks", 0, max_parameter_clocks, meaning);
}

constexpr auto schema = std::to_array<FigureSchema>({
    machines::figure<&Machine::array, &isa::ArrayShape::width>("nodes.columns", "nodes", 1, max_nodes_per_side,
                                                               "nodes per row of the array"),
    machines::figure<&Machine::array, &isa::ArrayShape::height>("nodes.rows", "nodes", 1, max_nodes_per_side,
                                                                "rows of nodes"),
    machines::figure<&Machine::array, &isa::ArrayShape::memory_bits>(
        "pixel.memory_bits", "bits", 1, isa::max_memory_bits, "memory that a node keeps per pixel"),
    shared::picture_width,
    shared::picture_height,
    shared::clock_frequency,
    own_figure<Figures, &Figures::levels>("subdivision.levels", "halvings", 0, max_levels,
                                          "halvings of the picture into segments"),
    own_figure<Figures, &Figures::order>("rendering.order", "", 0, 2,
                                         "loop order of a node over pixels and instructions", rendering_order_names),
    own_figure<Figures, &Figures::host, &HostLink::width>("host.link_width", "bits", 1, isa::LinkWord::max_bits,
                                                          "bits of a word of the host's link"),
    own_figure<Figures, &Figures::host, &HostLink::word_clocks>(
        "host.link_word_clocks", "clocks", 1, max_parameter_clocks, "clocks between two words of the host's link"),
    part_clocks<&Figures::host, &HostLink::latency>("host.link_latency",
                                                    "clocks from the start of the frame to its first word"),
    own_figure<Figures, &Figures::display_processor, &ProcessorFigures::type>(
        "display.processor", "", 0, std::int64_t{machines::processor_names.size()} - 1,
        "type of the display processor, whose prices count clocks of the machine", machines::processor_names),
    or_priced(own_figure<Figures, &Figures::display_processor, &ProcessorFigures::compiler_factor>(
        "display.compiler_factor", "thousandths", 100, 100'000,
        "clocks of a compiled program per thousand clocks of a hand-written one")),
    own_figure<Figures, &Figures::display_memory_words>("display.memory_words", "words", 1, max_memory_words,
                                                        "memory for the model and what remains of it in a segment"),
    or_priced(own_figure<Figures, &Figures::transform_clocks>(
        "display.transform_clocks", "clocks", 0, max_parameter_clocks, "clocks to transform a plane of the model")),
    or_priced(part_clocks<&Figures::display_tests, &TestClocks::primitive>(
        "display.primitive_clocks", "clocks to compare the bounds of a primitive with a segment")),
    or_priced(part_clocks<&Figures::display_tests, &TestClocks::halfspace>(
        "display.halfspace_clocks", "clocks to test a half-space at the corners of a segment")),
    or_priced(part_clocks<&Figures::display_tests, &TestClocks::cell>(
        "display.cell_clocks", "clocks to compare a half-space of a side with the leaders of a cell")),
    own_figure<Figures, &Figures::divides_ahead>("display.divides_ahead", "segments", 0, 1,
                                                 "segments divided ahead, while the nodes work on the previous one"),
    own_figure<Figures, &Figures::lists>("lists.kind", "", 0, 1, "form of the lists that nodes send to each other",
                                         list_kind_names),
    shared::link_width,
    shared::link_word_clocks,
    shared::link_latency,
    own_figure<Figures, &Figures::barrier_clocks>("barrier.clocks", "clocks", 0, max_parameter_clocks,
                                                  "clocks from the last node's arrival to the release of all nodes"),
    machines::or_ideal(own_figure<Figures, &Figures::refresh, &RefreshFigures::rate>(
                           "refresh.rate", "Hz", 1, 1000, "pictures shown per second; ideal: refresh takes no clocks"),
                       0),
    own_figure<Figures, &Figures::refresh, &RefreshFigures::bits>(
        "refresh.bits", "bits", 1, 1U << 24U, "bits of each node's pixels that the screen reads per turn"),
    own_figure<Figures, &Figures::refresh, &RefreshFigures::clocks>(
        "refresh.clocks", "clocks", 1, 1000, "clocks for which such a turn occupies the memories of all nodes"),
    own_figure<Figures, &Figures::node_processor, &ProcessorFigures::type>(
        "node.processor", "", 0, std::int64_t{machines::processor_names.size()} - 1,
        "type of the nodes, whose prices count clocks of the machine", machines::processor_names),
    or_priced(own_figure<Figures, &Figures::node_processor, &ProcessorFigures::compiler_factor>(
        "node.compiler_factor", "thousandths", 100, 100'000,
        "clocks of a compiled program per thousand clocks of a hand-written one")),
    own_figure<Figures, &Figures::word_bits>("node.word_bits", "bits", 1, 64, "bits of a node's word"),
    own_figure<Figures, &Figures::memory_words>("node.memory_words", "words", 1, max_memory_words,
                                                "memory for the tree, a segment's half-spaces, and lists"),
    or_priced(part_clocks<&Figures::operations, &OperationClocks::read>("node.read_clocks",
                                                                        "clocks to read a word of memory")),
    or_priced(part_clocks<&Figures::operations, &OperationClocks::write>("node.write_clocks",
                                                                         "clocks to write a word of memory")),
    or_priced(part_clocks<&Figures::operations, &OperationClocks::add>("node.add_clocks", "clocks to add a word")),
    or_priced(part_clocks<&Figures::operations, &OperationClocks::compare>("node.compare_clocks",
                                                                           "clocks to compare a word")),
    or_priced(part_clocks<&Figures::operations, &OperationClocks::logic>("node.logic_clocks",
                                                                         "clocks of a logic operation on a word")),
    or_priced(part_clocks<&Figures::operations, &OperationClocks::multiply>("node.multiply_clocks",
                                                                            "clocks to multiply two words")),
    or_priced(part_clocks<&Figures::operations, &OperationClocks::shift>(
        "node.shift_clocks", "clocks to shift a word, in addition to those per bit position")),
    or_priced(machines::or_ideal(
        part_clocks<&Figures::operations, &OperationClocks::shift_bit>(
            "node.shift_bit_clocks", "clocks of a shift per bit position; ideal: all positions at once"),
        0)),
    or_priced(machines::or_ideal(
        own_figure<Figures, &Figures::field_clocks>(
            "node.field_clocks", "clocks", 0, max_parameter_clocks,
            "clocks to extract a number from packed bits, in addition to its shifts and mask; ideal: each number "
            "arrives in separate words"),
        unpacked)),
    own_figure<Figures, &Figures::branches, &BranchFigures::over>(
        "node.branches", "", 0, 1, "work without effect at a pixel that nodes branch over", branches_names),
    or_priced(part_clocks<&Figures::branches, &BranchFigures::taken>("node.branch_clocks", "clocks of a taken branch")),
    or_priced(part_clocks<&Figures::branches, &BranchFigures::passed>("node.no_branch_clocks",
                                                                      "clocks of a branch not taken")),
    own_figure<Figures, &Figures::chain, &ChainFigures::program>("node.program", "", 0, 1, "how a node executes a list",
                                                                 node_program_names),
    or_priced(part_clocks<&Figures::chain, &ChainFigures::link>(
        "node.chain_clocks",
        "clocks to append an instruction to the chain of a native program, in addition to its operands")),
    or_priced(part_clocks<&Figures::chain, &ChainFigures::call>(
        "node.call_clocks", "clocks to call an instruction of a native program and return")),
    or_priced(part_clocks<&Figures::loop, &LoopClocks::pixel>(
        "node.pixel_loop_clocks", "clocks per iteration of the loop over the pixels of a row")),
    or_priced(part_clocks<&Figures::loop, &LoopClocks::row>("node.row_loop_clocks",
                                                            "clocks per iteration of the loop over rows")),
    or_priced(part_clocks<&Figures::loop, &LoopClocks::instruction>(
        "node.instruction_loop_clocks",
        "clocks per iteration of the loop over instructions, in addition to reading one")),
    or_priced(part_clocks<&Figures::node_tests, &TestClocks::primitive>(
        "node.primitive_clocks", "clocks to compare the bounds of a primitive with a subsegment")),
    or_priced(part_clocks<&Figures::node_tests, &TestClocks::halfspace>(
        "node.halfspace_clocks", "clocks to test a half-space at the corners of a subsegment")),
    or_priced(part_clocks<&Figures::node_tests, &TestClocks::cell>(
        "node.cell_clocks", "clocks to compare a half-space of a side with the leaders of a cell")),
    or_priced(part_clocks<&Figures::node_tests, &TestClocks::tree_node>("node.tree_clocks",
                                                                        "clocks to visit a node of the tree")),
    or_priced(part_clocks<&Figures::node_tests, &TestClocks::instruction>(
        "node.list_clocks", "clocks to append an instruction to the list")),
    or_priced(own_figure<Figures, &Figures::number_clocks>(
        "node.number_clocks", "clocks", 0, max_parameter_clocks,
        "clocks to append an instruction with a half-space number to the list")),
    shared::host_processor,
    shared::host_count,
});

}  // namespace

void Kind::complete(Machine& machine) const { compute_processor_clocks(machines::kind_figures<Figures>(machine)); }

std::optional<machines::Division> Kind::division(const Machine& machine) const {
  return machines::Division{.list_entries = ~std::uint64_t{0},
                            .groups = picture_segments(machine.picture, figures_of(machine).levels)};
}

std::optional<Machine> Kind::subdivided(const Machine& machine, std::uint32_t levels, machines::Parts parts) const {
  Machine cut = machine;
  machines::kind_figures<Figures>(cut).levels = levels;
  if (parts == machines::Parts::segments) cut.array.width = cut.array.height = 1;
  return cut;
}

void Kind::check(const isa::Program& program, const Machine& machine) const {
  machines::check_parts(program, machine);
  check_fits(program, machine);
}

bool Kind::depends_on_pixels(const Machine& machine) const {
  return figures_of(machine).branches.over == Branches::pixels;
}

std::uint64_t Kind::clocks(const isa::Instruction& instruction, const Machine& machine) const {
  return pixel_clocks(instruction, machine);
}

machines::PixelClocks Kind::clocks_at_pixels(const isa::Segment& segment, std::size_t index, const Machine& machine,
                                             const machines::PixelActivity* pixel_activity) const {
  return subsegment_pixel_clocks(segment, index, machine, pixel_activity);
}

machines::Resources Kind::resources(const Machine& machine, const isa::FrameHeader& header) const {
  const Figures& figures = figures_of(machine);
  const std::uint64_t nodes = std::uint64_t{machine.array.width} * machine.array.height;
  std::uint64_t working_pixels = 0;  // maximum over the subsegments of the pixels of one node
  Machine drawing = machine;
  drawing.picture = {header.shape.width, header.shape.height};
  for (const isa::Region& part : regions(drawing)) {
    const std::uint64_t columns = quotient_up(part.width, machine.array.width);
    const std::uint64_t rows = quotient_up(part.height, machine.array.height);
    working_pixels = std::max(working_pixels, columns * rows);
  }
  const std::uint64_t pixels = std::uint64_t{header.shape.width} * header.shape.height;
  const std::uint64_t node_bits =
      std::uint64_t{figures.memory_words} * figures.word_bits + working_pixels * (machine.array.memory_bits + 1);
  const std::uint64_t display_bits = std::uint64_t{figures.display_memory_words} * figures.word_bits;
  return {nodes, display_bits + nodes * node_bits + pixels * header.colour.width};
}

const Kind kind{"multi-processor", schema};

}  // namespace csgsim::multi_processor

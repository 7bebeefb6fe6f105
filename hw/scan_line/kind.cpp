#include "hw/scan_line/kind.h"

#include <fmt/format.h>

#include <array>

#include "hw/base/error.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/shared_figures.h"

namespace csgsim::scan_line {

namespace {

using machines::Machine;
using machines::own_figure;
namespace shared = machines::shared;

constexpr auto schema = std::to_array<machines::FigureSchema>({
    machines::figure<&Machine::array, &isa::ArrayShape::width>("cells.count", "cells", 1, isa::max_array_side,
                                                               "cells of a chain, one per pixel of a line"),
    own_figure<Figures, &Figures::words>("cells.words", "words", 1, 64, "memory words of a cell"),
    own_figure<Figures, &Figures::word_bits>("cells.word_bits", "bits", 1, 64,
                                             "width of the cells' words, and of the adder of the running sum"),
    machines::or_ideal(
        own_figure<Figures, &Figures::alu_bits>("cells.alu_bits", "bits", 1, 64,
                                                "bits that a cell's ALU processes per clock, at most a word"),
        0),
    machines::or_ideal(own_figure<Figures, &Figures::shift_bits>(
                           "cells.shift_bits", "bits", 1, 64, "bits by which a cell's shifter moves a word per clock"),
                       0),
    machines::or_ideal(own_figure<Figures, &Figures::ports>("cells.ports", "words", 1, 64,
                                                            "words of a cell's memory read or written per clock"),
                       0),
    shared::evaluator_degree,
    own_figure<Figures, &Figures::network>(
        "evaluator.network", "", 0, 1,
        "chain: each cell adds and passes the sum on; trees: adders deliver the value to all cells", network_names),
    own_figure<Figures, &Figures::tree_bits>("evaluator.bits", "bits", 1, 64,
                                             "with trees: bits delivered to each cell per clock, at most a word"),
    shared::clear_clocks,
    shared::picture_width,
    shared::picture_height,
    shared::clock_frequency,
    own_figure<Figures, &Figures::chains>("chains.count", "chains", 1, 1024, "chains that draw lines in parallel"),
    shared::link_width,
    shared::link_word_clocks,
    shared::link_fifo_depth,
    shared::link_latency,
    machines::or_ideal(own_figure<Figures, &Figures::bucket_clocks>(
                           "host.bucket_clocks", "clocks", 0, machines::max_parameter_clocks,
                           "clocks to sort a primitive of the picture into the bucket of its first line"),
                       0),
    machines::or_ideal(
        own_figure<Figures, &Figures::active_clocks>(
            "host.active_clocks", "clocks", 0, machines::max_parameter_clocks,
            "clocks to visit a primitive that enters, stays in or leaves the active list, once per line"),
        0),
    machines::or_ideal(own_figure<Figures, &Figures::instruction_clocks>(
                           "host.instruction_clocks", "clocks", 0, machines::max_parameter_clocks,
                           "clocks to prepare an instruction of a line: transformation, pruning, coefficients"),
                       0),
    own_figure<Figures, &Figures::refresh_hz>("refresh.rate", "Hz", 1, 1000, "fields shown per second"),
    own_figure<Figures, &Figures::interlaced>("refresh.interlaced", "", 0, 1,
                                              "1: a field consists of every other line"),
    shared::host_processor,
    shared::host_count,
});

}  // namespace

void Kind::set_picture(Machine& machine, machines::Size size) const {
  if (size.width <= machine.array.width) return;
  throw InputError(
      fmt::format("a line of {} pixels exceeds the {} cells of {}; use a narrower picture, or increase cells.count in "
                  "the machine file",
                  size.width, machine.array.width, machine.name));
}

void Kind::complete(Machine& machine) const {
  const Figures& figures = figures_of(machine);
  machine.array.height = 1;
  machine.array.memory_bits = figures.words * figures.word_bits;
}

std::vector<isa::Region> Kind::regions(const Machine& machine) const {
  std::vector<isa::Region> all;
  const std::uint32_t step = figures_of(machine).interlaced ? 2 : 1;
  for (std::uint32_t first = 0; first < step; ++first) {
    for (std::uint32_t y = first; y < machine.picture.height; y += step)
      all.push_back({0, y, machine.picture.width, 1});
  }
  return all;
}

void Kind::check(const isa::Program& program, const Machine& machine) const { machines::check_parts(program, machine); }

machines::Resources Kind::resources(const Machine& machine, const isa::FrameHeader& /*header*/) const {
  const std::uint64_t cells = std::uint64_t{machine.array.width} * figures_of(machine).chains;
  return {cells, cells * machine.array.memory_bits};
}

const Kind kind{"scan-line", schema};

}  // namespace csgsim::scan_line

#include "hw/bit_serial_memory/kind.h"

#include <fmt/format.h>

#include <array>
#include <string>

#include "hw/base/error.h"
#include "hw/bit_serial_memory/row_map.h"
#include "hw/bit_serial_memory/slots.h"
#include "hw/machines/figure_error.h"
#include "hw/machines/runs_on.h"
#include "hw/machines/shared_figures.h"

namespace csgsim::bit_serial_memory {

namespace {

using machines::Machine;
using machines::or_ideal;
using machines::own_figure;
namespace shared = machines::shared;

constexpr std::int64_t most_fj = 1'000'000'000'000;

constexpr auto schema = std::to_array<machines::FigureSchema>({
    shared::picture_width,
    shared::picture_height,
    shared::memory_bits,
    shared::clock_frequency,
    own_figure<Figures, &Figures::design>(
        "logic.design", "", 0, 2,
        "and-or-not and majority: three rows at a time; latches: gates at each sense amplifier", design_names),
    own_figure<Figures, &Figures::expressions>(
        "logic.expressions", "", 0, 2,
        "rows: summed of stored x and y; planes: worked out by the host; trees: brought by multiplier trees",
        expression_names),
    shared::evaluator_degree,
    own_figure<Figures, &Figures::enable_latch>("logic.enable", "latches", 0, 1,
                                                "of a column, without which its rows are not written"),
    own_figure<Figures, &Figures::has_wired_or>("global_or.present", "lines", 0, 1,
                                                "wired OR of all enable bits; without it the host reads them"),
    own_figure<Figures, &Figures::chips>("chips.count", "chips", 1, 64, "that work in step"),
    own_figure<Figures, &Figures::banks>("chips.banks", "banks", 1, 64, "of a chip"),
    own_figure<Figures, &Figures::subarrays>("chips.subarrays", "subarrays", 1, 4096, "of a bank"),
    own_figure<Figures, &Figures::subarray_rows>("chips.rows", "rows", 1, 65536, "of a subarray"),
    own_figure<Figures, &Figures::row_bits>("chips.columns", "columns", 1, 65536, "of a subarray"),
    own_figure<Figures, &Figures::bus_bits>("bus.bits", "bits", 1, 65536,
                                            "of a row that pass between a chip and the host in a clock"),
    or_ideal(own_figure<Figures, &Figures::plane_bits>("host.plane_bits", "bits", 1, 1U << 30U,
                                                       "that the host works out, or turns into pixels, in a clock"),
             1U << 30U),
    own_figure<Figures, &Figures::command, &CommandClocks::restore>(
        "timing.restore", "clocks", 1, machines::most_clocks, "tRAS: until an activated row is restored"),
    own_figure<Figures, &Figures::command, &CommandClocks::precharge>(
        "timing.precharge", "clocks", 1, machines::most_clocks, "tRP: until the bank's next activation"),
    own_figure<Figures, &Figures::command, &CommandClocks::second>("timing.second", "clocks", 1, machines::most_clocks,
                                                                   "from the first activation of a copy to the second"),
    own_figure<Figures, &Figures::command, &CommandClocks::logic>("timing.logic", "clocks", 1, machines::most_clocks,
                                                                  "of gates at the sense amplifiers"),
    own_figure<Figures, &Figures::command, &CommandClocks::column>(
        "timing.column", "clocks", 1, machines::most_clocks, "tRCD and CL: from an activation to its row's first bits"),
    own_figure<Figures, &Figures::command, &CommandClocks::recovery>(
        "timing.recovery", "clocks", 0, machines::most_clocks, "tWR: from the last bits until the row is closed"),
    own_figure<Figures, &Figures::command, &CommandClocks::leaf>("timing.leaf", "clocks", 1, machines::most_clocks,
                                                                 "from one bit of the multiplier trees to the next"),
    own_figure<Figures, &Figures::command, &CommandClocks::global_or>(
        "timing.global_or", "clocks", 1, machines::most_clocks, "in which the wired OR settles"),
    own_figure<Figures, &Figures::rank, &RankClocks::activation_gap>(
        "timing.activation_gap", "clocks", 1, machines::most_clocks, "tRRD: from one activation to the next"),
    or_ideal(own_figure<Figures, &Figures::rank, &RankClocks::window>(
                 "timing.window", "clocks", 0, machines::most_clocks, "tFAW: in which four rows at most are activated"),
             0),
    or_ideal(own_figure<Figures, &Figures::rank, &RankClocks::refresh_interval>(
                 "timing.refresh_interval", "clocks", 0, machines::most_clocks, "tREFI: from one refresh to the next"),
             0),
    own_figure<Figures, &Figures::rank, &RankClocks::refresh>("timing.refresh", "clocks", 0, machines::most_clocks,
                                                              "tRFC: of a refresh"),
    own_figure<Figures, &Figures::energy, &Energies::activation_fj>("energy.activation", "fJ", 0, most_fj,
                                                                    "of a row of a chip, with its precharge"),
    own_figure<Figures, &Figures::energy, &Energies::further_row_permille>(
        "energy.further_row", "permille", 0, 10'000, "of that, for each row that is activated with it"),
    own_figure<Figures, &Figures::energy, &Energies::logic_fj>("energy.logic", "fJ", 0, most_fj,
                                                               "of a column's gates in a logic command"),
    own_figure<Figures, &Figures::energy, &Energies::leaf_fj>(
        "energy.leaf", "fJ", 0, most_fj, "of a column's part of the trees, in a command that brings a bit"),
    own_figure<Figures, &Figures::energy, &Energies::transfer_fj>("energy.transfer", "fJ", 0, most_fj,
                                                                  "of a bit between a row and the host"),
    own_figure<Figures, &Figures::energy, &Energies::refresh_fj>("energy.refresh", "fJ", 0, most_fj,
                                                                 "of a refresh of a chip"),
    own_figure<Figures, &Figures::energy, &Energies::background_uw>("energy.background", "uW", 0, most_fj,
                                                                    "of a chip, whatever it does"),
    shared::link_width,
    shared::link_word_clocks,
    or_ideal(own_figure<Figures, &Figures::queue>("controller.queue", "commands", 1, 65536,
                                                  "from the host that wait behind the one that is carried out"),
             65536),
    shared::link_latency,
    shared::host_processor,
    shared::host_count,
});

void check_rows(const Machine& machine) {
  const auto& figures = machines::own<Figures>(machine);
  const RowMap map(machine.array.memory_bits, machine.picture.width, machine.picture.height);
  if (map.rows() <= figures.subarray_rows) return;
  throw machines::FigureError("chips.rows",
                              fmt::format("pixels of {} bits take {} rows with those that instructions need; take "
                                          "less array.memory_bits, or chips.rows {}",
                                          machine.array.memory_bits, map.rows(), map.rows()));
}

void check_fits(const Machine& machine) {
  const auto& figures = machines::own<Figures>(machine);
  const Slots slots = slots_of(machine);
  const std::uint64_t there = std::uint64_t{figures.banks} * figures.subarrays;
  if (slots.count() <= there) return;
  throw InputError(
      fmt::format("a picture of {}x{} takes {} subarrays of each chip, {} has {}; take a smaller picture, "
                  "or a machine file with more chips.subarrays",
                  machine.picture.width, machine.picture.height, slots.count(), machine.name, there));
}

}  // namespace

void Kind::complete(Machine& machine) const {
  const Figures& figures = figures_of(machine);
  machine.array.width = machine.picture.width;
  machine.array.height = machine.picture.height;
  if (machine.evaluator_degree > 1 && figures.expressions == Expressions::rows) {
    throw machines::FigureError("evaluator.degree",
                                "no rows hold products of x and y; take degree 1, or logic.expressions trees");
  }
  if (figures.rank.refresh_interval > 0 && figures.rank.refresh_interval <= 2 * figures.rank.refresh) {
    throw machines::FigureError("timing.refresh_interval",
                                "refreshes leave little time for anything else; take more than twice timing.refresh");
  }
  check_rows(machine);
  check_fits(machine);
}

void Kind::set_picture(Machine& machine, machines::Size size) const {
  Machine larger = machine;
  larger.picture = size;
  check_fits(larger);
  machine.array.width = size.width;
  machine.array.height = size.height;
}

std::vector<isa::Region> Kind::regions(const Machine& machine) const {
  return {{0, 0, machine.picture.width, machine.picture.height}};
}

void Kind::check(const isa::Program& program, const Machine& machine) const { machines::check_parts(program, machine); }

machines::Resources Kind::resources(const Machine& machine, const isa::FrameHeader& /*header*/) const {
  const std::uint64_t pixels = std::uint64_t{machine.picture.width} * machine.picture.height;
  return {pixels, pixels * machine.array.memory_bits};
}

const Kind kind{"bit-serial-memory", schema};

}  // namespace csgsim::bit_serial_memory

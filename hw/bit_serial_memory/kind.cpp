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

constexpr std::int64_t max_fj = 1'000'000'000'000;

constexpr auto schema = std::to_array<machines::FigureSchema>({
    shared::picture_width,
    shared::picture_height,
    shared::memory_bits,
    shared::clock_frequency,
    own_figure<Figures, &Figures::design>(
        "logic.design", "", 0, 2,
        "and-or-not and majority: operate on three rows at a time; latches: gates at each sense amplifier",
        design_names),
    own_figure<Figures, &Figures::expressions>(
        "logic.expressions", "", 0, 2,
        "rows: summed from stored x and y; planes: computed by the host; trees: delivered by multiplier trees",
        expression_names),
    shared::evaluator_degree,
    own_figure<Figures, &Figures::enable_latch>("logic.enable", "latches", 0, 1,
                                                "latches per column that mask writes to its rows"),
    own_figure<Figures, &Figures::has_wired_or>("global_or.present", "lines", 0, 1,
                                                "wired OR of all enable bits; without it, the host reads them"),
    own_figure<Figures, &Figures::chips>("chips.count", "chips", 1, 64, "chips that work in lockstep"),
    own_figure<Figures, &Figures::banks>("chips.banks", "banks", 1, 64, "banks of a chip"),
    own_figure<Figures, &Figures::subarrays>("chips.subarrays", "subarrays", 1, 4096, "subarrays of a bank"),
    own_figure<Figures, &Figures::subarray_rows>("chips.rows", "rows", 1, 65536, "rows of a subarray"),
    own_figure<Figures, &Figures::row_bits>("chips.columns", "columns", 1, 65536, "columns of a subarray"),
    own_figure<Figures, &Figures::bus_bits>("bus.bits", "bits", 1, 65536,
                                            "bits of a row transferred between a chip and the host per clock"),
    or_ideal(own_figure<Figures, &Figures::plane_bits>("host.plane_bits", "bits", 1, 1U << 30U,
                                                       "bits that the host computes, or converts to pixels, per clock"),
             1U << 30U),
    own_figure<Figures, &Figures::command, &CommandClocks::restore>(
        "timing.restore", "clocks", 1, machines::max_parameter_clocks,
        "tRAS: from an activation until its row is restored"),
    own_figure<Figures, &Figures::command, &CommandClocks::precharge>(
        "timing.precharge", "clocks", 1, machines::max_parameter_clocks,
        "tRP: from the end of tRAS until the bank's next activation"),
    own_figure<Figures, &Figures::command, &CommandClocks::second>(
        "timing.second", "clocks", 1, machines::max_parameter_clocks,
        "clocks from the first activation of a copy to the second"),
    own_figure<Figures, &Figures::command, &CommandClocks::logic>(
        "timing.logic", "clocks", 1, machines::max_parameter_clocks, "clocks of gates at the sense amplifiers"),
    own_figure<Figures, &Figures::command, &CommandClocks::column>(
        "timing.column", "clocks", 1, machines::max_parameter_clocks,
        "tRCD and CL: from an activation to its row's first bits"),
    own_figure<Figures, &Figures::command, &CommandClocks::recovery>("timing.recovery", "clocks", 0,
                                                                     machines::max_parameter_clocks,
                                                                     "tWR: from the last bits until the row is closed"),
    own_figure<Figures, &Figures::command, &CommandClocks::leaf>("timing.leaf", "clocks", 1,
                                                                 machines::max_parameter_clocks,
                                                                 "clocks between two bits from the multiplier trees"),
    own_figure<Figures, &Figures::command, &CommandClocks::global_or>(
        "timing.global_or", "clocks", 1, machines::max_parameter_clocks, "clocks until the wired OR settles"),
    own_figure<Figures, &Figures::rank, &RankClocks::activation_gap>(
        "timing.activation_gap", "clocks", 1, machines::max_parameter_clocks, "tRRD: from one activation to the next"),
    or_ideal(own_figure<Figures, &Figures::rank, &RankClocks::window>(
                 "timing.window", "clocks", 0, machines::max_parameter_clocks,
                 "tFAW: window in which at most four rows are activated"),
             0),
    or_ideal(own_figure<Figures, &Figures::rank, &RankClocks::refresh_interval>("timing.refresh_interval", "clocks", 0,
                                                                                machines::max_parameter_clocks,
                                                                                "tREFI: from one refresh to the next"),
             0),
    own_figure<Figures, &Figures::rank, &RankClocks::refresh>(
        "timing.refresh", "clocks", 0, machines::max_parameter_clocks, "tRFC: duration of a refresh"),
    own_figure<Figures, &Figures::energy, &Energies::activation_fj>(
        "energy.activation", "fJ", 0, max_fj, "activation of a row of a chip, including its precharge"),
    own_figure<Figures, &Figures::energy, &Energies::further_row_permille>(
        "energy.further_row", "permille", 0, 10'000,
        "activation of a further row with the first, as a fraction of the first row's energy"),
    own_figure<Figures, &Figures::energy, &Energies::logic_fj>("energy.logic", "fJ", 0, max_fj,
                                                               "gates of one column, per logic command"),
    own_figure<Figures, &Figures::energy, &Energies::leaf_fj>(
        "energy.leaf", "fJ", 0, max_fj, "one column's part of the trees, per command that delivers a bit"),
    own_figure<Figures, &Figures::energy, &Energies::transfer_fj>("energy.transfer", "fJ", 0, max_fj,
                                                                  "transfer of one bit between a row and the host"),
    own_figure<Figures, &Figures::energy, &Energies::refresh_fj>("energy.refresh", "fJ", 0, max_fj,
                                                                 "one refresh of a chip"),
    own_figure<Figures, &Figures::energy, &Energies::background_uw>(
        "energy.background", "uW", 0, max_fj, "background power of a chip, regardless of activity"),
    shared::link_width,
    shared::link_word_clocks,
    or_ideal(own_figure<Figures, &Figures::queue>("controller.queue", "commands", 1, 65536,
                                                  "host commands that can wait behind the current one"),
             65536),
    shared::link_latency,
    shared::host_processor,
    shared::host_count,
});

void check_rows(const Machine& machine) {
  const auto& figures = machines::kind_figures<Figures>(machine);
  const RowMap map(machine.array.memory_bits, machine.picture.width, machine.picture.height);
  if (map.rows() <= figures.subarray_rows) return;
  throw machines::FigureError("chips.rows",
                              fmt::format("pixels of {} bits need {} rows, including those for instructions; reduce "
                                          "array.memory_bits, or set chips.rows to at least {}",
                                          machine.array.memory_bits, map.rows(), map.rows()));
}

void check_fits(const Machine& machine) {
  const auto& figures = machines::kind_figures<Figures>(machine);
  const Slots slots = slots_of(machine);
  const std::uint64_t available = std::uint64_t{figures.banks} * figures.subarrays;
  if (slots.count() <= available) return;
  throw InputError(fmt::format(
      "a picture of {}x{} needs {} subarrays of each chip, but {} has {}; use a smaller picture, or increase "
      "chips.subarrays in the machine file",
      machine.picture.width, machine.picture.height, slots.count(), machine.name, available));
}

}  // namespace

void Kind::complete(Machine& machine) const {
  const Figures& figures = figures_of(machine);
  machine.array.width = machine.picture.width;
  machine.array.height = machine.picture.height;
  if (machine.evaluator_degree > 1 && figures.expressions == Expressions::rows) {
    throw machines::FigureError(
        "evaluator.degree",
        "no rows hold products of x and y; set evaluator.degree to 1, or logic.expressions to trees");
  }
  if (figures.rank.refresh_interval > 0 && figures.rank.refresh_interval <= 2 * figures.rank.refresh) {
    throw machines::FigureError("timing.refresh_interval",
                                "refreshes leave too little time for commands; use more than twice timing.refresh");
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

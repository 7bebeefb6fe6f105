// lockstep_squares KEY=NUMBER...: draws random Programs, or with divider=1 random models, on the clocked pixel-square
// machine with those parameters and compares them with the reference's bits and the functional engine's picture,
// clocks, account and timeline. One machine per process, as SystemC elaborates once.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <map>
#include <string>

#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"
#include "hw/systemc/evaluator_form.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/row.h"

namespace csgsim::test {

namespace {

struct Settings {
  machines::Machine machine = machines::blank_machine(pixel_square::kind);
  unsigned programs = 40;
  unsigned instructions = 12;  ///< maximum per square
  systemc::EvaluatorForm evaluator = systemc::EvaluatorForm::computed;
};

Settings read_settings(int count, char** arguments) {
  Settings settings;
  machines::Machine& machine = settings.machine;
  machine.name = "squares";
  machine.array = {8, 8, 40};
  machine.picture = {20, 20};
  machine.evaluator_degree = 2;
  machine.link = {.width = 32, .word_clocks = 1, .fifo_depth = 64, .latency = 0};
  auto& figures = machines::kind_figures<pixel_square::Figures>(machine);
  figures.model_bits = 10'000'000;
  figures.record_bits = 32;
  figures.halfspaces = 1'000'000;
  figures.nodes = 1'000'000;
  figures.store_words = 10'000'000;
  std::uint32_t clock_hz = 10'000'000;
  std::uint32_t stepped = 0;
  std::uint32_t global_or = 0;
  std::uint32_t order = 0;
  std::uint32_t divider = 0;
  const std::map<std::string, std::uint32_t*> known{{"picture_width", &machine.picture.width},
                                                    {"picture_height", &machine.picture.height},
                                                    {"width", &machine.array.width},
                                                    {"height", &machine.array.height},
                                                    {"bits", &machine.array.memory_bits},
                                                    {"reads", &machine.memory_reads},
                                                    {"clear", &machine.clear_clocks},
                                                    {"degree", &machine.evaluator_degree},
                                                    {"alu", &machine.alu_bits},
                                                    {"trees", &machine.evaluator_bits},
                                                    {"register_levels", &machine.register_levels},
                                                    {"link_width", &machine.link.width},
                                                    {"word", &machine.link.word_clocks},
                                                    {"depth", &machine.link.fifo_depth},
                                                    {"latency", &machine.link.latency},
                                                    {"port_depth", &figures.port_fifo_depth},
                                                    {"move", &figures.move_bits},
                                                    {"renderers", &figures.renderers},
                                                    {"buffers", &figures.buffers},
                                                    {"port", &figures.port_bits},
                                                    {"latch", &figures.latch_bits},
                                                    {"banks", &figures.banks},
                                                    {"pictures", &figures.pictures},
                                                    {"refresh", &figures.refresh_rate},
                                                    {"refresh_bits", &figures.refresh_bits},
                                                    {"refresh_clocks", &figures.refresh_clocks},
                                                    {"hz", &clock_hz},
                                                    {"stepped", &stepped},
                                                    {"order", &order},
                                                    {"divider", &divider},
                                                    {"levels", &figures.levels},
                                                    {"group", &figures.group_side},
                                                    {"list", &figures.list_entries},
                                                    {"box", &figures.box_clocks},
                                                    {"halfspace", &figures.halfspace_clocks},
                                                    {"cell", &figures.cell_clocks},
                                                    {"node", &figures.node_clocks},
                                                    {"linear", &figures.linear_clocks},
                                                    {"dividers", &figures.dividers},
                                                    {"memory", &figures.model_bits},
                                                    {"record", &figures.record_bits},
                                                    {"halfspaces", &figures.halfspaces},
                                                    {"nodes", &figures.nodes},
                                                    {"store", &figures.store_words},
                                                    {"backing", &figures.backing_bits},
                                                    {"backing_width", &figures.backing_width},
                                                    {"or", &global_or},
                                                    {"or_fan_in", &figures.or_fan_in},
                                                    {"processors", &figures.processors},
                                                    {"channels", &figures.ring_channels},
                                                    {"ring", &figures.ring_bits},
                                                    {"ring_word", &figures.ring_word_clocks},
                                                    {"programs", &settings.programs},
                                                    {"instructions", &settings.instructions}};
  read_row(count, arguments, known);
  machine.clock_hz = clock_hz;
  if (stepped != 0) settings.evaluator = systemc::EvaluatorForm::stepped;
  figures.has_global_or = global_or != 0;
  figures.divider = static_cast<pixel_square::DividerKind>(divider);
  figures.order = static_cast<pixel_square::SquareOrder>(order);
  return settings;
}

}  // namespace

}  // namespace csgsim::test

int main(int argc, char** argv) {
  try {
    const csgsim::test::Settings settings = csgsim::test::read_settings(argc, argv);
    return csgsim::test::property_exit_code(settings.programs, [&] {
      return csgsim::test::squares_agree(settings.machine, settings.instructions, settings.evaluator);
    });
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}

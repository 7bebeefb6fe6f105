// lockstep_planes KEY=NUMBER...: draws random Programs on the clocked frame-buffer machine with those parameters and
// compares them with the reference's bits and answers and with the predicted clocks, account and timeline. One machine
// per process, as SystemC elaborates once. RC_PARAMS overrides the seed and the number of Programs.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <map>
#include <string>

#include "hw/pixel_planes/figures.h"
#include "hw/systemc/evaluator_form.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/lockstep.h"
#include "tests/lockstep/row.h"

namespace csgsim::test {

namespace {

struct Settings {
  machines::Machine machine = machine_of({8, 8, 40}, 1);
  unsigned programs = 100;
  unsigned instructions = 30;  ///< maximum per segment
  systemc::EvaluatorForm evaluator = systemc::EvaluatorForm::computed;
};

Settings read_settings(int count, char** arguments) {
  Settings settings;
  machines::Machine& machine = settings.machine;
  auto& figures = machines::kind_figures<pixel_planes::Figures>(machine);
  std::uint32_t shared_port = 0;
  std::uint32_t stepped = 0;
  const std::map<std::string, std::uint32_t*> known{{"width", &machine.array.width},
                                                    {"height", &machine.array.height},
                                                    {"bits", &machine.array.memory_bits},
                                                    {"reads", &machine.memory_reads},
                                                    {"alu", &machine.alu_bits},
                                                    {"degree", &machine.evaluator_degree},
                                                    {"trees", &machine.evaluator_bits},
                                                    {"levels", &machine.register_levels},
                                                    {"link", &machine.link.width},
                                                    {"word", &machine.link.word_clocks},
                                                    {"depth", &machine.link.fifo_depth},
                                                    {"latency", &machine.link.latency},
                                                    {"clear", &machine.clear_clocks},
                                                    {"fan_in", &figures.or_fan_in},
                                                    {"pixels", &figures.scan_out_pixels},
                                                    {"shared", &shared_port},
                                                    {"stepped", &stepped},
                                                    {"buffers", &figures.scan_out_buffers},
                                                    {"programs", &settings.programs},
                                                    {"instructions", &settings.instructions}};
  read_row(count, arguments, known);
  if (stepped != 0) settings.evaluator = systemc::EvaluatorForm::stepped;
  if (shared_port != 0) figures.scan_out_port = pixel_planes::ScanOutPort::shared;
  return settings;
}

}  // namespace

}  // namespace csgsim::test

int main(int argc, char** argv) {
  try {
    const csgsim::test::Settings settings = csgsim::test::read_settings(argc, argv);
    return csgsim::test::property_exit_code(settings.programs, [&] {
      return csgsim::test::planes_agree(settings.machine, settings.instructions, settings.evaluator) &&
             csgsim::test::planes_agree_in_sequences(settings.machine, settings.instructions, settings.evaluator);
    });
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}

// lockstep_planes KEY=NUMBER...: draws random Programs on the clocked frame-buffer machine with those figures and holds
// them against the reference's bits and answers, and the clocks and the account that are worked out. One machine a
// process, as SystemC elaborates once. RC_PARAMS overrides the seed and the number of Programs.

#include <fmt/format.h>
#include <rapidcheck.h>

#include <cstdio>
#include <exception>
#include <map>
#include <string>

#include "hw/pixel_planes/figures.h"
#include "tests/lockstep/lockstep.h"
#include "tests/lockstep/row.h"
#include "tests/support/random_program.h"

namespace csgsim::test {

namespace {

struct Settings {
  machines::Machine machine = machine_of({8, 8, 40}, 1);
  unsigned programs = 100;
  unsigned instructions = 30;  ///< of a segment at most
};

Settings read_settings(int count, char** arguments) {
  Settings settings;
  machines::Machine& machine = settings.machine;
  auto& figures = machines::own<pixel_planes::Figures>(machine);
  std::uint32_t shared_port = 0;
  const std::map<std::string, std::uint32_t*> known{{"width", &machine.array.width},
                                                    {"height", &machine.array.height},
                                                    {"bits", &machine.array.memory_bits},
                                                    {"reads", &machine.memory_reads},
                                                    {"alu", &machine.alu_bits},
                                                    {"link", &machine.link.width},
                                                    {"word", &machine.link.word_clocks},
                                                    {"depth", &machine.link.fifo_depth},
                                                    {"latency", &machine.link.latency},
                                                    {"clear", &machine.clear_clocks},
                                                    {"fan_in", &figures.or_fan_in},
                                                    {"pixels", &figures.scan_out_pixels},
                                                    {"shared", &shared_port},
                                                    {"programs", &settings.programs},
                                                    {"instructions", &settings.instructions}};
  read_row(count, arguments, known);
  if (shared_port != 0) figures.scan_out_port = pixel_planes::ScanOutPort::shared;
  return settings;
}

bool agree(const Settings& settings) {
  const machines::Machine& machine = settings.machine;
  const auto reference = sim::make_reference_engine(machine);
  const auto cycle = sim::make_cycle_engine(machine);
  return rc::check("the clocked frame-buffer machine leaves the bits, clocks and account worked out", [&] {
    const isa::Program program = *arbitrary_program(machine.array, settings.instructions);
    const sim::RunResult expected = reference->run(program, {});
    const sim::RunResult counted = cycle->run(program, {});
    if (counted.clocks != expected.clocks || counted.account != expected.account) {
      RC_FAIL("counted " + show(counted) + "\nworked out " + show(expected));
    }
    RC_ASSERT(adds_up(counted));
    check_lockstep(*reference, *cycle, program, machine);
  });
}

}  // namespace

}  // namespace csgsim::test

int main(int argc, char** argv) {
  try {
    const csgsim::test::Settings settings = csgsim::test::read_settings(argc, argv);
    return csgsim::test::exit_code_of(settings.programs, [&] { return csgsim::test::agree(settings); });
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}

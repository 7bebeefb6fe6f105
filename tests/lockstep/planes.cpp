// lockstep_planes KEY=NUMBER...: draws random Programs on the clocked frame-buffer machine with those figures and holds
// them against the reference's bits and answers, and the clocks and the account that are worked out. One machine a
// process, as SystemC elaborates once. RC_PARAMS overrides the seed and the number of Programs.

#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include "hw/pixel_planes/figures.h"
#include "tests/lockstep/lockstep.h"
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
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    const std::size_t equals = argument.find('=');
    const auto setting = known.find(argument.substr(0, equals));
    if (equals == argument.npos || setting == known.end()) throw std::invalid_argument("what is " + argument + "?");
    *setting->second = static_cast<std::uint32_t>(std::stoul(argument.substr(equals + 1)));
  }
  if (shared_port != 0) figures.scan_out_port = pixel_planes::ScanOutPort::shared;
  return settings;
}

std::string show(const sim::RunResult& result) {
  std::string text = fmt::format("{} clocks", result.clocks);
  for (const machines::Count& count : result.account.counts) text += fmt::format(", {} {}", count.value, count.name);
  for (const machines::PartAccount& part : result.account.parts) {
    text += fmt::format("\n  {}:", part.part);
    for (const machines::ActivityClocks& one : part.clocks) text += fmt::format(" {} {}", one.activity, one.clocks);
  }
  return text;
}

/// Every clock of the frame is accounted for, in every part.
bool adds_up(const sim::RunResult& result) {
  return std::ranges::all_of(result.account.parts, [&](const machines::PartAccount& part) {
    std::uint64_t sum = 0;
    for (const machines::ActivityClocks& one : part.clocks) sum += one.clocks;
    return sum == result.clocks;
  });
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
    ::setenv("RC_PARAMS", fmt::format("max_success={} noshrink=0", settings.programs).c_str(), 0);
    return csgsim::test::agree(settings) ? 0 : 1;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}

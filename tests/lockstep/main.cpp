// lockstep_LEVEL WIDTH HEIGHT MEMORY_BITS MEMORY_READS ALU_BITS PROGRAMS INSTRUCTIONS: compares PROGRAMS random
// Programs of at most INSTRUCTIONS per segment with the reference engine. One array shape per process, as SystemC
// elaborates once. RC_PARAMS overrides the seed and the number of Programs.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <span>
#include <string>
#include <vector>

#include "tests/lockstep/lockstep.h"
#include "tests/support/properties.h"
#include "tests/support/random_program.h"

namespace csgsim::test {

namespace {

bool agree_on_random_programs(const machines::Machine& machine, std::size_t instructions) {
  const auto judge = engine::make_reference_engine(machine);
  const auto engine = engine::CSGSIM_MAKE_ENGINE(machine);
  return rc::check(
      fmt::format("{}: reference and {} agree at every instruction boundary", machine.name, engine->level()), [&] {
        const auto program = *arbitrary_program(machine.array, instructions, machine.evaluator_degree);
        check_lockstep(*judge, *engine, program, machine);
      });
}

int run(std::span<const std::uint32_t> arguments) {
  const isa::ArrayShape shape{arguments[0], arguments[1], arguments[2]};
  testing::add_parameters(fmt::format("max_success={}", arguments[5]));
  return agree_on_random_programs(machine_of(shape, arguments[3], arguments[4]), arguments[6]) ? 0 : 1;
}

}  // namespace

}  // namespace csgsim::test

int main(int argc, char** argv) {
  try {
    csgsim::testing::begin_program(argc, argv);
    std::vector<std::uint32_t> arguments;
    for (int i = 1; i < argc; ++i) arguments.push_back(static_cast<std::uint32_t>(std::stoul(argv[i])));
    if (arguments.size() == 7) return csgsim::test::run(arguments);
    fmt::print(stderr, "usage: {} WIDTH HEIGHT MEMORY_BITS MEMORY_READS ALU_BITS PROGRAMS INSTRUCTIONS\n", argv[0]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}

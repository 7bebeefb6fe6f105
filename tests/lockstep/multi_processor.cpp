// lockstep_multi_processor SEED PROGRAMS: draws random models on a clocked multi-processor with parameters generated
// from the seed, and compares the run with the prediction. One machine per process, as SystemC elaborates once.

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <random>
#include <stdexcept>
#include <string>

#include "hw/base/error.h"
#include "hw/base/quotient.h"
#include "hw/machines/runs_on.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/kind.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/row.h"
#include "tests/support/properties.h"

namespace csgsim::test {

namespace {

/// Parameters of small machines; some are 0 and some exceed what the models need.
class Choice {
 public:
  explicit Choice(std::uint32_t seed) : random_(seed) {}

  std::uint32_t between(std::uint32_t least, std::uint32_t most) {
    return least + static_cast<std::uint32_t>(random_() % (most - least + 1));
  }

 private:
  std::mt19937 random_;
};

machines::Machine random_machine(std::uint32_t seed) {
  Choice choice(seed);
  machines::Machine machine = machines::blank_machine(multi_processor::kind);
  machine.name = "random";
  machine.array = {choice.between(1, 4), choice.between(1, 4), 200};
  machine.picture = {choice.between(1, 40), choice.between(1, 40)};
  machine.clock_hz = 8'000'000;
  machine.link = {.width = choice.between(1, 80),
                  .word_clocks = choice.between(1, 30),
                  .fifo_depth = 1,
                  .latency = choice.between(0, 3) * 11};
  auto& figures = machines::kind_figures<multi_processor::Figures>(machine);
  figures.levels = choice.between(0, 5);
  figures.order = static_cast<multi_processor::RenderingOrder>(seed % 3);
  figures.word_bits = choice.between(1, 64);
  // Lists and then half-spaces may not fit.
  figures.memory_words = seed % 3 == 0 ? 1U << 31U : quotient_up(choice.between(2'000, 10'000), figures.word_bits);
  figures.operations = {choice.between(0, 20), choice.between(0, 20), choice.between(0, 20), choice.between(0, 20),
                        choice.between(0, 20), choice.between(0, 90), choice.between(0, 9),  choice.between(0, 3)};
  figures.field_clocks = seed % 4 == 0 ? multi_processor::unpacked : choice.between(0, 30);
  figures.branches = {static_cast<multi_processor::Branches>(choice.between(0, 1)), choice.between(0, 20),
                      choice.between(0, 20)};
  figures.chain = {static_cast<multi_processor::NodeProgram>(choice.between(0, 1)), choice.between(0, 60),
                   choice.between(1, 40)};
  figures.lists = static_cast<multi_processor::ListKind>(choice.between(0, 1));
  figures.number_clocks = choice.between(0, 100);
  figures.loop = {choice.between(0, 20), choice.between(0, 40), choice.between(0, 60)};
  figures.node_tests = {choice.between(0, 50), choice.between(0, 500), choice.between(0, 90), choice.between(0, 70),
                        choice.between(0, 300)};
  figures.display_tests = {.primitive = choice.between(0, 50), .halfspace = choice.between(0, 500)};
  figures.host = {choice.between(1, 80), choice.between(1, 30), choice.between(0, 3) * 13};
  // Planes and the results of a segment may not fit either.
  figures.display_memory_words =
      seed % 4 < 2 ? 1U << 31U : quotient_up(choice.between(2'000, 9'000), figures.word_bits);
  figures.transform_clocks = choice.between(0, 5000);
  figures.divides_ahead = seed % 2 == 1;
  figures.barrier_clocks = choice.between(0, 2) * 17;
  figures.refresh = {seed % 2 == 0 ? 0 : choice.between(1, 100), choice.between(8, 400), choice.between(1, 9)};
  return machine;
}

/// Rejects models that exceed the machine's memory.
bool runs_on(const isa::Program& program, const machines::Machine& machine) {
  try {
    machines::check_runs_on(program, machine);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

}  // namespace

}  // namespace csgsim::test

int main(int argc, char** argv) {
  try {
    if (argc != 3) throw std::invalid_argument("give a seed and a number of Programs");
    csgsim::testing::begin_program(argc, argv);
    const csgsim::machines::Machine machine =
        csgsim::test::random_machine(static_cast<std::uint32_t>(std::stoul(argv[1])));
    const auto programs = static_cast<unsigned>(std::stoul(argv[2]));
    const auto allowed = [&](const csgsim::isa::Program& program) { return csgsim::test::runs_on(program, machine); };
    return csgsim::test::property_exit_code(programs, [&] { return csgsim::test::nodes_agree(machine, allowed); });
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
  }
  return 2;
}

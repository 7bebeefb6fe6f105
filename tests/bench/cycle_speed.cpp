// bench_cycle_speed [WIDTH HEIGHT [PRIMITIVES]]: clocks per second of the clocked Pixel-planes machine on a typical mix
// of instructions, of its parts without the SystemC kernel, and of a plain loop over bit planes, in turns. Seconds are
// processor time, the fastest of some runs.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "hw/array/pixel_array.h"
#include "hw/array/sequencer.h"
#include "hw/pixel_planes/kind.h"
#include "sim/engine/engine.h"
#include "tests/bench/typical_mix.h"
#include "tests/performance/dense_loop.h"

namespace csgsim::bench {

namespace {

struct Row {
  std::string what;
  std::function<std::uint64_t()> run;  ///< returns the clocks
  std::uint64_t clocks = 0;
  double seconds = std::numeric_limits<double>::infinity();

  [[nodiscard]] double rate() const { return static_cast<double>(clocks) / seconds; }
};

/// Runs all in turns, so that other load on the computer affects all of them.
void run_in_turns(std::vector<Row>& rows) {
  constexpr int turns = 5;
  for (int turn = 0; turn < turns; ++turn) {
    for (Row& row : rows) {
      const std::clock_t start = std::clock();
      row.clocks = row.run();
      row.seconds = std::min(row.seconds, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
  }
}

/// Calls use(step) for every bit step of the Program, and done() after each instruction.
template <class Use, class Done>
std::uint64_t each_step(const isa::Program& program, Use use, Done done) {
  array::Sequencer sequencer(1, 1, 1);
  std::uint64_t clocks = 0;
  for (const isa::Instruction& instruction : program.segments.front().instructions) {
    sequencer.begin(instruction);
    for (; sequencer.busy(); ++clocks) use(sequencer.issue());
    done();
  }
  return clocks;
}

/// Uses trees without levels, so that a bit reaches the pixels in its step's clock. Enable bits are counted after each
/// instruction, as in the machine.
std::uint64_t run_array(const isa::Program& program, array::PixelArray& pixels) {
  array::LinearEvaluator evaluator({1, 1});
  array::StreamBit leaves;
  std::uint64_t enabled = 0;
  return each_step(
      program,
      [&](const array::BitStep& step) {
        evaluator.clock(step.root, leaves);
        pixels.step(step.pixels, leaves);
      },
      [&] { enabled += pixels.count_enabled(); });
}

void run(isa::ArrayShape shape, unsigned primitives) {
  const isa::Program program = typical_mix(shape, primitives);
  DenseLoop dense(shape);
  array::PixelArray pixels(shape, 1);
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.name = "bench";
  machine.array = shape;
  machine.clock_hz = 10'000'000;
  const auto engine = engine::make_cycle_engine(machine);

  std::vector<Row> rows;
  const auto add = [&](const char* what, std::function<std::uint64_t()> run) {
    rows.push_back({.what = what, .run = std::move(run)});
  };
  add("plain dense loop", [&] { return dense.run(program.segments.front()); });
  add("sequencer", [&] {
    return each_step(
        program, [](const array::BitStep&) {}, [] {});
  });
  add("sequencer, trees, pixels", [&] { return run_array(program, pixels); });
  add("whole machine in SystemC", [&] { return engine->run(program, {}).clocks; });
  run_in_turns(rows);
  for (const Row& row : rows) {
    fmt::print("{:<26} {:>9} clocks {:>8.3f} s {:>10.0f} clocks/s {:>7.3f} us a clock {:>7.2f} x the dense loop\n",
               row.what, row.clocks, row.seconds, row.rate(), 1e6 / row.rate(), row.rate() / rows.front().rate());
  }
  fmt::print("SystemC, controller, link and delays: {:.0f} % of a clock\n",
             100 * (1 - rows[3].rate() / rows[2].rate()));
  for (std::uint32_t bit = 0; bit < shape.memory_bits; ++bit) {
    const array::Words plane = pixels.memory(bit);
    if (!std::equal(dense.memory(bit).begin(), dense.memory(bit).end(), plane.begin())) {
      fmt::print("the dense loop and the pixels differ in memory bit {}\n", bit);
      std::exit(1);
    }
  }
}

}  // namespace

}  // namespace csgsim::bench

int main(int argc, char** argv) {
  const auto argument = [&](int i, unsigned otherwise) {
    return i < argc ? static_cast<unsigned>(std::strtoul(argv[i], nullptr, 10)) : otherwise;
  };
  csgsim::bench::run({argument(1, 512), argument(2, 512), 72}, argument(3, 60));
}

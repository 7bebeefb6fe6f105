// bench_cycle_speed [WIDTH HEIGHT [PRIMITIVES]]: clocks a second of the clocked Pixel-planes machine on a typical mix
// of instructions, and of its parts without the SystemC kernel. Seconds are of processor time.

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <ctime>

#include "hw/array/pixel_array.h"
#include "hw/array/sequencer.h"
#include "hw/pixel_planes/kind.h"
#include "sim/engine/engine.h"
#include "tests/bench/typical_mix.h"

namespace csgsim::bench {

namespace {

template <class Run>
void report(const char* what, Run run) {
  const std::clock_t start = std::clock();
  const std::uint64_t clocks = run();
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  fmt::print("{:<28} {:>10} clocks {:>8.3f} s {:>10.0f} clocks/s {:>7.3f} us a clock\n", what, clocks, seconds,
             static_cast<double>(clocks) / seconds, seconds * 1e6 / static_cast<double>(clocks));
}

/// Calls use(step) with every bit step of the Program.
template <class Use>
std::uint64_t each_step(const isa::Program& program, Use use) {
  array::Sequencer sequencer(1, 1);
  std::uint64_t clocks = 0;
  for (const isa::Instruction& instruction : program.segments.front().instructions) {
    sequencer.begin(instruction);
    for (; sequencer.busy(); ++clocks) use(sequencer.issue());
  }
  return clocks;
}

void run(isa::ArrayShape shape, unsigned primitives) {
  const isa::Program program = typical_mix(shape, primitives);
  array::LinearEvaluator evaluator({shape.width, shape.height});
  array::PixelArray pixels(shape, 1);
  array::Words leaves(pixels.shape().padded_words());

  report("sequencer", [&] { return each_step(program, [](const array::BitStep&) {}); });
  report("multiplier trees",
         [&] { return each_step(program, [&](const array::BitStep& step) { evaluator.clock(step.root, leaves); }); });
  report("pixel processors",
         [&] { return each_step(program, [&](const array::BitStep& step) { pixels.step(step.pixels, leaves); }); });

  machines::Machine machine = machines::blank(pixel_planes::kind);
  machine.name = "bench";
  machine.array = shape;
  machine.clock_hz = 10'000'000;
  const auto engine = sim::make_cycle_engine(machine);
  report("whole machine in SystemC", [&] { return engine->run(program, {}).clocks; });
}

}  // namespace

}  // namespace csgsim::bench

int main(int argc, char** argv) {
  const auto argument = [&](int i, unsigned otherwise) {
    return i < argc ? static_cast<unsigned>(std::strtoul(argv[i], nullptr, 10)) : otherwise;
  };
  csgsim::bench::run({argument(1, 512), argument(2, 512), 72}, argument(3, 200));
}

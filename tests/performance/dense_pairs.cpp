#include <array>
#include <chrono>

#include "hw/isa/program_file.h"
#include "tests/performance/dense_loop.h"
#include "tests/performance/process.h"
#include "tests/performance/runs.h"

namespace csgsim::bench {

namespace {

/// The machine modelled by the dense loop.
constexpr const char* dense_machine = "pixel-planes-4";

double dense_seconds(const isa::Program& program) {
  DenseLoop loop(program.shape);
  const auto begin = std::chrono::steady_clock::now();
  for (const isa::Segment& segment : program.segments) loop.run(segment);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

DensePair pair_of(const Settings& settings, const std::filesystem::path& model) {
  const Compiled compiled = compile(settings, model, dense_machine, settings.size);
  const isa::Program program = isa::load_program(compiled.program);
  const Words words = run_words(settings, compiled, "cycle");
  DensePair pair{model.stem().native(), 0, 0, 0, command_text(words)};
  const std::array<Timed, 2> timed{[&] {
                                     const Ran ran = run(settings, words);
                                     pair.clocks = ran.clocks;
                                     return ran.wall;
                                   },
                                   [&] { return dense_seconds(program); }};
  const std::vector<double> medians = medians_in_turn(timed, settings.rounds);
  pair.clocked = medians[0];
  pair.dense = medians[1];
  return pair;
}

}  // namespace

std::vector<DensePair> measure_dense(const Settings& settings) {
  std::vector<DensePair> pairs;
  for (const std::filesystem::path& model : all_models(settings)) pairs.push_back(pair_of(settings, model));
  return pairs;
}

}  // namespace csgsim::bench

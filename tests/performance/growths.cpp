#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "tests/performance/process.h"
#include "tests/performance/runs.h"
#include "tests/performance/subjects.h"

namespace csgsim::bench {

namespace {

constexpr const char* growing_machine = "pixel-planes-4";
constexpr const char* level = "functional";

/// One size of something that grows.
struct Step {
  double x = 0;
  std::filesystem::path model;
  std::string size;
  unsigned threads = 1;
};

/// Measures all steps in turn, the runs and, where it is asked for, the whole compilations.
std::vector<Growth> growth_of(const Settings& settings, const std::string& against, const std::vector<Step>& steps,
                              bool with_compile) {
  Growth compiles{against, "compile", {}, {}};
  Growth runs{against, "run", {}, {}};
  std::vector<Timed> compilations;
  std::vector<Timed> timed;
  for (const Step& step : steps) {
    const Compiled compiled = compile(settings, step.model, growing_machine, step.size);
    const Words compile_line = compile_words(settings, step.model, compiled, step.size);
    const Words run_line = run_words(settings, compiled, level, step.threads);
    timed.emplace_back([&settings, run_line] { return run(settings, run_line).wall; });
    if (with_compile) compilations.emplace_back([compile_line] { return whole_process(compile_line); });
    compiles.command = command_text(compile_line);
    runs.command = command_text(run_line);
  }
  timed.insert(timed.end(), compilations.begin(), compilations.end());
  const std::vector<double> medians = medians_in_turn(timed, settings.rounds);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    runs.points.push_back({steps[i].x, medians[i]});
    if (with_compile) compiles.points.push_back({steps[i].x, medians[steps.size() + i]});
  }
  if (!with_compile) return {runs};
  return {compiles, runs};
}

std::filesystem::path sphere(const Settings& settings, unsigned fragments) {
  return put_model(settings, fmt::format("sphere_{}", sphere_halfspaces(fragments)), drilled_sphere(fragments));
}

std::vector<Growth> halfspaces(const Settings& settings) {
  std::vector<Step> steps;
  for (const unsigned fragments : {16U, 32U, 64U, 128U})
    steps.push_back({static_cast<double>(sphere_halfspaces(fragments)), sphere(settings, fragments), settings.size});
  return growth_of(settings, "half-spaces", steps, true);
}

std::vector<Growth> primitives(const Settings& settings) {
  std::vector<Step> steps;
  for (const unsigned cubes : {16U, 64U, 256U, 1024U}) {
    steps.push_back({static_cast<double>(cubes),
                     put_model(settings, fmt::format("grid_{}", cubes), grid_of_cubes(cubes)), settings.size});
  }
  return growth_of(settings, "primitives", steps, true);
}

std::vector<Growth> pixels(const Settings& settings) {
  std::vector<Step> steps;
  for (const unsigned side : {128U, 256U, 512U, 1024U})
    steps.push_back({static_cast<double>(side) * side, sphere(settings, 32), fmt::format("{0}x{0}", side)});
  return growth_of(settings, "pixels", steps, false);
}

/// As many threads as there are cores, at a size at which they have work.
std::vector<Growth> threads(const Settings& settings) {
  std::vector<Step> steps;
  for (unsigned count = 1; count <= std::max(std::thread::hardware_concurrency(), 2U); count *= 2)
    steps.push_back({static_cast<double>(count), sphere(settings, 32), "2048x2048", count});
  return growth_of(settings, "threads", steps, false);
}

}  // namespace

std::vector<Growth> measure_growths(const Settings& settings) {
  std::vector<Growth> all;
  for (const auto& family : {halfspaces, primitives, pixels, threads}) {
    for (Growth& growth : family(settings)) all.push_back(std::move(growth));
  }
  return all;
}

}  // namespace csgsim::bench

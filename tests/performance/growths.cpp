#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <thread>
#include <utility>

#include "tests/performance/process.h"
#include "tests/performance/runs.h"
#include "tests/performance/subjects.h"

namespace csgsim::bench {

namespace {

constexpr const char* growing_machine = "pixel-planes-4";
constexpr const char* level = "functional";

/// One size of a growing model.
struct Step {
  double x = 0;
  std::filesystem::path model;
  std::string size;
  unsigned threads = 1;
};

/// The measurements of each step.
struct Measured {
  bool compile = true;
  bool run = true;
  Words options{};  ///< options of compile
};

/// The seconds of one part of every step, for each build.
struct Part {
  Growth growth;
  std::array<std::vector<Timed>, 2> timed;
};

/// Adds a step for one build: 0 is this one, 1 the other one.
void add_step(const Settings& settings, std::size_t side, const Step& step, const Measured& measured, Part& compiles,
              Part& runs) {
  const Compiled compiled{program_path(settings, step.model, growing_machine, step.size), growing_machine};
  Words compile_line = compile_words(settings, step.model, compiled, step.size);
  compile_line.insert(compile_line.end(), measured.options.begin(), measured.options.end());
  const Words run_line = run_words(settings, compiled, level, step.threads);
  if (measured.run) process_seconds(compile_line);
  compiles.timed.at(side).emplace_back([compile_line] { return process_seconds(compile_line); });
  runs.timed.at(side).emplace_back([&settings, run_line] { return run(settings, run_line).wall; });
  if (side != 0) return;
  compiles.growth.command = command_text(compile_line);
  runs.growth.command = command_text(run_line);
}

Growth measure(Part part, const std::vector<Step>& steps, const Rounds& rounds) {
  const std::vector<Compared> seconds = compare_in_turn(part.timed[0], part.timed[1], rounds);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    part.growth.points.push_back({steps[i].x, seconds[i].seconds});
    if (seconds[i].other) part.growth.others.push_back({steps[i].x, seconds[i].other->seconds});
  }
  return part.growth;
}

/// Measures all steps in turns: whole compilations, runs, or both.
std::vector<Growth> growth_of(const Settings& settings, const std::string& against, const std::vector<Step>& steps,
                              const Measured& measured) {
  Part compiles{{against, "compile", {}, {}}, {}};
  Part runs{{against, "run", {}, {}}, {}};
  const std::vector<Settings> sides = build_settings(settings);
  for (std::size_t side = 0; side < sides.size(); ++side) {
    for (const Step& step : steps) add_step(sides[side], side, step, measured, compiles, runs);
  }
  std::vector<Growth> growths;
  if (measured.compile) growths.push_back(measure(std::move(compiles), steps, settings.rounds));
  if (measured.run) growths.push_back(measure(std::move(runs), steps, settings.rounds));
  return growths;
}

std::filesystem::path sphere(const Settings& settings, unsigned fragments) {
  return put_model(settings, fmt::format("sphere_{}", sphere_halfspaces(fragments)), drilled_sphere(fragments));
}

std::vector<Growth> halfspaces(const Settings& settings) {
  std::vector<Step> steps;
  for (const unsigned fragments : {16U, 32U, 64U, 128U})
    steps.push_back({static_cast<double>(sphere_halfspaces(fragments)), sphere(settings, fragments), settings.size});
  return growth_of(settings, "half-spaces", steps, {});
}

std::vector<Growth> primitives(const Settings& settings) {
  std::vector<Step> steps;
  for (const unsigned cubes : {16U, 64U, 256U, 1024U}) {
    steps.push_back({static_cast<double>(cubes),
                     put_model(settings, fmt::format("grid_{}", cubes), grid_of_cubes(cubes)), settings.size});
  }
  return growth_of(settings, "primitives", steps, {});
}

std::vector<Growth> pixels(const Settings& settings) {
  std::vector<Step> steps;
  for (const unsigned side : {128U, 256U, 512U, 1024U})
    steps.push_back({static_cast<double>(side) * side, sphere(settings, 32), fmt::format("{0}x{0}", side)});
  return growth_of(settings, "pixels", steps, {.compile = false});
}

/// Up to as many threads as cores, at a size with enough work for them.
std::vector<Growth> threads(const Settings& settings) {
  std::vector<Step> steps;
  for (unsigned count = 1; count <= std::max(std::thread::hardware_concurrency(), 2U); count *= 2)
    steps.push_back({static_cast<double>(count), sphere(settings, 32), "2048x2048", count});
  return growth_of(settings, "threads", steps, {.compile = false});
}

/// The last decade of trees whose depth equals their number of primitives, with enough memory for classification.
std::vector<Growth> depth(const Settings& settings) {
  std::vector<Step> steps;
  for (const unsigned levels : {10'000U, 31'623U, 100'000U}) {
    steps.push_back({static_cast<double>(levels),
                     put_model(settings, fmt::format("deep_{}", levels), deep_tree(levels)), settings.size});
  }
  return growth_of(settings, "depth", steps, {.run = false, .options = {"--memory-bits", "4096"}});
}

}  // namespace

std::vector<Growth> measure_growths(const Settings& settings) {
  std::vector<Growth> all;
  for (const auto& family : {halfspaces, primitives, depth, pixels, threads}) {
    for (Growth& growth : family(settings)) all.push_back(std::move(growth));
  }
  return all;
}

}  // namespace csgsim::bench

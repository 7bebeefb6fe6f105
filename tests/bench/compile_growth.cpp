// bench_compile_growth: growth of the compile time with a model's size, from its text to the Program. For each kind of
// model, prints the complexity that fits best (BigO), where N is primitives, or half-spaces for balls.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "host/facet/geometry.h"
#include "host/read/read.h"
#include "host/view/camera.h"
#include "tests/performance/subjects.h"
#include "tests/support/drawing.h"

namespace {

using namespace csgsim;

std::string moved(double x, double y, double z, const std::string& solid) {
  return fmt::format("multmatrix([[1,0,0,{:.6g}],[0,1,0,{:.6g}],[0,0,1,{:.6g}],[0,0,0,1]]){{{}}}\n", x, y, z, solid);
}

/// Random places in a cube whose size grows with their number, so that the density is constant.
class Places {
 public:
  explicit Places(std::int64_t count) : side_(0.0, 2.0 * std::cbrt(static_cast<double>(count))) {}

  std::string put(const std::string& solid) {
    const double x = side_(random_);
    const double y = side_(random_);
    return moved(x, y, side_(random_), solid);
  }

 private:
  std::mt19937_64 random_{1987};
  std::uniform_real_distribution<double> side_;
};

/// A union of cubes that do not touch.
std::string grid(std::int64_t count) {
  const auto side = static_cast<std::int64_t>(std::ceil(std::cbrt(static_cast<double>(count))));
  std::string text = "union(){\n";
  for (std::int64_t i = 0; i < count; ++i) {
    const auto at = [&](std::int64_t place) { return 2.0 * static_cast<double>(place % side); };
    text += moved(at(i), at(i / side), at(i / side / side), "cube(size=[1,1,1],center=true);");
  }
  return text + "}";
}

/// A plate with hexagonal holes.
std::string plate(std::int64_t count) { return bench::drilled_plate(static_cast<unsigned>(count - 1), 6, 0.6); }

/// Solids minus others, all overlapping in the picture and many in space.
std::string bodies(std::int64_t count) {
  Places places(count);
  std::string text = "union(){\n";
  for (std::int64_t i = 0; i < count; i += 2) {
    text += "difference(){" + places.put("cube(size=[3,2,2],center=true);sphere($fn=6,r=1.5);") +
            places.put("cylinder($fn=8,h=4,r1=2,r2=1,center=true);") + "}";
  }
  return text + "}";
}

std::string deep(std::int64_t count) { return bench::deep_tree(static_cast<unsigned>(count)); }

constexpr std::int64_t halfspaces_of_ball = 45 * 23 + 2;

/// Several balls with a total of `halfspaces` half-spaces.
std::string balls(std::int64_t halfspaces) {
  const std::int64_t count = halfspaces / halfspaces_of_ball;
  Places places(count);
  std::string text = "union(){\n";
  for (std::int64_t i = 0; i < count; ++i) text += places.put("sphere($fn=45,r=1);");
  return text + "}";
}

/// One ball with `halfspaces` half-spaces.
std::string ball(std::int64_t halfspaces) {
  return fmt::format("sphere($fn={},r=10);", std::llround(std::sqrt(2.0 * static_cast<double>(halfspaces))));
}

template <std::string (*make)(std::int64_t)>
void compile(benchmark::State& state) {
  const std::string text = make(state.range(0));
  // The whole model from a fixed side, with enough memory for any classification.
  testing::Setup setup{{{1, -1, 1}, {0, 0, 0}, view::Projection::orthographic}, {}, 4096};
  const model::Tree tree = read::read_csg_text(text, "bench");
  const facet::Box box = facet::make_geometry(tree).box;
  setup.camera = view::default_camera(box, setup.sampling.width, setup.sampling.height);
  std::size_t instructions = 0;
  for (auto _ : state) {
    const testing::Compiled compiled = testing::compile_text(text, setup);
    instructions = compiled.program.segments.front().instructions.size();
    benchmark::DoNotOptimize(instructions);
  }
  state.counters["instructions"] = static_cast<double>(instructions);
  state.SetComplexityN(state.range(0));
}

constexpr std::int64_t fewest_primitives = 1'000;
constexpr std::int64_t most_primitives = 100'000;
constexpr std::int64_t fewest_halfspaces = 10'000;
constexpr std::int64_t most_halfspaces = 1'000'000;

void primitives(benchmark::internal::Benchmark* bench) {
  bench->RangeMultiplier(10)->Range(fewest_primitives, most_primitives)->Unit(benchmark::kMillisecond)->Complexity();
}

void halfspaces(benchmark::internal::Benchmark* bench) {
  bench->RangeMultiplier(10)->Range(fewest_halfspaces, most_halfspaces)->Unit(benchmark::kMillisecond)->Complexity();
}

BENCHMARK(compile<grid>)->Name("grid of cubes")->Apply(primitives);
BENCHMARK(compile<plate>)->Name("plate with holes")->Apply(primitives);
BENCHMARK(compile<bodies>)->Name("bodies with cuts")->Apply(primitives);
BENCHMARK(compile<deep>)->Name("deep tree")->Apply(primitives);
BENCHMARK(compile<balls>)->Name("balls")->Apply(halfspaces);
BENCHMARK(compile<ball>)->Name("one ball")->Apply(halfspaces);

}  // namespace

BENCHMARK_MAIN();

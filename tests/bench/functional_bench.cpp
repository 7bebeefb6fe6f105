// Speed of the functional engine on Programs like those that the host emits: simulated seconds a wall second, at 10
// MHz.

#include <benchmark/benchmark.h>

#include <array>
#include <random>

#include "hw/isa/opcodes.h"
#include "hw/isa/validate.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_planes/kind.h"
#include "sim/engine/engine.h"

namespace {

using namespace csgsim;
using isa::Field;
using isa::Instruction;
using isa::Opcode;

constexpr std::uint32_t side = 512;  // pixels
constexpr std::uint64_t clock_hz = 10'000'000;
constexpr std::size_t instructions = 30'000;
constexpr Field z1{0, 20};
constexpr Field z2{20, 20};
constexpr Field colour{40, 24};
constexpr Field drawn{64, 1};
constexpr Field inside{65, 1};
constexpr Field seen{66, 1};

machines::Machine machine() {
  machines::Machine result = machines::blank(pixel_planes::kind);
  result.name = "bench";
  result.array = {side, side, 72};
  result.clock_hz = clock_hz;
  return result;
}

class ProgramMaker {
 public:
  /// Primitives whose boxes are up to `largest` pixels wide and high.
  explicit ProgramMaker(std::int64_t largest) : largest_(largest) {}

  isa::Program make() {
    isa::Program program;
    program.shape = machine().array;
    program.segments.push_back({{0, 0, side, side}, {}});
    out_ = &program.segments[0].instructions;
    put(Opcode::enable_all);
    put_constant(z2, 0xfffff);
    put_constant(colour, 0);
    while (out_->size() < instructions) primitive();
    isa::validate(program);
    return program;
  }

 private:
  void put(Opcode opcode, Field first = {}, Field second = {}, Field third = {}) {
    Instruction& instruction = out_->emplace_back();
    instruction.opcode = opcode;
    instruction.fields = {first, second, third};
  }
  void put_constant(Field field, std::uint64_t constant) {
    put(Opcode::set_constant, field);
    out_->back().constant = constant;
  }
  void put_edge(std::int64_t a, std::int64_t b, std::int64_t c) {
    put(Opcode::edge_not_negative);
    out_->back().linear = {a, b, c, 22, 0};
  }
  std::int64_t any(std::int64_t least, std::int64_t most) {
    return std::uniform_int_distribution<std::int64_t>(least, most)(random_);
  }

  /// A plane through about the middle of the box and of the depths, up to 1000 steps of depth a pixel.
  void put_plane(Opcode opcode, Field field) {
    const std::int64_t a = any(-1000 << 12, 1000 << 12);
    const std::int64_t b = any(-1000 << 12, 1000 << 12);
    const std::int64_t z = any(400'000, 600'000) << 12;
    put(opcode, field);
    out_->back().linear = {a, b, z - a * x_ - b * y_, 34, 12};
  }

  void box() {
    const std::int64_t width = any(4, largest_);
    const std::int64_t height = any(4, largest_);
    const std::int64_t left = any(0, side - width);
    const std::int64_t top = any(0, side - height);
    put(Opcode::enable_all);
    put_edge(1, 0, -left);
    put_edge(-1, 0, left + width - 1);
    put_edge(0, 1, -top);
    put_edge(0, -1, top + height - 1);
    x_ = left + width / 2;
    y_ = top + height / 2;
  }

  /// Rendered, compared with four others, merged.
  void primitive() {
    box();
    put(Opcode::enable_store, drawn);
    put_plane(Opcode::load_linear, z1);
    for (int i = 0; i < 4; ++i) put_plane(Opcode::keep_max, z1);
    for (int i = 0; i < 4; ++i) put_plane(Opcode::linear_gt, z1);
    put(Opcode::enable_store, drawn);
    put_constant(seen, 1);
    for (int other = 0; other < 4; ++other) {
      put(Opcode::enable_load, drawn);
      put_constant(inside, 0);
      for (int i = 0; i < 3; ++i) put_plane(Opcode::linear_le, z1);
      for (int i = 0; i < 3; ++i) put_plane(Opcode::linear_gt, z1);
      put_constant(inside, 1);
      put(Opcode::enable_load, drawn);
      put(Opcode::bit_and_not, seen, seen, inside);
    }
    put(Opcode::enable_load, drawn);
    put(Opcode::enable_and, seen);
    put(Opcode::field_lt, z1, z2);
    put(Opcode::copy, z2, z1);
    for (int i = 0; i < 5; ++i) {
      put_plane(Opcode::linear_eq, z1);
      put_constant(colour, static_cast<std::uint64_t>(any(0, 0xffffff)));
      put(Opcode::enable_load, drawn);
      put(Opcode::enable_and, seen);
    }
  }

  std::int64_t largest_;
  std::mt19937_64 random_{1};
  std::vector<Instruction>* out_ = nullptr;
  std::int64_t x_ = 0;
  std::int64_t y_ = 0;
};

/// As the stats do.
class Counter final : public engine::Observer {
 public:
  void after_instruction(const engine::Step& step, const engine::PixelState&) override {
    clocks_of_[static_cast<std::size_t>(step.instruction.opcode)] += step.clocks;
    enabled += step.enabled_pixels;
  }
  std::uint64_t enabled = 0;

 private:
  std::array<std::uint64_t, isa::opcode_table.size()> clocks_of_{};
};

void run_boxes(benchmark::State& state) {
  const isa::Program program = ProgramMaker(state.range(0)).make();
  const auto engine = engine::make_functional_engine(machine());
  std::uint64_t clocks = 0;
  std::uint64_t enabled = 0;
  for (auto unused : state) {
    static_cast<void>(unused);
    Counter counter;
    const std::vector<engine::Observer*> observers{&counter};
    clocks += engine->run(program, observers).clocks;
    enabled += counter.enabled;
  }
  const double simulated_seconds = static_cast<double>(clocks) / static_cast<double>(clock_hz);
  const auto runs = static_cast<double>(state.iterations());
  state.counters["clocks"] = static_cast<double>(clocks) / runs;
  state.counters["pixels_an_instruction"] =
      static_cast<double>(enabled) / runs / static_cast<double>(program.segments[0].instructions.size());
  state.counters["simulated_s_a_wall_s"] = benchmark::Counter(simulated_seconds, benchmark::Counter::kIsRate);
}

BENCHMARK(run_boxes)->ArgName("largest_box")->Arg(50)->Arg(100)->Arg(200)->Arg(400)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();

// SystemC elaborates once per process, so ctest runs each case here in a separate process.

#include "hw/isa/opcodes.h"
#include "hw/machines/regions.h"
#include "hw/pixel_planes/kind.h"
#include "hw/pixel_square/figures.h"
#include "hw/pixel_square/kind.h"
#include "sim/engine/engine.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

using isa::Instruction;
using isa::Opcode;

constexpr isa::Field counter{0, 8};
constexpr isa::Instruction enable_all{.opcode = Opcode::enable_all};

Instruction constant(std::uint64_t value) {
  return {.opcode = Opcode::set_constant, .fields = {counter}, .constant = value};
}

/// Four squares of 4x4, two renderers.
machines::Machine machine_8x8() {
  machines::Machine machine = machines::blank_machine(pixel_square::kind);
  machine.name = "squares";
  machine.array = {4, 4, 16};
  machine.picture = {8, 8};
  machine.clock_hz = 10'000'000;
  machine.link = {.width = 32, .word_clocks = 3, .fifo_depth = 64, .latency = 0};
  machine.own = pixel_square::Figures{.renderers = 2, .buffers = 2, .port_bits = 8, .port_fifo_depth = 64};
  return machine;
}

/// The first square counts to 40, the second and the last count to 2, and the third has no instructions. The link is so
/// slow that the second is finished when the last is sent, long before the first.
isa::Program slow_square_first() {
  isa::Program program;
  program.shape = {8, 8, 16};
  program.colour = counter;
  program.background = 7;
  for (const isa::Region& region : machines::regions(machine_8x8()))
    program.segments.push_back({.region = region, .instructions = {}});
  const auto count_to = [&](std::size_t segment, std::uint64_t last) {
    std::vector<Instruction>& instructions = program.segments[segment].instructions;
    instructions.push_back(enable_all);
    for (std::uint64_t value = 1; value <= last; ++value) instructions.push_back(constant(value));
  };
  count_to(0, 40);
  count_to(1, 2);
  count_to(3, 2);
  return program;
}

/// Records the order of events, and the values of a field if it reads.
class Watch : public engine::Observer {
 public:
  explicit Watch(bool reads) : reads_(reads) {}

  [[nodiscard]] bool reads_after(const Instruction& /*instruction*/) const override { return reads_; }

  void after_instruction(const engine::Step& step, const engine::PixelState& state) override {
    steps.emplace_back(step.segment, step.index);
    if (reads_) values.push_back(value_of(state));
  }

  void after_segment(std::uint32_t segment, const engine::PixelState& state) override {
    ends.push_back(segment);
    last_values.push_back(value_of(state));
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> steps;
  std::vector<std::uint32_t> ends;
  std::vector<std::uint32_t> values;
  std::vector<std::uint32_t> last_values;

 private:
  static std::uint32_t value_of(const engine::PixelState& state) {
    std::vector<std::uint32_t> field(std::size_t{state.region().width} * state.region().height);
    state.read_field(counter, field);
    return field.back();
  }

  bool reads_;
};

class Thrower final : public engine::Observer {
 public:
  void after_segment(std::uint32_t segment, const engine::PixelState& /*state*/) override {
    if (segment == 1) throw std::runtime_error("enough");
  }
};

}  // namespace

TEST_CASE("an observer sees squares in Program order although later ones finish first") {
  const isa::Program program = slow_square_first();
  std::vector<std::pair<std::uint32_t, std::uint32_t>> steps;
  std::vector<std::uint32_t> values;
  for (const auto& [segment, last] : {std::pair{0U, 40U}, {1U, 2U}, {3U, 2U}}) {
    for (std::uint32_t i = 0; i <= last; ++i) {
      steps.emplace_back(segment, i);
      values.push_back(i);
    }
  }
  const auto engine = engine::make_cycle_engine(machine_8x8());
  for (const bool reads : {true, false}) {
    Watch watch(reads);
    engine::Observer* const observers[] = {&watch};
    const engine::RunResult result = engine->run(program, observers);
    CHECK(watch.steps == steps);
    CHECK(watch.ends == std::vector<std::uint32_t>{0, 1, 2, 3});
    CHECK(watch.last_values == std::vector<std::uint32_t>{40, 2, 0, 2});
    if (reads) CHECK(watch.values == values);
    CHECK(result.account.count("squares of renderer 0") == 1);
    CHECK(result.account.count("squares of renderer 1") == 2);
  }
}

TEST_CASE("the frame buffer shows each square in place and the background elsewhere") {
  const engine::RunResult result = engine::make_cycle_engine(machine_8x8())->run(slow_square_first(), {});
  REQUIRE(result.scanned_out.size() == 64);
  for (std::size_t i = 0; i < 64; ++i) {
    const std::uint32_t expected[] = {40, 2, 7, 2};
    CHECK(result.scanned_out[i] == expected[i / 32 * 2 + i % 8 / 4]);
  }
}

TEST_CASE("a second frame on a pixel-square machine takes the same clocks as the first") {
  const auto engine = engine::make_cycle_engine(machine_8x8());
  const engine::RunResult first = engine->run(slow_square_first(), {});
  const engine::RunResult second = engine->run(slow_square_first(), {});
  CHECK(first.clocks == second.clocks);
  CHECK(first.account == second.account);
}

TEST_CASE("run() rethrows an observer's exception and the next frame is drawn correctly") {
  const auto engine = engine::make_cycle_engine(machine_8x8());
  Thrower thrower;
  engine::Observer* const observers[] = {&thrower};
  CHECK_THROWS_WITH_AS(engine->run(slow_square_first(), observers), "enough", std::runtime_error);
  CHECK(engine->run(slow_square_first(), {}).scanned_out.back() == 2);
}

TEST_CASE("rejects a Program that omits squares of the picture on a pixel-square machine") {
  const auto engine = engine::make_cycle_engine(machine_8x8());
  isa::Program program = slow_square_first();
  program.segments.pop_back();
  CHECK_THROWS_AS(engine->run(program, {}), InputError);
}

TEST_CASE("both levels reject a global-OR query before they run") {
  isa::Program program = slow_square_first();
  program.segments[3].instructions.push_back({.opcode = Opcode::global_or});
  Watch watch(true);
  engine::Observer* const observers[] = {&watch};
  CHECK_THROWS_AS(engine::make_cycle_engine(machine_8x8())->run(program, observers), InputError);
  CHECK_THROWS_AS(engine::make_functional_engine(machine_8x8())->run(program, observers), InputError);
  CHECK(watch.steps.empty());
}

TEST_CASE("rejects a Program that needs more pixel memory than the machine has") {
  isa::Program program = slow_square_first();
  program.shape.memory_bits = 17;
  CHECK_THROWS_AS(engine::make_cycle_engine(machine_8x8())->run(program, {}), InputError);
}

TEST_CASE("rejects a second clocked machine of other parameters or kind in one process") {
  const auto first = engine::make_cycle_engine(machine_8x8());
  CHECK_NOTHROW(engine::make_cycle_engine(machine_8x8()));
  machines::Machine other = machine_8x8();
  other.link.fifo_depth = 5;
  CHECK_THROWS_AS(engine::make_cycle_engine(other), std::logic_error);
  CHECK_THROWS_AS(engine::make_cycle_engine(machines::blank_machine(pixel_planes::kind)), std::logic_error);
}

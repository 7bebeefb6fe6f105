#include "tests/lockstep/lockstep.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "hw/machines/clocks.h"

namespace csgsim::test {

namespace {

constexpr unsigned slice_width = 32;

Boundary boundary_of(const sim::Step& step, const sim::PixelState& state, std::uint32_t memory_bits) {
  const isa::Region region = state.region();
  Boundary boundary{.segment = step.segment,
                    .index = step.index,
                    .clocks = step.clocks,
                    .enabled_pixels = step.enabled_pixels,
                    .enable = std::vector<std::uint64_t>((region.width + 63U) / 64U * region.height),
                    .memory = {}};
  state.read_enable(boundary.enable);
  for (unsigned base = 0; base < memory_bits; base += slice_width) {
    const isa::Field slice{static_cast<std::uint16_t>(base),
                           static_cast<std::uint16_t>(std::min(slice_width, memory_bits - base))};
    state.read_field(slice, boundary.memory.emplace_back(std::size_t{region.width} * region.height));
  }
  return boundary;
}

/// Keeps every boundary of a run.
class Recorder final : public sim::Observer {
 public:
  explicit Recorder(std::uint32_t memory_bits) : memory_bits_(memory_bits) {}

  void after_instruction(const sim::Step& step, const sim::PixelState& state) override {
    boundaries.push_back(boundary_of(step, state, memory_bits_));
  }
  void after_segment(std::uint32_t segment, const sim::PixelState& /*state*/) override { segments.push_back(segment); }

  std::vector<Boundary> boundaries;
  std::vector<std::uint32_t> segments;

 private:
  std::uint32_t memory_bits_;
};

std::string what_differs(const Boundary& expected, const Boundary& actual) {
  if (expected.clocks != actual.clocks) return fmt::format("{} clocks, not {}", actual.clocks, expected.clocks);
  if (expected.enabled_pixels != actual.enabled_pixels) {
    return fmt::format("{} enabled pixels, not {}", actual.enabled_pixels, expected.enabled_pixels);
  }
  if (expected.enable != actual.enable) return "enable";
  for (std::size_t slice = 0; slice < expected.memory.size(); ++slice) {
    const auto& [a, b] = std::pair(expected.memory[slice], actual.memory[slice]);
    const auto [at, other] = std::mismatch(a.begin(), a.end(), b.begin());
    if (at == a.end()) continue;
    return fmt::format("memory from bit {} of pixel {}: {:#x}, not {:#x}", slice * slice_width, at - a.begin(), *other,
                       *at);
  }
  return "order";
}

void require(bool holds, const std::string& text) {
  if (!holds) throw Difference(text);
}

void check_boundary(const Boundary& expected, const Boundary& actual, const isa::Program& program,
                    std::string_view level) {
  if (expected == actual) return;
  const isa::Instruction& instruction = program.segments[expected.segment].instructions[expected.index];
  throw Difference(fmt::format("{} engine, segment {} instruction {} ({}): {}", level, expected.segment, expected.index,
                               isa::info(instruction.opcode).name, what_differs(expected, actual)));
}

/// Returns the sum of the instructions' clocks.
std::uint64_t check_clocks(const Recorder& run, const isa::Program& program, const machines::Machine& machine,
                           std::string_view level) {
  std::uint64_t sum = 0;
  for (const Boundary& boundary : run.boundaries) {
    const isa::Instruction& instruction = program.segments[boundary.segment].instructions[boundary.index];
    require(boundary.clocks == machines::clocks(instruction, machine),
            fmt::format("{} engine: {} clocks for {}", level, boundary.clocks, isa::info(instruction.opcode).name));
    sum += boundary.clocks;
  }
  return sum;
}

void check_sum(const sim::RunResult& result, std::uint64_t sum, const machines::Machine& machine,
               std::string_view level) {
  require(result.latency_clocks == machines::evaluator_latency(machine.array),
          fmt::format("{} engine: latency {}", level, result.latency_clocks));
  require(result.clocks == sum + result.latency_clocks,
          fmt::format("{} engine: {} clocks in all, {} by instruction", level, result.clocks, sum));
}

/// The runs of two engines, and the sums of their instructions' clocks.
struct Runs {
  Results results;
  std::uint64_t judge_sum = 0;
  std::uint64_t engine_sum = 0;
};

Runs run_both(sim::Engine& judge, sim::Engine& engine, const isa::Program& program, const machines::Machine& machine) {
  Recorder expected(program.shape.memory_bits);
  Recorder actual(program.shape.memory_bits);
  sim::Observer* const expected_observers[] = {&expected};
  sim::Observer* const actual_observers[] = {&actual};
  Runs runs{
      .results = {.judge = judge.run(program, expected_observers), .engine = engine.run(program, actual_observers)}};

  require(expected.boundaries.size() == actual.boundaries.size(),
          fmt::format("{} instruction boundaries, not {}", actual.boundaries.size(), expected.boundaries.size()));
  for (std::size_t i = 0; i < expected.boundaries.size(); ++i) {
    check_boundary(expected.boundaries[i], actual.boundaries[i], program, engine.level());
  }
  require(expected.segments == actual.segments, "the ends of the segments differ");
  require(runs.results.judge.answers == runs.results.engine.answers, "the answers differ");
  runs.judge_sum = check_clocks(expected, program, machine, judge.level());
  runs.engine_sum = check_clocks(actual, program, machine, engine.level());
  return runs;
}

}  // namespace

void check_lockstep(sim::Engine& judge, sim::Engine& engine, const isa::Program& program,
                    const machines::Machine& machine) {
  const Runs runs = run_both(judge, engine, program, machine);
  check_sum(runs.results.judge, runs.judge_sum, machine, judge.level());
  check_sum(runs.results.engine, runs.engine_sum, machine, engine.level());
}

Results check_boundaries(sim::Engine& judge, sim::Engine& engine, const isa::Program& program,
                         const machines::Machine& machine) {
  return run_both(judge, engine, program, machine).results;
}

machines::Machine machine_of(isa::ArrayShape shape, std::uint32_t memory_reads) {
  machines::Machine machine;
  machine.name = fmt::format("test-{}x{}x{}-{}", shape.width, shape.height, shape.memory_bits, memory_reads);
  machine.array = shape;
  machine.clock_hz = 10'000'000;
  machine.memory_reads = memory_reads;
  return machine;
}

}  // namespace csgsim::test

#include "tests/lockstep/lockstep.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/machines/timing.h"
#include "hw/pixel_planes/kind.h"

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
                               isa::name_of(instruction.opcode), what_differs(expected, actual)));
}

std::size_t instructions_of(const isa::Program& program) {
  return std::accumulate(
      program.segments.begin(), program.segments.end(), std::size_t{0},
      [](std::size_t sum, const isa::Segment& segment) { return sum + segment.instructions.size(); });
}

/// The questions after which the run skipped instructions.
std::vector<machines::Skip> skips_of(const Recorder& run, const isa::Program& program) {
  std::vector<machines::Skip> skips;
  for (const Boundary& boundary : run.boundaries) {
    const isa::Instruction& instruction = program.segments[boundary.segment].instructions[boundary.index];
    const bool skips_if_none = instruction.opcode == isa::Opcode::skip_if_none;
    if (skips_if_none && boundary.enabled_pixels == 0) skips.push_back({boundary.segment, boundary.index});
  }
  return skips;
}

void check_clocks(const sim::RunResult& result, const Recorder& run, const isa::Program& program,
                  const machines::Machine& machine, std::string_view level) {
  for (const Boundary& boundary : run.boundaries) {
    const isa::Instruction& instruction = program.segments[boundary.segment].instructions[boundary.index];
    require(boundary.clocks == machines::clocks(instruction, machine),
            fmt::format("{} engine: {} clocks for {}", level, boundary.clocks, isa::name_of(instruction.opcode)));
  }
  const machines::FrameTiming expected = machines::time_frame(program, machine, skips_of(run, program));
  require(result.clocks == expected.clocks,
          fmt::format("{} engine: {} clocks in all, not {}", level, result.clocks, expected.clocks));
  require(result.latency_clocks == expected.latency_clocks,
          fmt::format("{} engine: latency {}", level, result.latency_clocks));
  require(result.shown_clocks == expected.shown_clocks && result.interval_clocks == expected.interval_clocks,
          fmt::format("{} engine: shown after {} clocks and again after {}, not {} and {}", level, result.shown_clocks,
                      result.interval_clocks, expected.shown_clocks, expected.interval_clocks));
  require(result.account == expected.account, fmt::format("{} engine: another account", level));
  require(run.boundaries.size() + result.skipped == instructions_of(program),
          fmt::format("{} engine: {} instructions carried out and {} skipped, of {}", level, run.boundaries.size(),
                      result.skipped, instructions_of(program)));
}

}  // namespace

Results check_lockstep(sim::Engine& judge, sim::Engine& engine, const isa::Program& program,
                       const machines::Machine& machine) {
  Recorder expected(program.shape.memory_bits);
  Recorder actual(program.shape.memory_bits);
  sim::Observer* const expected_observers[] = {&expected};
  sim::Observer* const actual_observers[] = {&actual};
  sim::RunResult expected_result = judge.run(program, expected_observers);
  sim::RunResult actual_result = engine.run(program, actual_observers);

  require(expected.boundaries.size() == actual.boundaries.size(),
          fmt::format("{} instruction boundaries, not {}", actual.boundaries.size(), expected.boundaries.size()));
  for (std::size_t i = 0; i < expected.boundaries.size(); ++i) {
    check_boundary(expected.boundaries[i], actual.boundaries[i], program, engine.level());
  }
  require(expected.segments == actual.segments, "the ends of the segments differ");
  require(expected_result.overflows == actual_result.overflows,
          fmt::format("{} overflows, not {}", actual_result.overflows, expected_result.overflows));
  require(expected_result.answers == actual_result.answers, "the answers differ");
  check_clocks(expected_result, expected, program, machine, judge.level());
  check_clocks(actual_result, actual, program, machine, engine.level());
  return {std::move(expected_result), std::move(actual_result)};
}

/// Every clock of the frame is accounted for, in every part.
bool adds_up(const sim::RunResult& result) {
  return std::all_of(result.account.parts.begin(), result.account.parts.end(), [&](const machines::PartAccount& part) {
    std::uint64_t sum = 0;
    for (const machines::ActivityClocks& one : part.clocks) sum += one.clocks;
    return sum == result.clocks;
  });
}

std::string show(const sim::RunResult& result) {
  std::string text = fmt::format("{} clocks", result.clocks);
  for (const machines::Count& count : result.account.counts) text += fmt::format(", {} {}", count.value, count.name);
  for (const machines::PartAccount& part : result.account.parts) {
    text += fmt::format("\n  {}:", part.part);
    for (const machines::ActivityClocks& one : part.clocks) text += fmt::format(" {} {}", one.activity, one.clocks);
  }
  return text;
}

machines::Machine machine_of(isa::ArrayShape shape, std::uint32_t memory_reads, std::uint32_t alu_bits) {
  machines::Machine machine = machines::blank(pixel_planes::kind);
  machine.name =
      fmt::format("test-{}x{}x{}-{}-{}", shape.width, shape.height, shape.memory_bits, memory_reads, alu_bits);
  machine.array = shape;
  machine.clock_hz = 10'000'000;
  machine.memory_reads = memory_reads;
  machine.alu_bits = alu_bits;
  return machine;
}

}  // namespace csgsim::test

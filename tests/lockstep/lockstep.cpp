#include "tests/lockstep/lockstep.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

#include "hw/isa/opcodes.h"
#include "hw/machines/clocks.h"
#include "hw/machines/timing.h"
#include "hw/pixel_planes/kind.h"
#include "sim/engine/run.h"
#include "sim/lockstep/lockstep.h"

namespace csgsim::test {

namespace {

/// An instruction's record, without the state after it.
struct Boundary {
  std::uint32_t segment = 0;
  std::uint32_t index = 0;
  std::uint64_t clocks = 0;
  std::uint64_t enabled_pixels = 0;
  std::optional<machines::PixelClocks> at_pixels;
};

/// Records everything about a run except states.
class Recorder final : public engine::Observer {
 public:
  [[nodiscard]] bool reads_after(const isa::Instruction& /*instruction*/) const override { return false; }
  void after_instruction(const engine::Step& step, const engine::PixelState& /*state*/) override {
    boundaries.push_back({step.segment, step.index, step.clocks, step.enabled_pixels, step.at_pixels});
  }
  void after_segment(std::uint32_t segment, const engine::PixelState& /*state*/) override {
    segments.push_back(segment);
  }

  std::vector<Boundary> boundaries;
  std::vector<std::uint32_t> segments;
};

std::string what_differs(const lockstep::Divergence& difference) {
  if (!difference.pixel) {
    const lockstep::TwoValues& other = difference.otherwise.value();
    return fmt::format("{} {}, not {}", other.name, other.a, other.b);
  }
  std::string text = fmt::format("pixel {},{}:", difference.pixel->x, difference.pixel->y);
  for (const lockstep::TwoValues& field : difference.pixel->fields)
    text += fmt::format(" {} {:#x}, not {:#x}", field.name, field.a, field.b);
  return text;
}

void require(bool holds, const std::string& text) {
  if (!holds) throw Difference(text);
}

/// Throws on a difference, where `level` is the engine called A.
void check_states(const std::optional<lockstep::Divergence>& difference, const isa::Program& program,
                  std::string_view level) {
  if (!difference) return;
  const auto [segment, index] = difference->place;
  const isa::Instruction& instruction = program.segments[segment].instructions[index];
  throw Difference(fmt::format("{} engine, segment {} instruction {} ({}): {}", level, segment, index,
                               isa::name_of(instruction.opcode), what_differs(*difference)));
}

std::size_t instructions_of(const isa::Program& program) {
  return std::accumulate(
      program.segments.begin(), program.segments.end(), std::size_t{0},
      [](std::size_t sum, const isa::Segment& segment) { return sum + segment.instructions.size(); });
}

/// The queries after which the run skipped instructions.
std::vector<machines::Skip> skips_of(const Recorder& run, const isa::Program& program) {
  std::vector<machines::Skip> skips;
  for (const Boundary& boundary : run.boundaries) {
    const isa::Instruction& instruction = program.segments[boundary.segment].instructions[boundary.index];
    const bool skips_if_none = instruction.opcode == isa::Opcode::skip_if_none;
    if (skips_if_none && boundary.enabled_pixels == 0) skips.push_back({boundary.segment, boundary.index});
  }
  return skips;
}

/// Checks the clocks against the prediction; `pixel_activity` is taken from the judge's run.
void check_clocks(const engine::RunResult& result, const Recorder& run, const isa::Program& program,
                  const machines::Machine& machine, std::span<const machines::PixelActivity> pixel_activity,
                  std::string_view level) {
  for (const Boundary& boundary : run.boundaries) {
    const isa::Instruction& instruction = program.segments[boundary.segment].instructions[boundary.index];
    require(boundary.clocks == machines::clocks(instruction, machine),
            fmt::format("{} engine: {} clocks for {}", level, boundary.clocks, isa::name_of(instruction.opcode)));
  }
  const std::vector<machines::Skip> skips = skips_of(run, program);
  const machines::FrameTiming expected = machines::time_frame(program, machine, {skips, pixel_activity});
  require(result.clocks == expected.clocks,
          fmt::format("{} engine: {} clocks in total, not {}", level, result.clocks, expected.clocks));
  require(result.latency_clocks == expected.latency_clocks,
          fmt::format("{} engine: latency {}", level, result.latency_clocks));
  require(result.shown_clocks == expected.shown_clocks && result.interval_clocks == expected.interval_clocks,
          fmt::format("{} engine: shown after {} clocks and again after {}, not {} and {}", level, result.shown_clocks,
                      result.interval_clocks, expected.shown_clocks, expected.interval_clocks));
  require(result.account == expected.account, fmt::format("{} engine: the account differs from the prediction", level));
  require(run.boundaries.size() + result.skipped == instructions_of(program),
          fmt::format("{} engine: {} instructions carried out and {} skipped, of {}", level, run.boundaries.size(),
                      result.skipped, instructions_of(program)));
}

}  // namespace

Results check_lockstep(engine::Engine& judge, engine::Engine& engine, const isa::Program& program,
                       const machines::Machine& machine) {
  Recorder expected;
  Recorder actual;
  engine::Observer* const expected_observers[] = {&expected};
  const std::unique_ptr<engine::Run> judged = judge.begin(program);
  lockstep::Lockstep lockstep(program, program, *judged, {}, expected_observers);
  engine::Observer* const actual_observers[] = {&actual, &lockstep};
  engine::RunResult actual_result = engine.run(program, actual_observers);
  lockstep.finish();
  engine::RunResult expected_result = judged->result();

  check_states(lockstep.divergence(), program, engine.level());
  require(expected.boundaries.size() == actual.boundaries.size(),
          fmt::format("{} instruction boundaries, not {}", actual.boundaries.size(), expected.boundaries.size()));
  require(lockstep.compared() == actual.boundaries.size(), "some instruction boundaries were not compared");
  require(expected.segments == actual.segments, "the ends of the segments differ");
  require(expected_result.overflows == actual_result.overflows,
          fmt::format("{} overflows, not {}", actual_result.overflows, expected_result.overflows));
  require(expected_result.answers == actual_result.answers, "the answers differ");
  for (std::size_t i = 0; i < actual.boundaries.size(); ++i)
    require(expected.boundaries[i].at_pixels == actual.boundaries[i].at_pixels, "the clocks at pixels differ");
  check_clocks(expected_result, expected, program, machine, expected_result.pixel_activity, judge.level());
  check_clocks(actual_result, actual, program, machine, expected_result.pixel_activity, engine.level());
  return {std::move(expected_result), std::move(actual_result)};
}

/// Whether every unit accounts for every clock of the frame.
bool is_account_complete(const engine::RunResult& result) {
  return std::all_of(result.account.parts.begin(), result.account.parts.end(), [&](const machines::PartAccount& part) {
    std::uint64_t sum = 0;
    for (const machines::ActivityClocks& one : part.clocks) sum += one.clocks;
    return sum == result.clocks;
  });
}

std::string show(const engine::RunResult& result) {
  std::string text = fmt::format("{} clocks", result.clocks);
  for (const machines::Count& count : result.account.counts) text += fmt::format(", {} {}", count.value, count.name);
  for (const machines::PartAccount& part : result.account.parts) {
    text += fmt::format("\n  {}:", part.part);
    for (const machines::ActivityClocks& one : part.clocks) text += fmt::format(" {} {}", one.activity, one.clocks);
  }
  return text;
}

machines::Machine machine_of(isa::ArrayShape shape, std::uint32_t memory_reads, std::uint32_t alu_bits) {
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.name =
      fmt::format("test-{}x{}x{}-{}-{}", shape.width, shape.height, shape.memory_bits, memory_reads, alu_bits);
  machine.array = shape;
  machine.clock_hz = 10'000'000;
  machine.memory_reads = memory_reads;
  machine.evaluator_degree = 2;
  machine.alu_bits = alu_bits;
  return machine;
}

}  // namespace csgsim::test

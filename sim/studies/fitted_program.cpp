#include "sim/studies/fitted_program.h"

#include <array>
#include <optional>
#include <utility>

#include "host/emit/compile.h"
#include "hw/base/error.h"
#include "hw/base/hash.h"
#include "hw/host/host.h"
#include "hw/isa/operands.h"
#include "hw/machines/kind.h"
#include "sim/functional/clocks.h"
#include "sim/observe/stats_json.h"

namespace csgsim::studies {

namespace {

/// Hash of everything in the segment that affects pixels.
std::uint64_t segment_hash(const isa::Segment& segment) {
  Hash hash;
  const auto add = [&](std::uint64_t number) {
    const std::array<std::uint32_t, 2> words{static_cast<std::uint32_t>(number),
                                             static_cast<std::uint32_t>(number >> 32U)};
    hash.add(words);
  };
  const auto add_two = [&](std::uint32_t high, std::uint32_t low) { add(std::uint64_t{high} << 32U | low); };
  add_two(segment.region.x, segment.region.y);
  add_two(segment.region.width, segment.region.height);
  for (const isa::Instruction& one : segment.instructions) {
    add_two(static_cast<std::uint32_t>(one.opcode), std::uint32_t{one.linear.width} << 16U | one.linear.shift);
    for (const isa::Field& field : one.fields) add_two(field.base, field.width);
    add(static_cast<std::uint64_t>(one.linear.a));
    add(static_cast<std::uint64_t>(one.linear.b));
    add(static_cast<std::uint64_t>(one.linear.c));
    add(one.constant);
  }
  return hash.value();
}

}  // namespace

FittedProgram compile_with_least_memory(const model::Tree& tree, const facet::Geometry& scene, const view::View& view,
                                        machines::Machine machine, const emit::Options& options,
                                        const MemoryGuess& guess) {
  const auto compile = [&](std::uint32_t memory_bits) {
    machine.array.memory_bits = memory_bits;
    return emit::compile(tree, scene, view, machine, options);
  };
  std::optional<isa::Program> program;
  if (guess.likely > 0 && guess.likely <= guess.upper_bound) {
    try {
      program = compile(guess.likely);
    } catch (const InputError&) {
      program.reset();  // too few bits, or no number of bits suffices
    }
  }
  if (!program) program = compile(guess.upper_bound);
  // The positions of fields may depend on the number of available bits, but the number of used bits does not.
  const std::uint32_t used = observe::used_memory_bits(*program);
  if (used != machine.array.memory_bits) program = compile(used);
  return {std::move(*program), std::move(machine)};
}

machines::FrameTiming RunTimer::time(const isa::Program& program, const machines::Machine& machine) {
  return host::time_frame(program, machine, outcome(program, machine));
}

machines::RunOutcome RunTimer::outcome(const isa::Program& program, const machines::Machine& machine) {
  if (!functional::needs_run(program, machine)) return {};
  std::vector<std::uint64_t> key;
  key.reserve(program.segments.size() + 1);
  key.push_back(machine.kind->depends_on_pixels(machine) ? 1 : 0);
  for (const isa::Segment& segment : program.segments) key.push_back(segment_hash(segment));
  return runs_.get(std::move(key), [&] { return functional::make_run_record(program, machine); }).outcome();
}

}  // namespace csgsim::studies

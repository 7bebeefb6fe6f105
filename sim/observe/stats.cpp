#include "sim/observe/stats.h"

#include "hw/isa/facts.h"

namespace csgsim::observe {

namespace {

bool is_plain(const isa::Origin& origin) { return origin.effect == isa::no_effect || origin.effect == 0; }

}  // namespace

Cost& Cost::operator+=(const Cost& other) {
  instructions += other.instructions;
  clocks += other.clocks;
  pixel_operations += other.pixel_operations;
  enabled += other.enabled;
  return *this;
}

StatsObserver::StatsObserver(const isa::Program& program) : primitive_of_piece_(program.facts->primitive_of_piece) {
  for (const isa::Segment& segment : program.segments) {
    pixels_of_segment_.push_back(static_cast<std::uint64_t>(segment.region.width) * segment.region.height);
  }
  stats_.by_primitive.resize(program.facts->primitives.size());
  stats_.plain_by_primitive.resize(program.facts->primitives.size());
  stats_.by_effect.resize(program.facts->compile.effects.size() + 1);
}

void StatsObserver::after_instruction(const engine::Step& step, const engine::PixelState& /*state*/) {
  const isa::Instruction& instruction = step.instruction;
  const machines::PixelClocks alike{step.clocks * pixels_of_segment_[step.segment], step.clocks * step.enabled_pixels};
  const machines::PixelClocks at_pixels = step.at_pixels.value_or(alike);
  const Cost cost{1, step.clocks, at_pixels.all, at_pixels.enabled};
  stats_.total += cost;
  stats_.by_opcode[static_cast<std::size_t>(instruction.opcode)] += cost;
  stats_.by_purpose[static_cast<std::size_t>(instruction.origin.purpose)] += cost;
  if (const std::uint32_t piece = instruction.origin.primitive; piece != isa::no_primitive) {
    const std::uint32_t primitive = primitive_of_piece_.empty() ? piece : primitive_of_piece_[piece];
    stats_.by_primitive[primitive] += cost;
    if (is_plain(instruction.origin)) stats_.plain_by_primitive[primitive] += cost;
  }
  if (instruction.origin.effect != isa::no_effect) {
    stats_.by_effect[instruction.origin.effect] += cost;
  } else {
    (instruction.origin.purpose == isa::Purpose::shade ? stats_.by_effect.front() : stats_.by_effect.back()) += cost;
  }
}

}  // namespace csgsim::observe

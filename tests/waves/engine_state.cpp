#include "tests/waves/engine_state.h"

#include <algorithm>
#include <stdexcept>

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/machines/timeline.h"
#include "hw/machines/timing.h"
#include "sim/engine/engine.h"

namespace csgsim::test {

namespace {

/// Records one pixel after each instruction.
class Watcher final : public engine::Observer {
 public:
  struct State {
    std::uint32_t index = 0;
    std::vector<bool> memory;
    bool enable = false;
  };

  Watcher(std::uint32_t memory_bits, std::uint32_t segment, std::uint32_t x, std::uint32_t y)
      : memory_bits_(memory_bits), segment_(segment), x_(x), y_(y) {}

  void after_instruction(const engine::Step& step, const engine::PixelState& state) override {
    if (step.instruction.opcode == isa::Opcode::skip_if_none && step.enabled_pixels == 0)
      skips.push_back({step.segment, step.index});
    if (step.segment != segment_) return;
    const isa::Region region = state.region();
    const std::size_t pixel = std::size_t{y_ - region.y} * region.width + (x_ - region.x);
    State after{.index = step.index, .memory = std::vector<bool>(memory_bits_), .enable = false};
    std::vector<std::uint32_t> values(std::size_t{region.width} * region.height);
    for (std::uint32_t base = 0; base < memory_bits_; base += 32) {
      const std::uint32_t width = std::min(32U, memory_bits_ - base);
      state.read_field({static_cast<std::uint16_t>(base), static_cast<std::uint16_t>(width)}, values);
      for (std::uint32_t bit = 0; bit < width; ++bit) after.memory[base + bit] = (values[pixel] >> bit & 1U) != 0;
    }
    const std::size_t row = (region.width + 63U) / 64U;
    std::vector<std::uint64_t> enable(row * region.height);
    state.read_enable(enable);
    after.enable = (enable[(y_ - region.y) * row + (x_ - region.x) / 64] >> ((x_ - region.x) % 64) & 1U) != 0;
    states.push_back(std::move(after));
  }

  std::vector<State> states;
  std::vector<machines::Skip> skips;

 private:
  std::uint32_t memory_bits_;
  std::uint32_t segment_;
  std::uint32_t x_;
  std::uint32_t y_;
};

std::uint32_t segment_of(const isa::Program& program, std::uint32_t x, std::uint32_t y) {
  const auto holds = [&](const isa::Segment& segment) {
    const isa::Region& region = segment.region;
    return x >= region.x && x - region.x < region.width && y >= region.y && y - region.y < region.height;
  };
  const auto found = std::find_if(program.segments.begin(), program.segments.end(), holds);
  if (found == program.segments.end()) throw std::invalid_argument("the pixel is outside the picture");
  return static_cast<std::uint32_t>(found - program.segments.begin());
}

bool writes(const isa::Instruction& instruction, isa::Field field) {
  const isa::Operands& operands = isa::operands_of(instruction.opcode);
  for (std::size_t i = 0; i < isa::max_operands; ++i) {
    if (operands[i] == isa::OperandKind::target && instruction.fields[i].overlaps(field)) return true;
  }
  return false;
}

}  // namespace

EngineState::EngineState(const isa::Program& program, const machines::Machine& machine, std::uint32_t x,
                         std::uint32_t y) {
  const std::uint32_t segment = segment_of(program, x, y);
  Watcher watcher(program.shape.memory_bits, segment, x, y);
  engine::Observer* const watchers[] = {&watcher};
  const engine::RunResult run = engine::make_reference_engine(machine)->run(program, watchers);
  const machines::Timeline timeline = machines::timeline(program, machine, {watcher.skips, run.pixel_activity});
  const auto spans = machines::spans_at_pixel(timeline, program, machine, segment, x, y);
  std::uint64_t number = 0;
  for (std::uint32_t s = 0; s < segment; ++s) number += program.segments[s].instructions.size();
  boundaries_.push_back({nullptr, 0, 0, 0, std::vector<bool>(program.shape.memory_bits), false});
  for (const Watcher::State& state : watcher.states) {
    const machines::ClockSpan span = spans[state.index];
    boundaries_.push_back({&program.segments[segment].instructions[state.index], number + state.index, span.begin,
                           span.end, state.memory, state.enable});
  }
  if (boundaries_.size() < 2) throw std::invalid_argument("no instruction works on the pixel");
  boundaries_.front().end = boundaries_[1].begin;
}

std::uint64_t EngineState::first_clock() const { return boundaries_[1].begin; }

const EngineState::Boundary* EngineState::boundary_before(std::uint64_t clock) const {
  const auto after = std::upper_bound(boundaries_.begin(), boundaries_.end(), clock,
                                      [](std::uint64_t at, const Boundary& one) { return at < one.end; });
  return after == boundaries_.begin() || after == boundaries_.end() ? nullptr : &*std::prev(after);
}

std::optional<std::uint64_t> EngineState::field_at(isa::Field field, std::uint64_t clock) const {
  const Boundary* const last = boundary_before(clock);
  if (last == nullptr) return std::nullopt;
  const Boundary& next = *(last + 1);
  if (clock > next.begin && writes(*next.instruction, field)) return std::nullopt;
  std::uint64_t value = 0;
  for (unsigned bit = 0; bit < field.width; ++bit)
    value |= static_cast<std::uint64_t>(last->memory[field.base + bit]) << bit;
  return value;
}

std::optional<bool> EngineState::enable_at(std::uint64_t clock) const {
  const Boundary* const last = boundary_before(clock);
  if (last == nullptr || clock > (last + 1)->begin) return std::nullopt;
  return last->enable;
}

std::optional<std::uint64_t> EngineState::instruction_at(std::uint64_t clock) const {
  const Boundary* const last = boundary_before(clock);
  if (last == nullptr || clock < (last + 1)->begin) return std::nullopt;
  return (last + 1)->number;
}

}  // namespace csgsim::test

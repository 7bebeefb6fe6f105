#include "sim/reference/reference_run.h"

#include <algorithm>

#include "hw/base/interruption.h"
#include "hw/host/host.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/machines/clocks.h"
#include "hw/machines/kind.h"
#include "hw/machines/runs_on.h"

namespace csgsim::reference {

namespace {

constexpr std::uint32_t word_bits = 64;

isa::Field bit_field(std::size_t bit) { return {static_cast<std::uint16_t>(bit), 1}; }

/// The position of a pixel's bit in a plane.
struct Bit {
  std::size_t word;
  unsigned shift;
};

Bit bit_position(std::uint32_t x, std::uint32_t y, std::uint32_t width) {
  const std::size_t words = (width + word_bits - 1) / word_bits;
  return {y * words + x / word_bits, x % word_bits};
}

}  // namespace

ReferenceRun::ReferenceRun(const isa::Program& program, const machines::Machine& machine)
    : program_(program), machine_(machine), numbers_(program), met_(program, machine) {
  machines::check_runs_on(program, machine_);
  if (!program.segments.empty()) begin_segment(0);
}

void ReferenceRun::begin_segment(std::uint32_t segment) {
  result_.overflows += array_.overflows();
  array_ = ReferenceArray(program_.segments[segment].region, program_.shape.memory_bits);
  place_ = {segment, 0};
  is_end_notified_ = false;
}

bool ReferenceRun::is_finished() const {
  return program_.segments.empty() || (is_end_notified_ && place_.segment + 1 == program_.segments.size());
}

void ReferenceRun::advance(std::uint64_t number, std::span<engine::Observer* const> observers) {
  while (!is_finished()) {
    const std::uint64_t next = numbers_.of(place_);
    const bool has_more = place_.index < program_.segments[place_.segment].instructions.size();
    if (has_more && next >= number) return;
    if (has_more) {
      execute(observers);
      continue;
    }
    if (!is_end_notified_) {
      for (engine::Observer* observer : observers) observer->after_segment(place_.segment, array_);
      is_end_notified_ = true;
    }
    if (is_finished() || next >= number) return;
    begin_segment(place_.segment + 1);
  }
}

void ReferenceRun::execute(std::span<engine::Observer* const> observers) {
  throw_if_interrupted();
  const isa::Instruction& instruction = program_.segments[place_.segment].instructions[place_.index];
  const std::uint64_t enabled = array_.enabled_pixels();
  met_.before(place_, instruction, array_);
  array_.execute(instruction);
  met_.after(place_, instruction, array_);
  if (instruction.opcode == isa::Opcode::global_or) result_.answers.push_back(enabled > 0);
  engine::Step step{place_.segment, place_.index, instruction, machines::clocks(instruction, machine_), enabled};
  if (met_.is_needed()) {
    step.at_pixels = machine_.kind->clocks_at_pixels(program_.segments[place_.segment], place_.index, machine_,
                                                     &met_.pixel_activity(place_.segment));
  }
  for (engine::Observer* observer : observers) observer->after_instruction(step, array_);
  if (instruction.opcode == isa::Opcode::skip_if_none && enabled == 0) {
    skips_.push_back({place_.segment, place_.index});
    place_.index += static_cast<std::uint32_t>(instruction.constant);
    result_.skipped += instruction.constant;
  }
  ++place_.index;
}

engine::RunState ReferenceRun::save() const {
  engine::RunState state{
      place_, is_end_notified_, result_.overflows + array_.overflows(), result_.skipped, result_.answers, skips_, {}};
  if (program_.segments.empty()) return state;
  const isa::Region region = array_.region();
  const std::size_t words = (region.width + word_bits - 1) / word_bits * static_cast<std::size_t>(region.height);
  for (std::size_t plane = 0; plane <= program_.shape.memory_bits; ++plane) {
    std::vector<std::uint64_t> bits(words);
    bool any = false;
    for (std::uint32_t y = 0; y < region.height; ++y) {
      for (std::uint32_t x = 0; x < region.width; ++x) {
        const bool one = plane == 0 ? array_.is_enabled(x, y) : array_.read(bit_field(plane - 1), x, y) != 0;
        const Bit at = bit_position(x, y, region.width);
        bits[at.word] |= std::uint64_t{one} << at.shift;
        any = any || one;
      }
    }
    if (!any) bits.clear();
    state.planes.push_back(std::move(bits));
  }
  return state;
}

void ReferenceRun::restore(const engine::RunState& state) {
  met_.jump();
  if (program_.segments.empty()) return;
  begin_segment(state.place.segment);
  place_ = state.place;
  if (const isa::Instruction* const squares = isa::pending_squares(program_.segments[place_.segment], place_.index))
    array_.execute(*squares);
  is_end_notified_ = state.is_end_reported;
  result_.overflows = state.overflows;
  result_.skipped = state.skipped;
  result_.answers = state.answers;
  skips_ = state.skips;
  const isa::Region region = array_.region();
  for (std::size_t plane = 0; plane < state.planes.size(); ++plane) {
    if (state.planes[plane].empty()) continue;
    for (std::uint32_t y = 0; y < region.height; ++y) {
      for (std::uint32_t x = 0; x < region.width; ++x) {
        const Bit at = bit_position(x, y, region.width);
        const bool one = (state.planes[plane][at.word] >> at.shift & 1U) != 0;
        if (plane == 0) {
          array_.write_enable(x, y, one);
        } else {
          array_.write(bit_field(plane - 1), x, y, one ? 1 : 0);
        }
      }
    }
  }
}

/// A run resumed from a saved state lacks the earlier part, so the whole Program is run again.
std::vector<machines::PixelActivity> ReferenceRun::record_pixel_activity() const {
  if (const std::vector<machines::PixelActivity>* const pixel_activity = met_.pixel_activity()) return *pixel_activity;
  ReferenceRun whole(program_, machine_);
  whole.advance(end, {});
  return whole.record_pixel_activity();
}

engine::RunResult ReferenceRun::result() const {
  engine::RunResult result = result_;
  result.overflows += array_.overflows();
  result.skips = skips_;
  result.pixel_activity = record_pixel_activity();
  put(host::time_frame(program_, machine_, engine::run_outcome(result)), result);
  return result;
}

}  // namespace csgsim::reference

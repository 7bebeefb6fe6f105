#include "hw/pixel_planes/probed.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <stdexcept>

#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "hw/machines/clocks.h"
#include "hw/machines/regions.h"
#include "hw/wave/segments.h"

namespace csgsim::pixel_planes {

namespace {

/// Calls visit(segment, index, number of previous global-OR tests) for each executed instruction, until `visit` returns
/// false.
template <class Visit>
void for_each_executed(const isa::Program& program, const std::vector<bool>& answers, Visit visit) {
  std::size_t tests_before = 0;
  for (std::uint32_t s = 0; s < program.segments.size(); ++s) {
    const std::vector<isa::Instruction>& all = program.segments[s].instructions;
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      if (!visit(s, i, tests_before)) return;
      if (!isa::needs_global_or(all[i].opcode)) continue;
      i += static_cast<std::uint32_t>(isa::skipped_instruction_count(all[i], answers.at(tests_before++) ? 1 : 0));
    }
  }
}

}  // namespace

std::optional<Start> find_start_before(const isa::Program& program, const machines::Machine& machine,
                                       const systemc::EarlierRun& earlier, wave::Window window) {
  // One clock more than the pipeline, because the word that the pixels executed last is also traced.
  const std::uint64_t lead = machines::evaluator_latency(machine) + 2;
  std::optional<Start> start;
  std::uint64_t first = 0;  // ordinal of the segment's first instruction
  std::uint32_t segment_before = 0;
  for_each_executed(program, earlier.answers,
                    [&](std::uint32_t segment, std::uint32_t index, std::size_t tests_before) {
                      if (segment != segment_before) first += program.segments[segment_before].instructions.size();
                      segment_before = segment;
                      const std::uint64_t begin = earlier.timeline->issued[segment][index].begin;
                      const bool follows_squares = isa::pending_squares(program.segments[segment], index) != nullptr;
                      if (begin + lead <= window.begin && !follows_squares)
                        start = Start{segment, index, first + index, {}, tests_before, 0};
                      if (start) start->end = first + index + 2 + machine.link.fifo_depth;
                      return begin < window.end;
                    });
  if (start) start->moment = instruction_moment(program, machine, earlier.skips, start->segment, start->index);
  return start;
}

array::PixelReplay replay_until(const isa::Program& program, const std::vector<bool>& answers, const Start& start,
                                const array::PixelReplay& initial) {
  // The last instructions are executed at all pixels, because they usually write every register.
  constexpr std::uint64_t last_ones = 400;
  const auto replayed = [&](bool leaves_out) {
    array::PixelReplay replay = initial;
    std::uint64_t first = 0;  // ordinal of the segment's first instruction
    std::optional<std::uint32_t> begun;
    for_each_executed(program, answers, [&](std::uint32_t s, std::uint32_t i, std::size_t /*tests_before*/) {
      if (begun != s) {
        if (begun) first += program.segments[*begun].instructions.size();
        replay.begin(program.segments[s].region);
        begun = s;
      }
      if (s == start.segment && i == start.index) return false;
      const isa::Instruction& instruction = program.segments[s].instructions[i];
      if (leaves_out && first + i + last_ones < start.ordinal) {
        replay.execute_where_enabled(instruction);
      } else {
        replay.execute(instruction);
      }
      return true;
    });
    return replay;
  };
  array::PixelReplay quick = replayed(true);
  return quick.registers_known() ? quick : replayed(false);
}

array::Place position_in_array(wave::Pixel pixel, const isa::Program& program) {
  const isa::Region& region = program.segments[wave::segment_of(pixel, program)].region;
  return {pixel.x - region.x, pixel.y - region.y};
}

std::uint32_t simulated_pixel_index(const systemc::EarlierRun& earlier, array::Place position) {
  const auto found = std::find(earlier.pixels.begin(), earlier.pixels.end(), position);
  if (found == earlier.pixels.end()) throw std::out_of_range("the probed pixel is not built");
  return static_cast<std::uint32_t>(std::distance(earlier.pixels.begin(), found));
}

isa::Field displayed_field(const isa::Program& program, const machines::Machine& machine) {
  const isa::Field colour = isa::frame_header(program).colour;
  const isa::Field second = machines::second_buffer(colour.width, machine);
  return second.width > 0 ? second : colour;
}

}  // namespace csgsim::pixel_planes

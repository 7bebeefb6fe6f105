#include "sim/story/pixel_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/operands.h"
#include "sim/observe/frame.h"
#include "sim/reference/reference_array.h"

namespace csgsim::story {

namespace {

__extension__ using Wide = __int128;

bool has_linear(const isa::Instruction& instruction) {
  return isa::has_operand(isa::operands_of(instruction.opcode), isa::OperandKind::linear);
}

/// The instruction for an array of this pixel only: the streamed bits of the sum, with preceding squares, become a
/// constant.
struct AtPixel {
  isa::Instruction instruction;
  bool fits = true;
};

AtPixel at_pixel(const isa::Segment& segment, std::size_t index, std::uint32_t x, std::uint32_t y) {
  const isa::Instruction& instruction = segment.instructions[index];
  if (!has_linear(instruction)) return {instruction};
  const isa::Linear& linear = instruction.linear;
  Wide sum = static_cast<Wide>(linear.a) * x + static_cast<Wide>(linear.b) * y + linear.c;
  if (const isa::Instruction* const before = isa::pending_squares(segment, index)) {
    const isa::Linear& squares = before->linear;
    sum += static_cast<Wide>(squares.a) * x * x + static_cast<Wide>(squares.b) * x * y +
           static_cast<Wide>(squares.c) * y * y;
  }
  const unsigned unused = 64U - linear.width;
  const auto low_bits = static_cast<std::uint64_t>(sum) << unused;
  const std::int64_t streamed = static_cast<std::int64_t>(low_bits) >> unused;
  AtPixel one{instruction, streamed == sum || isa::may_exceed_width(instruction.opcode)};
  one.instruction.linear = {0, 0, streamed, linear.width, linear.shift};
  return one;
}

isa::Field target_of(const isa::Program& program, const isa::Instruction& instruction) {
  const bool writes = isa::operands_of(instruction.opcode)[0] == isa::OperandKind::target;
  return writes ? enclosing_named_field(program, instruction.fields[0]) : isa::Field{};
}

/// Value of a field of any width; 0 for no field.
std::uint64_t read_whole(const reference::ReferenceArray& pixel, isa::Field field) {
  std::uint64_t value = 0;
  for (unsigned at = 0; at < field.width; at += isa::max_field_width) {
    const auto width = static_cast<std::uint16_t>(std::min<unsigned>(field.width - at, isa::max_field_width));
    const isa::Field part{static_cast<std::uint16_t>(field.base + at), width};
    value |= std::uint64_t{pixel.read(part, 0, 0)} << at;
  }
  return value;
}

/// Runs the segments that contain a pixel.
class Runner {
 public:
  Runner(const isa::Program& program, std::uint32_t x, std::uint32_t y)
      : program_(program),
        x_(x),
        y_(y),
        place_(static_cast<std::size_t>(y) * program.shape.width + x),
        depth_(isa::find_field(program, isa::FieldRole::depth)),
        frame_(program) {}

  /// `skips` begins with the first skip of the segment, if there is one.
  void run_segment(std::uint32_t number, std::span<const machines::Skip> skips) {
    const isa::Segment& segment = program_.segments[number];
    run_.segments.push_back(number);
    reference::ReferenceArray pixel({x_, y_, 1, 1}, program_.shape.memory_bits);
    for (std::size_t i = 0; i < segment.instructions.size(); ++i) {
      PixelStep step = execute(number, static_cast<std::uint32_t>(i), pixel);
      if (!skips.empty() && skips.front() == machines::Skip{number, step.index}) {
        step.skipped = segment.instructions[i].constant;
        skips = skips.subspan(1);
      }
      i += step.skipped;
      run_.steps.push_back(step);
    }
    frame_.after_segment(number, pixel);
  }

  PixelRun finish() {
    const observe::Frame& frame = frame_.frame();
    run_.nearest = {frame.owner[place_], frame.depth[place_]};
    run_.opaque = frame.opaque_depth.empty() ? run_.nearest
                                             : ShownSurface{frame.opaque_owner[place_], frame.opaque_depth[place_]};
    run_.colour = frame.colour[place_];
    return std::move(run_);
  }

 private:
  PixelStep execute(std::uint32_t number, std::uint32_t index, reference::ReferenceArray& pixel) {
    const isa::Segment& segment = program_.segments[number];
    const isa::Instruction& instruction = segment.instructions[index];
    const AtPixel here = at_pixel(segment, index, x_ - segment.region.x, y_ - segment.region.y);
    const isa::Linear& linear = here.instruction.linear;
    const auto value_of = [&](isa::Field field) { return read_whole(pixel, field); };
    PixelStep step;
    step.segment = number;
    step.index = index;
    step.fits = here.fits;
    step.value = has_linear(instruction) ? linear.c >> linear.shift : 0;
    step.enabled_before = pixel.is_enabled(0, 0);
    step.first_operand = value_of(instruction.fields[0]);
    step.second_operand = value_of(instruction.fields[1]);
    step.target = target_of(program_, instruction);
    step.before = value_of(step.target);
    pixel.execute(here.instruction);
    frame_.after_instruction({number, index, instruction, 0, step.enabled_before ? 1U : 0U}, pixel);
    step.enabled_after = pixel.is_enabled(0, 0);
    step.after = value_of(step.target);
    step.takes_pixel = step.enabled_after && frame_.merges(instruction);
    step.owner = current_owner(pixel);
    return step;
  }

  [[nodiscard]] std::uint32_t current_owner(const reference::ReferenceArray& pixel) const {
    if (const std::uint32_t pane = frame_.pane_owner(place_); pane != observe::no_owner) return pane;
    const bool is_empty = depth_.width > 0 && read_whole(pixel, depth_) == (1ULL << depth_.width) - 1;
    return is_empty ? observe::no_owner : frame_.frame().owner[place_];
  }

  const isa::Program& program_;
  std::uint32_t x_;
  std::uint32_t y_;
  std::size_t place_;
  isa::Field depth_;
  observe::FrameObserver frame_;
  PixelRun run_;
};

}  // namespace

isa::Field enclosing_named_field(const isa::Program& program, isa::Field field) {
  isa::Field smallest = field;
  bool is_found = false;
  for (const isa::NamedField& named : program.facts->fields) {
    const bool is_depth = named.role == isa::FieldRole::depth || named.role == isa::FieldRole::candidate_depth;
    const bool holds =
        is_depth ? named.field == field : named.field.base <= field.base && named.field.end() >= field.end();
    if (!holds || (is_found && named.field.width >= smallest.width)) continue;
    smallest = named.field;
    is_found = true;
  }
  return smallest;
}

PixelRun run_pixel(const isa::Program& program, std::span<const machines::Skip> skips, std::uint32_t x,
                   std::uint32_t y) {
  if (x >= program.shape.width || y >= program.shape.height) {
    throw InputError(fmt::format("there is no pixel {},{} in a picture of {} x {}", x, y, program.shape.width,
                                 program.shape.height));
  }
  Runner runner(program, x, y);
  for (std::uint32_t segment = 0; segment < program.segments.size(); ++segment) {
    const auto begin =
        std::find_if(skips.begin(), skips.end(), [&](const machines::Skip& one) { return one.segment == segment; });
    if (program.segments[segment].region.holds(x, y))
      runner.run_segment(segment, skips.subspan(static_cast<std::size_t>(begin - skips.begin())));
  }
  return runner.finish();
}

}  // namespace csgsim::story

#include "sim/observe/frame.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "hw/isa/opcodes.h"

namespace csgsim::sim {

namespace {

constexpr std::uint32_t word_bits = 64;

std::size_t pixel_count(const isa::Program& program) {
  return static_cast<std::size_t>(program.shape.width) * program.shape.height;
}

/// All ones.
std::uint32_t nothing_in(isa::Field depth) { return static_cast<std::uint32_t>((1ULL << depth.width) - 1); }

std::size_t row_words(const isa::Region& region) { return (region.width + word_bits - 1) / word_bits; }

}  // namespace

FrameObserver::FrameObserver(const isa::Program& program)
    : depth_(isa::field_of(program, isa::FieldRole::depth)),
      colour_(isa::field_of(program, isa::FieldRole::colour)),
      candidate_colour_(isa::field_of(program, isa::FieldRole::candidate_colour)),
      frame_{program.shape.width, program.shape.height,
             std::vector<std::uint32_t>(pixel_count(program), program.background),
             std::vector<std::uint32_t>(pixel_count(program), nothing_in(depth_)),
             std::vector<std::uint32_t>(pixel_count(program), no_owner)} {
  if (candidate_colour_.width > 0) candidate_owner_ = frame_.owner;
  for (const isa::Segment& segment : program.segments) drawn_.push_back(!segment.instructions.empty());
}

void FrameObserver::restore(Gathered gathered) {
  frame_ = std::move(gathered.frame);
  candidate_owner_ = std::move(gathered.candidate_owner);
}

bool FrameObserver::is_merge(const isa::Instruction& instruction) const {
  return instruction.opcode == isa::Opcode::copy && depth_.width > 0 && instruction.fields[0] == depth_;
}

bool FrameObserver::colours_one_of_several(const isa::Instruction& instruction, isa::Field colour) const {
  if (instruction.origin.node == isa::no_node || colour.width == 0) return false;
  const isa::Field& target = instruction.fields[0];
  if (instruction.opcode == isa::Opcode::set_constant && target == colour) return true;
  // Light on curved surfaces is brought there channel by channel.
  return instruction.opcode == isa::Opcode::copy && instruction.origin.purpose == isa::Purpose::shade &&
         target.base >= colour.base && target.end() <= colour.end();
}

bool FrameObserver::reads_after(const isa::Instruction& instruction) const {
  return is_merge(instruction) || colours_one_of_several(instruction, colour_) ||
         colours_one_of_several(instruction, candidate_colour_);
}

void FrameObserver::after_instruction(const Step& step, const PixelState& state) {
  if (!reads_after(step.instruction)) return;
  const isa::Region region = state.region();
  enable_.resize(row_words(region) * region.height);
  state.read_enable(enable_);
  enabled_after(step.instruction, region, enable_);
}

void FrameObserver::enabled_after(const isa::Instruction& instruction, const isa::Region& part,
                                  std::span<const std::uint64_t> words) {
  const std::size_t words_a_row = row_words(part);
  const bool is_candidate = colours_one_of_several(instruction, candidate_colour_);
  const bool from_candidate =
      is_merge(instruction) && instruction.origin.node != isa::no_node && candidate_colour_.width > 0;
  std::vector<std::uint32_t>& owner = is_candidate ? candidate_owner_ : frame_.owner;
  for (std::uint32_t y = 0; y < part.height; ++y) {
    const std::size_t row = static_cast<std::size_t>(part.y + y) * frame_.width + part.x;
    for (std::size_t word = 0; word < words_a_row; ++word) {
      for (std::uint64_t bits = words[y * words_a_row + word]; bits != 0; bits &= bits - 1) {
        const std::size_t at = row + word * word_bits + static_cast<std::size_t>(std::countr_zero(bits));
        owner[at] = from_candidate ? candidate_owner_[at] : instruction.origin.primitive;
      }
    }
  }
}

void FrameObserver::after_segment(std::uint32_t segment, const PixelState& state) {
  if (!drawn_[segment]) return;
  if (depth_.width > 0) {
    place(state, depth_, frame_.depth);
    forget_unseen(state.region());
  }
  if (colour_.width > 0) place(state, colour_, frame_.colour);
}

void FrameObserver::forget_unseen(const isa::Region& region) {
  const std::uint32_t nothing = nothing_in(depth_);
  for (std::uint32_t y = 0; y < region.height; ++y) {
    const std::size_t row = static_cast<std::size_t>(region.y + y) * frame_.width + region.x;
    const std::span depth = std::span(frame_.depth).subspan(row, region.width);
    const std::span owner = std::span(frame_.owner).subspan(row, region.width);
    std::transform(depth.begin(), depth.end(), owner.begin(), owner.begin(),
                   [nothing](std::uint32_t at, std::uint32_t before) { return at == nothing ? no_owner : before; });
  }
}

void FrameObserver::place(const PixelState& state, isa::Field field, std::vector<std::uint32_t>& picture) {
  const isa::Region region = state.region();
  if (region.width == frame_.width && region.height == frame_.height) return state.read_field(field, picture);
  values_.resize(static_cast<std::size_t>(region.width) * region.height);
  state.read_field(field, values_);
  for (std::uint32_t y = 0; y < region.height; ++y) {
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(y) * region.width, region.width,
                picture.begin() + static_cast<std::ptrdiff_t>(region.y + y) * frame_.width + region.x);
  }
}

}  // namespace csgsim::sim

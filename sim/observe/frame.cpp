#include "sim/observe/frame.h"

#include <algorithm>
#include <bit>
#include <string>
#include <string_view>
#include <utility>

#include "hw/base/pages.h"
#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"

namespace csgsim::observe {

namespace {

constexpr std::uint32_t word_bits = 64;

std::size_t pixel_count(const isa::Program& program) {
  return static_cast<std::size_t>(program.shape.width) * program.shape.height;
}

/// The depth of an empty pixel: all ones.
std::uint32_t nothing_in(isa::Field depth) { return static_cast<std::uint32_t>((1ULL << depth.width) - 1); }

std::size_t row_words(const isa::Region& region) { return (region.width + word_bits - 1) / word_bits; }

/// The field of that name of an effect; of width 0 if the effect has none.
isa::Field field_named(const isa::Facts& facts, const std::string& effect, std::string_view name) {
  const auto found = std::find_if(facts.fields.begin(), facts.fields.end(), [&](const isa::NamedField& one) {
    return one.role == isa::FieldRole::effect && one.name == effect + "." + std::string(name);
  });
  return found == facts.fields.end() ? isa::Field{} : found->field;
}

/// Calls visit(first pixel of the picture, number of pixels) for each row of the region.
template <class Visit>
void for_rows(const isa::Region& region, std::uint32_t width, const Visit& visit) {
  for (std::uint32_t y = 0; y < region.height; ++y)
    visit(static_cast<std::size_t>(region.y + y) * width + region.x, region.width);
}

}  // namespace

Frame with_opaque_surfaces(Frame frame) {
  if (frame.opaque_depth.empty()) return frame;
  frame.depth = std::exchange(frame.opaque_depth, {});
  frame.owner = std::exchange(frame.opaque_owner, {});
  return frame;
}

FrameObserver::FrameObserver(const isa::Program& program)
    : depth_(isa::find_field(program, isa::FieldRole::depth)),
      colour_(program.colour),
      candidate_colour_(isa::find_field(program, isa::FieldRole::candidate_colour)),
      frame_{program.shape.width, program.shape.height, filled<std::uint32_t>(pixel_count(program), program.background),
             filled<std::uint32_t>(pixel_count(program), nothing_in(depth_)),
             filled<std::uint32_t>(pixel_count(program), no_owner)} {
  if (candidate_colour_.width > 0) candidate_owner_ = frame_.owner;
  find_panes(program);
  for (const isa::Segment& segment : program.segments) drawn_.push_back(!segment.instructions.empty());
}

void FrameObserver::find_panes(const isa::Program& program) {
  const std::vector<std::string>& effects = program.facts->compile.effects;
  for (std::size_t i = 0; i < effects.size() && nearest_.width == 0 && depth_.width > 0; ++i) {
    nearest_ = field_named(*program.facts, effects[i], "nearest_depth");
    nearest_colour_ = field_named(*program.facts, effects[i], "nearest_colour");
    pane_effect_ = static_cast<std::uint8_t>(i);
  }
  if (nearest_.width == 0) return;
  frame_.opaque_depth = frame_.depth;
  frame_.opaque_owner = frame_.owner;
  panes_ = {frame_.owner, std::vector<std::uint32_t>(pixel_count(program), unread_depth)};
}

void FrameObserver::restore(Gathered gathered) {
  frame_ = std::move(gathered.frame);
  candidate_owner_ = std::move(gathered.candidate_owner);
  panes_ = std::move(gathered.panes);
}

bool FrameObserver::is_merge(const isa::Instruction& instruction) const {
  return instruction.opcode == isa::Opcode::copy && depth_.width > 0 && instruction.fields[0] == depth_;
}

/// Whether the instruction belongs to the view of the camera; pictures in mirrors and samples beside a pixel's centre
/// are charged to the enclosing effect.
bool FrameObserver::writes_panes(const isa::Instruction& instruction) const {
  return nearest_.width > 0 && instruction.origin.effect == pane_effect_ && instruction.fields[0] == nearest_;
}

bool FrameObserver::is_pane_merge(const isa::Instruction& instruction) const {
  return instruction.opcode == isa::Opcode::copy && instruction.origin.purpose == isa::Purpose::merge &&
         writes_panes(instruction);
}

bool FrameObserver::begins_panes(const isa::Instruction& instruction) const {
  return instruction.opcode == isa::Opcode::copy && instruction.fields[1] == depth_ && writes_panes(instruction);
}

bool FrameObserver::colours_pane(const isa::Instruction& instruction) const {
  return instruction.origin.effect == pane_effect_ && colours_one_of_several(instruction, nearest_colour_);
}

bool FrameObserver::compares_panes(const isa::Instruction& instruction) const {
  return instruction.opcode == isa::Opcode::field_lt && instruction.fields[1] == depth_ && writes_panes(instruction);
}

bool FrameObserver::colours_one_of_several(const isa::Instruction& instruction, isa::Field colour) const {
  if (instruction.origin.node == isa::no_node || colour.width == 0) return false;
  const isa::Field& target = instruction.fields[0];
  if (instruction.opcode == isa::Opcode::set_constant && target == colour) return true;
  // light on curved surfaces is copied channel by channel
  return instruction.opcode == isa::Opcode::copy && instruction.origin.purpose == isa::Purpose::shade &&
         target.base >= colour.base && target.end() <= colour.end();
}

bool FrameObserver::reads_after(const isa::Instruction& instruction) const {
  return reads_enable_alone(instruction) || compares_panes(instruction);
}

bool FrameObserver::reads_enable_alone(const isa::Instruction& instruction) const {
  return is_merge(instruction) || colours_one_of_several(instruction, colour_) ||
         colours_one_of_several(instruction, candidate_colour_) || is_pane_merge(instruction) ||
         begins_panes(instruction) || colours_pane(instruction);
}

void FrameObserver::after_instruction(const engine::Step& step, const engine::PixelState& state) {
  if (compares_panes(step.instruction)) return read_pane_depths(state);
  if (!reads_enable_alone(step.instruction)) return;
  const isa::Region region = state.region();
  enable_.resize(row_words(region) * region.height);
  state.read_enable(enable_);
  enabled_after(step.instruction, region, enable_);
}

template <class Take>
void FrameObserver::for_enabled(const isa::Region& part, std::span<const std::uint64_t> words, const Take& take) const {
  const std::size_t words_a_row = row_words(part);
  for (std::uint32_t y = 0; y < part.height; ++y) {
    const std::size_t row = static_cast<std::size_t>(part.y + y) * frame_.width + part.x;
    for (std::size_t word = 0; word < words_a_row; ++word) {
      for (std::uint64_t bits = words[y * words_a_row + word]; bits != 0; bits &= bits - 1)
        take(row + word * word_bits + static_cast<std::size_t>(std::countr_zero(bits)));
    }
  }
}

void FrameObserver::enabled_after(const isa::Instruction& instruction, const isa::Region& part,
                                  std::span<const std::uint64_t> words) {
  const isa::Origin& origin = instruction.origin;
  const bool from_candidate = merges(instruction) && origin.node != isa::no_node && candidate_colour_.width > 0;
  const auto merged = [&](std::size_t at) { return from_candidate ? candidate_owner_[at] : origin.primitive; };
  if (colours_one_of_several(instruction, candidate_colour_)) {
    for_enabled(part, words, [&](std::size_t at) { candidate_owner_[at] = origin.primitive; });
  } else if (is_pane_merge(instruction) || begins_panes(instruction)) {
    const bool is_pane = is_pane_merge(instruction);
    for_enabled(part, words, [&](std::size_t at) {
      panes_.owner[at] = is_pane ? merged(at) : no_owner;
      panes_.depth[at] = unread_depth;
    });
  } else if (colours_pane(instruction)) {
    // layers behind the nearest are coloured in the same field
    for_enabled(part, words, [&](std::size_t at) {
      if (panes_.depth[at] == unread_depth) panes_.owner[at] = origin.primitive;
    });
  } else {
    for_enabled(part, words, [&](std::size_t at) { frame_.owner[at] = merged(at); });
  }
}

void FrameObserver::read_pane_depths(const engine::PixelState& state) {
  const isa::Region region = state.region();
  values_.resize(static_cast<std::size_t>(region.width) * region.height);
  state.read_field(nearest_, values_);
  auto value = values_.begin();
  for_rows(region, frame_.width, [&](std::size_t first, std::uint32_t count) {
    for (std::size_t at = first; at < first + count; ++at, ++value)
      if (panes_.owner[at] != no_owner && panes_.depth[at] == unread_depth) panes_.depth[at] = *value;
  });
}

void FrameObserver::show_panes_in_front(const isa::Region& region) {
  for_rows(region, frame_.width, [&](std::size_t first, std::uint32_t count) {
    for (std::size_t at = first; at < first + count; ++at) {
      frame_.opaque_depth[at] = frame_.depth[at];
      frame_.opaque_owner[at] = frame_.owner[at];
      if (panes_.depth[at] == unread_depth) continue;
      frame_.depth[at] = std::exchange(panes_.depth[at], unread_depth);
      frame_.owner[at] = std::exchange(panes_.owner[at], no_owner);
    }
  });
}

void FrameObserver::after_segment(std::uint32_t segment, const engine::PixelState& state) {
  if (!drawn_[segment]) return;
  if (depth_.width > 0) {
    copy_to_picture(state, depth_, frame_.depth);
    forget_unseen(state.region());
    if (nearest_.width > 0) show_panes_in_front(state.region());
  }
  if (colour_.width > 0) copy_to_picture(state, colour_, frame_.colour);
}

void FrameObserver::forget_unseen(const isa::Region& region) {
  const std::uint32_t nothing = nothing_in(depth_);
  for_rows(region, frame_.width, [&](std::size_t first, std::uint32_t count) {
    const std::span depth = std::span(frame_.depth).subspan(first, count);
    const std::span owner = std::span(frame_.owner).subspan(first, count);
    std::transform(depth.begin(), depth.end(), owner.begin(), owner.begin(),
                   [nothing](std::uint32_t at, std::uint32_t before) { return at == nothing ? no_owner : before; });
  });
}

void FrameObserver::copy_to_picture(const engine::PixelState& state, isa::Field field,
                                    std::vector<std::uint32_t>& picture) {
  const isa::Region region = state.region();
  if (region.width == frame_.width && region.height == frame_.height) return state.read_field(field, picture);
  values_.resize(static_cast<std::size_t>(region.width) * region.height);
  state.read_field(field, values_);
  for (std::uint32_t y = 0; y < region.height; ++y) {
    std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(y) * region.width, region.width,
                picture.begin() + static_cast<std::ptrdiff_t>(region.y + y) * frame_.width + region.x);
  }
}

}  // namespace csgsim::observe

#include "host/emit/parallel.h"

#include <algorithm>
#include <span>

#include "host/emit/comparison.h"
#include "host/emit/strategy.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;

isa::Field field_at(std::size_t base, std::size_t width) {
  return {static_cast<std::uint16_t>(base), static_cast<std::uint16_t>(width)};
}

/// A range of bits of a string that one instruction inverts.
struct Piece {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint64_t pattern = 0;
};

/// Ranges that contain all positions (ascending) in the fewest clocks. Bits between them that stay unchanged are free
/// where the ALU is wide enough to process them in the same clock.
std::vector<Piece> make_pieces(std::span<const std::uint32_t> positions, unsigned alu_bits) {
  std::vector<Piece> pieces;
  std::uint32_t clock_end = 0;  // end of the bits that the ALU processes in the current clock
  for (const std::uint32_t position : positions) {
    if (position >= clock_end) {
      const bool goes_on =
          !pieces.empty() && position == clock_end && position + alu_bits - pieces.back().begin <= isa::max_field_width;
      if (!goes_on) pieces.push_back({position, position, 0});
      clock_end = position + alu_bits;
    }
    Piece& piece = pieces.back();
    piece.end = position + 1;
    piece.pattern |= std::uint64_t{1} << (position - piece.begin);
  }
  return pieces;
}

/// Emits the evaluation of an active tree.
class ParallelEmitter {
 public:
  ParallelEmitter(const Context& context, Broadcast& out, const PlannedSurface& planned)
      : context_(context), out_(out), planned_(planned) {}

  [[nodiscard]] std::uint64_t classified() const { return classified_; }

  /// mask := mask and the operand.
  void narrow_mask_by(std::uint32_t operand) {
    const std::vector<csg::ActiveNode>& nodes = planned_.active.nodes;
    if (nodes[operand].is_leaf) {
      classified_ += emit_intersection(context_, out_, nodes[operand], planned_, context_.layout.mask);
      return;
    }
    const csg::BitString string = csg::make_bit_string(nodes, operand);
    for (std::size_t i = 0; i < string.leaves.size(); ++i) {
      classify(nodes[string.leaves[i]], context_.layout.stack[i]);
    }
    emit_stack(out_, Opcode::enable_load, context_.layout.mask);
    const isa::Field result = context_.layout.stack.front();
    emit_string_levels(out_, string, result.base, context_.machine.alu_bits);
    emit_stack(out_, string.inverted ? Opcode::enable_and_not : Opcode::enable_and, result);
    emit_stack(out_, Opcode::enable_store, context_.layout.mask);
  }

 private:
  /// bit := "Z1 is in the leaf's primitives".
  void classify(const csg::ActiveNode& leaf, isa::Field bit) {
    emit_stack(out_, Opcode::enable_load, context_.layout.mask);
    classified_ += emit_comparison(context_, out_, leaf, planned_);
    emit_stack(out_, Opcode::enable_store, bit);
  }

  const Context& context_;
  Broadcast& out_;
  const PlannedSurface& planned_;
  std::uint64_t classified_ = 0;
};

}  // namespace

unsigned string_bits(const csg::ActiveTree& active) {
  unsigned most = 0;
  for (const std::uint32_t operand : active.operands) {
    if (!active.nodes[operand].is_leaf) most = std::max(most, csg::count_leaves(active.nodes, operand));
  }
  return most;
}

void emit_string_levels(Broadcast& out, const csg::BitString& string, unsigned base, unsigned alu_bits) {
  const std::uint32_t most = isa::max_field_width / alu_bits * alu_bits;  // largest multiple of the ALU's width
  out.origin = {isa::Purpose::stack, out.origin.primitive, isa::no_node};
  for (const csg::StringLevel& level : string.levels) {
    for (const Piece& piece : make_pieces(level.inverted, alu_bits)) {
      out.plain(Opcode::xor_constant, field_at(base + piece.begin, piece.end - piece.begin), {}, piece.pattern);
    }
    for (const csg::AndRun& meeting : level.and_runs) {
      for (std::uint32_t done = 0; done < meeting.bits; done += most) {
        const std::uint32_t bits = std::min(meeting.bits - done, most);
        const isa::Field first = field_at(base + meeting.first + done, bits);
        out.append_bitwise(Opcode::bit_and, first, first, field_at(base + meeting.second + done, bits));
      }
    }
  }
}

namespace {

ClassificationBits parallel_bits(const csg::ActiveTree& active, const Options& /*options*/) {
  return {.stack = string_bits(active)};
}

std::uint64_t emit_parallel(const Context& context, Broadcast& out, const PlannedSurface& planned) {
  ParallelEmitter emitter(context, out, planned);
  for (const std::uint32_t operand : planned.active.operands) emitter.narrow_mask_by(operand);
  return emitter.classified();
}

}  // namespace

/// Thesis 4.4.2: one bit per leaf; all nodes of a level are evaluated at once.
extern const StrategyRow parallel_strategy{.bits = parallel_bits, .classify = emit_parallel};

}  // namespace csgsim::emit

// Appends instructions to a segment, with their origins and the effect that they are billed to.
// Used by host/effects and sim/story.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/csg/counted.h"
#include "host/view/fixed_point.h"
#include "host/view/projection.h"
#include "host/view/screen_quadric.h"
#include "hw/base/work.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

/// Counts of scan conversions, as in table 6.1 of the thesis.
struct ScanConversions {
  std::uint64_t rendered = 0;     ///< surfaces written to Z1
  std::uint64_t classified = 0;   ///< primitives of active trees compared with Z1
  std::uint64_t depth_tests = 0;  ///< comparisons of Z1 with Z2
};

/// Number of bits of the shortest two's complement number that holds every value of the range.
unsigned signed_width(const view::Range& range);

/// Appends instructions to a segment. Every appended instruction gets `origin`, except that its effect is `effect`.
/// Redundant loads of E from, or stores of E to, the bit known to equal E are omitted.
class Broadcast {
 public:
  /// Instructions are charged to `work`, so the functions that append them may throw WorkError.
  Broadcast(isa::Segment& segment, const view::Sampling& sampling, Work work = {});

  isa::Origin origin;
  std::uint8_t effect = isa::no_effect;  ///< effect that instructions are billed to
  ScanConversions counts;                ///< scan conversions made until now
  csg::Counted counted{};                ///< counts the tests that find the widths of expressions

  /// Appends an instruction without a linear expression.
  void plain(isa::Opcode opcode, isa::Field first = {}, isa::Field second = {}, std::uint64_t constant = 0);

  /// Appends an instruction that combines three fields bit by bit.
  void append_bitwise(isa::Opcode opcode, isa::Field target, isa::Field left, isa::Field right);

  /// field := constant where E is 1. The field may have any width.
  void constant(isa::Field field, std::uint64_t value);

  /// target := source * 2^left_shift where E is 1, truncated to the target, which may have any width. Source and target
  /// may be the same bits if `left_shift` is 0.
  void shifted(isa::Field source, isa::Field target, unsigned left_shift);

  /// E := 0.
  void disable_all();

  /// Number of instructions in the segment.
  [[nodiscard]] std::size_t size() const { return segment_.instructions.size(); }

  /// The instructions from index `begin` on.
  [[nodiscard]] std::span<const isa::Instruction> from(std::size_t begin) const {
    return std::span<const isa::Instruction>(segment_.instructions).subspan(begin);
  }

  /// Inserts an instruction that changes neither E nor memory before the instruction at `index`. No skip may span that
  /// position.
  void insert(std::size_t index, const isa::Instruction& instruction);

  /// Compares or combines a surface plane with a depth field. The operand is as wide as the plane's values over
  /// `pixels` require; E must be 0 outside `pixels`.
  void surface(isa::Opcode opcode, isa::Field field, const view::FixedLinear& plane, const view::PixelRect& pixels);

  /// Compares or combines a linear expression, whose low `shift` bits are its fraction, with a field; E must be 0
  /// outside `pixels`.
  void expression(isa::Opcode opcode, isa::Field field, const view::FixedLinear& linear, unsigned shift,
                  const view::PixelRect& pixels);

  /// E stays 1 where the line's value is not negative or, for Opcode::edge_negative, negative. E must be 0 outside
  /// `pixels`.
  void edge(isa::Opcode opcode, const view::FixedLinear& line, const view::PixelRect& pixels);

  /// Compares or combines a quadratic expression, whose low `shift` bits are its fraction, with a field, or with none
  /// (width 0), using an opcode that takes a linear expression; E must be 0 outside `pixels`.
  void quadratic(isa::Opcode opcode, isa::Field field, const view::FixedQuadratic& quadratic, unsigned shift,
                 const view::PixelRect& pixels);

  /// E stays 1 where bit `width` - 1 of the line's value is 1, that is, in every second stripe. The value changes by
  /// 2^(width - 1) across a stripe.
  void stripe(const view::FixedLinear& line, unsigned width);

  /// E stays 1 where the field equals the number.
  void equals(isa::Field field, std::uint32_t number);

  /// E stays 1 inside `inner` only; E must be 0 outside `outer`. Sides that do not cut `outer` cost no instruction.
  void clip(const view::PixelRect& inner, const view::PixelRect& outer);

 private:
  void cut(isa::Opcode opcode, const view::FixedLinear& line, const view::PixelRect& pixels);
  void linear(isa::Opcode opcode, isa::Field field, view::FixedLinear plane, unsigned shift,
              const view::PixelRect& pixels);
  void append(const isa::Instruction& instruction);

  isa::Segment& segment_;
  unsigned fraction_bits_;
  Work work_;
  isa::Field equal_;  ///< a bit that equals E at every pixel; width 0 if none is known
};

/// Bills the instructions appended during its lifetime to an effect, unless they are already billed to one.
class Billing {
 public:
  Billing(Broadcast& out, std::size_t effect) : out_(out), before_(out.effect) {
    // Effect 0 is flat shading: shading instructions without a billed effect belong to it.
    if (before_ == isa::no_effect && effect > 0) out.effect = static_cast<std::uint8_t>(effect);
  }
  ~Billing() { out_.effect = before_; }
  Billing(const Billing&) = delete;
  Billing& operator=(const Billing&) = delete;

 private:
  Broadcast& out_;
  std::uint8_t before_;
};

}  // namespace csgsim::emit

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "host/view/fixed_point.h"
#include "host/view/projection.h"
#include "host/view/screen_quadric.h"
#include "hw/base/work.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

/// Scan-conversions, as table 6.1 of the thesis counts them.
struct ScanConversions {
  std::uint64_t rendered = 0;     ///< surfaces into Z1
  std::uint64_t classified = 0;   ///< primitives of active trees compared with Z1
  std::uint64_t depth_tests = 0;  ///< Z1 compared with Z2
};

/// Bits of the shortest two's complement number that holds every value of the range.
unsigned signed_width(const view::Range& range);

/// Appends instructions to a segment. `origin`, but for its effect, goes with every instruction appended. What would
/// change nothing is left out: to load the bit that E is known to be equal to, or to store E there.
class Broadcast {
 public:
  /// Instructions are charged to `work`: what appends one may throw WorkError.
  Broadcast(isa::Segment& segment, const view::Sampling& sampling, Work work = {});

  isa::Origin origin;
  std::uint8_t effect = isa::no_effect;  ///< that instructions are billed to
  ScanConversions counts;                ///< made so far

  /// An instruction without a linear expression.
  void plain(isa::Opcode opcode, isa::Field first = {}, isa::Field second = {}, std::uint64_t constant = 0);

  /// An instruction on three fields, element by element.
  void bitwise(isa::Opcode opcode, isa::Field target, isa::Field left, isa::Field right);

  /// Where E is 1: field := constant. The field may have any width.
  void constant(isa::Field field, std::uint64_t value);

  /// Where E is 1: target := source * 2^up, as much of it as fits the target, which may have any width. They may be the
  /// same bits where nothing is shifted.
  void shifted(isa::Field source, isa::Field target, unsigned up);

  /// E := 0.
  void nowhere();

  /// Instructions in the segment so far.
  [[nodiscard]] std::size_t size() const { return segment_.instructions.size(); }

  /// The instructions from that one on.
  [[nodiscard]] std::span<const isa::Instruction> from(std::size_t begin) const {
    return std::span<const isa::Instruction>(segment_.instructions).subspan(begin);
  }

  /// Puts an instruction that changes neither E nor memory before that one. No skip may reach over the place.
  void insert(std::size_t place, const isa::Instruction& instruction);

  /// A surface plane against a depth field, as wide as its values over `pixels` ask; E has to be 0 outside `pixels`.
  void surface(isa::Opcode opcode, isa::Field field, const view::FixedLinear& plane, const view::PixelRect& pixels);

  /// A linear expression, of which the low `shift` bits are the fraction, against a field; E has to be 0 outside
  /// `pixels`.
  void expression(isa::Opcode opcode, isa::Field field, const view::FixedLinear& linear, unsigned shift,
                  const view::PixelRect& pixels);

  /// E stays 1 where the line is not negative (or is negative); E has to be 0 outside `pixels`.
  void edge(isa::Opcode opcode, const view::FixedLinear& line, const view::PixelRect& pixels);

  /// A quadratic expression, of which the low `shift` bits are the fraction, against a field or, of width 0, none, by
  /// an instruction that takes a linear one; E has to be 0 outside `pixels`.
  void quadratic(isa::Opcode opcode, isa::Field field, const view::FixedQuadratic& quadratic, unsigned shift,
                 const view::PixelRect& pixels);

  /// E stays 1 where bit `width` - 1 of the line's value is 1: in every other of the stripes in which the value goes
  /// through 2^(width - 1) steps.
  void stripe(const view::FixedLinear& line, unsigned width);

  /// E stays 1 where the field holds that number.
  void equals(isa::Field field, std::uint32_t number);

  /// E stays 1 inside `inner` only; E has to be 0 outside `outer`. Sides that do not cut `outer` cost nothing.
  void clip(const view::PixelRect& inner, const view::PixelRect& outer);

 private:
  void linear(isa::Opcode opcode, isa::Field field, view::FixedLinear plane, unsigned shift,
              const view::PixelRect& pixels);
  void append(const isa::Instruction& instruction);

  isa::Segment& segment_;
  unsigned fraction_bits_;
  Work work_;
  isa::Field equal_;  ///< a bit that E is equal to at every pixel; of width 0 if none is known
};

/// While it lives, what is broadcast is billed to an effect, unless it is billed already.
class Billing {
 public:
  Billing(Broadcast& out, std::size_t effect) : out_(out), before_(out.effect) {
    // The first is flat shading, whose instructions are all that are for shading and for no other.
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

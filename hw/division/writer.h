#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/corners.h"
#include "hw/division/display_model.h"
#include "hw/division/expression.h"
#include "hw/isa/instruction.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program.h"

namespace csgsim::division {

/// Writes the instructions of one square, omitting those without effect: loading the bit that E is known to equal, or
/// storing E there. Refers to the model's header.
class Writer {
 public:
  Writer(const ModelHeader& header, const isa::Region& square) : header_(header), square_(square) {}

  isa::Origin origin;  ///< origin of every instruction written

  void plain(isa::Opcode opcode, isa::Field field = {}, isa::Field second = {}, std::uint64_t constant = 0);
  void set(isa::Field field, std::uint64_t constant) { plain(isa::Opcode::set_constant, field, {}, constant); }

  /// A depth plane compared with a field, as wide as its values over the pixels require; E must be 0 outside them.
  void depth(isa::Opcode opcode, isa::Field field, const Plane& plane, const Rectangle& pixels);

  /// A line whose sign is tested; E must be 0 outside the pixels.
  void line(isa::Opcode opcode, const Plane& line, const Rectangle& pixels);

  /// Keeps E only inside `inner`; E must be 0 outside `outer`.
  void clip(const Rectangle& inner, const Rectangle& outer);

  /// Writes the edge tests among `tested` that do not contain all of the pixels.
  void edges(const std::vector<Tested>& tested, const Rectangle& pixels);

  [[nodiscard]] const std::vector<isa::Instruction>& written() const { return written_; }
  [[nodiscard]] std::vector<isa::Instruction> take() { return std::move(written_); }

 private:
  void linear(isa::Opcode opcode, isa::Field field, const Expression& expression, const Rectangle& pixels);

  void write(const isa::Instruction& instruction);

  const ModelHeader& header_;
  isa::Region square_;
  isa::Field known_enable_;  ///< a bit known to equal E at every pixel; width 0 if there is none
  std::vector<isa::Instruction> written_;
};

}  // namespace csgsim::division

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

/// Writes the instructions of one square. Omits instructions without effect: loading E from a bit that is known to
/// equal E, and storing E in such a bit. Keeps a reference to the model's header.
class Writer {
 public:
  Writer(const ModelHeader& header, const isa::Region& square) : header_(header), square_(square) {}

  isa::Origin origin;  ///< origin of every instruction written

  void plain(isa::Opcode opcode, isa::Field field = {}, isa::Field second = {}, std::uint64_t constant = 0);
  void set(isa::Field field, std::uint64_t constant) { plain(isa::Opcode::set_constant, field, {}, constant); }

  /// Compares a depth plane with a field, in the width that the plane's values over the pixels require. E must be 0
  /// outside the pixels.
  void depth(isa::Opcode opcode, isa::Field field, const Plane& plane, const Rectangle& pixels);

  /// Tests the sign of a line. E must be 0 outside the pixels.
  void line(isa::Opcode opcode, const Plane& line, const Rectangle& pixels);

  /// Clears E outside `inner`. E must be 0 outside `outer`.
  void clip(const Rectangle& inner, const Rectangle& outer);

  /// Writes the edge tests in `tested` that some of the pixels may fail.
  void edges(const std::vector<TestedHalfspace>& tested, const Rectangle& pixels);

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

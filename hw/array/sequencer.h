#pragma once

#include <cstdint>

#include "hw/array/array_step.h"
#include "hw/array/linear_evaluator.h"
#include "hw/isa/instruction.h"

namespace csgsim::array {

/// What the controller issues in one clock.
struct BitStep {
  RootBits root;      ///< to the roots of the multiplier trees
  ArrayStep pixels;   ///< to the pixels, when the bits that entered the trees with it arrive there
  bool last = false;  ///< of its instruction
};

/// Expands one instruction into bit steps, a step a clock. A step on fields works on as many adjacent bits as the ALU
/// is wide; linear expressions come one bit a clock, and so does a root's remainder.
class Sequencer {
 public:
  /// `memory_reads`: read ports of pixel memory, 1 or 2. `alu_bits`: bits that the ALU works on in a clock.
  Sequencer(unsigned memory_reads, unsigned alu_bits) : two_ports_(memory_reads >= 2), alu_bits_(alu_bits) {}

  void begin(const isa::Instruction& instruction);
  [[nodiscard]] bool busy() const { return busy_; }

  /// The step of this clock. There is one while busy().
  BitStep issue();

  [[nodiscard]] const isa::Instruction& instruction() const { return instruction_; }
  /// What the instruction before has left for its stream; zeros if that was no `squares`.
  [[nodiscard]] const isa::Linear& squares() const { return squares_; }
  [[nodiscard]] std::uint32_t bit() const { return bit_; }    ///< of the field or stream, the first of the step to come
  [[nodiscard]] std::uint32_t pass() const { return pass_; }  ///< times the stream or the memory read has been repeated

 private:
  /// What F's bit in the current clock means for the field it meets.
  enum class Place : std::uint8_t { fraction, field, beyond, sign };

  BitStep once(ArrayStep step);
  BitStep stream_bit(ArrayStep step, unsigned passes);
  BitStep field_bits(ArrayStep step);
  BitStep two_operand_bits(ArrayStep step);
  BitStep trial_bit();

  [[nodiscard]] Place place() const;
  [[nodiscard]] std::uint16_t field_address(unsigned operand) const;
  [[nodiscard]] std::uint16_t step_bits() const;
  [[nodiscard]] std::uint16_t second_bits() const;

  [[nodiscard]] ArrayStep enable_from_memory(AluFunction function) const;
  [[nodiscard]] ArrayStep edge_step(AluFunction on_sign) const;
  [[nodiscard]] ArrayStep compare_step(AluFunction first, AluFunction on_sign) const;
  [[nodiscard]] ArrayStep equal_step() const;
  [[nodiscard]] ArrayStep load_step(AluFunction write, AluFunction check) const;
  [[nodiscard]] ArrayStep added_step(AluFunction first, AluFunction rest) const;
  [[nodiscard]] ArrayStep trial_step(std::uint32_t place) const;
  [[nodiscard]] ArrayStep keep_step(AluFunction first, AluFunction on_sign) const;
  [[nodiscard]] ArrayStep store_step(AluFunction function) const;
  [[nodiscard]] ArrayStep change_step(AluFunction function) const;
  [[nodiscard]] ArrayStep sum_step() const;
  [[nodiscard]] ArrayStep less_step(AluFunction compare_first, AluFunction decide_first) const;

  bool two_ports_;
  unsigned alu_bits_;
  isa::Instruction instruction_;
  isa::Linear squares_;
  bool busy_ = false;
  std::uint32_t bit_ = 0;
  std::uint32_t pass_ = 0;
  std::uint32_t trial_ = 0;  ///< of a root: the bit of it that is found, the highest first
};

}  // namespace csgsim::array

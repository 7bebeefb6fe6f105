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
/// is wide, one on a linear expression on as many as the trees bring; a root's remainder comes one bit a clock.
class Sequencer {
 public:
  /// `memory_reads`: read ports of pixel memory, 1 or 2. `alu_bits`: bits that the ALU works on in a clock.
  /// `evaluator_bits`: those of F that the trees bring it, at most as many.
  Sequencer(unsigned memory_reads, unsigned alu_bits, unsigned evaluator_bits)
      : two_ports_(memory_reads >= 2), alu_bits_(alu_bits), evaluator_bits_(evaluator_bits) {}

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
  /// What is done with F's bits by what they mean for the field that they meet; with those of its fraction nothing is.
  struct Places {
    AluFunction first = AluFunction::idle;   ///< on the field's first bit
    AluFunction field = AluFunction::idle;   ///< on its others
    AluFunction beyond = AluFunction::idle;  ///< between the field and the sign
    AluFunction sign = AluFunction::idle;    ///< on the last bit of F
  };

  /// Of the current clock's bits of F, how many are of which place, in this order.
  struct Shares {
    unsigned fraction = 0;
    unsigned field = 0;
    unsigned beyond = 0;
    unsigned sign = 0;  ///< 0 or 1
  };

  BitStep once(ArrayStep step);
  BitStep stream_bits(const Places& places, unsigned passes);
  BitStep field_bits(ArrayStep step);
  BitStep two_operand_bits(ArrayStep step);
  BitStep trial_bit();

  [[nodiscard]] Shares shares() const;
  [[nodiscard]] ArrayStep linear_step(const Places& places) const;
  [[nodiscard]] ArrayStep field_step(const Places& places, const Shares& of) const;
  [[nodiscard]] std::uint16_t stream_width() const;
  [[nodiscard]] std::uint16_t field_address(unsigned operand) const;
  [[nodiscard]] std::uint16_t step_bits() const;
  [[nodiscard]] std::uint16_t second_bits() const;

  [[nodiscard]] ArrayStep enable_from_memory(AluFunction function) const;
  static Places compared(AluFunction first, AluFunction on_sign);
  static Places loaded(AluFunction write, AluFunction check);
  [[nodiscard]] Places kept(AluFunction first, AluFunction on_sign) const;
  [[nodiscard]] ArrayStep trial_step(std::uint32_t place) const;
  [[nodiscard]] ArrayStep store_step(AluFunction function) const;
  [[nodiscard]] ArrayStep change_step(AluFunction function) const;
  [[nodiscard]] ArrayStep sum_step() const;
  [[nodiscard]] ArrayStep less_step(AluFunction compare_first, AluFunction decide_first) const;

  bool two_ports_;
  unsigned alu_bits_;
  unsigned evaluator_bits_;
  isa::Instruction instruction_;
  isa::Linear squares_;
  bool busy_ = false;
  std::uint32_t bit_ = 0;
  std::uint32_t pass_ = 0;
  std::uint32_t trial_ = 0;  ///< of a root: the bit of it that is found, the highest first
};

}  // namespace csgsim::array

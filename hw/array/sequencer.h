// Expands instructions into bit steps.
// Used by hw/pixel_planes and hw/pixel_square.
#pragma once

#include <cstdint>

#include "hw/array/array_step.h"
#include "hw/array/linear_evaluator.h"
#include "hw/isa/instruction.h"

namespace csgsim::array {

/// The output of the controller in one clock.
struct BitStep {
  RootBits root;      ///< bits for the roots of the multiplier trees
  ArrayStep pixels;   ///< control word, executed when these bits arrive at the pixels
  bool last = false;  ///< whether this is the last step of its instruction
};

/// Expands an instruction into bit steps, one per clock. A step on fields processes `alu_bits` adjacent bits, a step on
/// a linear expression `evaluator_bits`; the remainder of a square root is computed one bit per clock.
class Sequencer {
 public:
  /// `memory_reads`: read ports of pixel memory, 1 or 2. `alu_bits`: bits that the ALU processes in a clock.
  /// `evaluator_bits`: bits of F that the trees deliver in a clock, at most alu_bits.
  Sequencer(unsigned memory_reads, unsigned alu_bits, unsigned evaluator_bits)
      : two_ports_(memory_reads >= 2), alu_bits_(alu_bits), evaluator_bits_(evaluator_bits) {}

  void begin(const isa::Instruction& instruction);
  [[nodiscard]] bool busy() const { return busy_; }

  /// The step of this clock; requires busy().
  BitStep issue();

  [[nodiscard]] const isa::Instruction& instruction() const { return instruction_; }
  /// The coefficients of the preceding instruction `squares`, for the stream of this instruction; zero if there was
  /// none.
  [[nodiscard]] const isa::Linear& squares() const { return squares_; }
  [[nodiscard]] std::uint32_t bit() const { return bit_; }  ///< index of the first field or stream bit of the next step
  /// Number of completed passes over the stream or the memory operand.
  [[nodiscard]] std::uint32_t pass() const { return pass_; }

 private:
  /// Functions for the bits of F by their position relative to the field. Fraction bits are ignored.
  struct PositionFunctions {
    AluFunction first = AluFunction::idle;   ///< function of the field's first bit
    AluFunction field = AluFunction::idle;   ///< function of its other bits
    AluFunction beyond = AluFunction::idle;  ///< function of bits between the field and the sign
    AluFunction sign = AluFunction::idle;    ///< function of the last bit of F
  };

  /// Numbers of this clock's bits of F in each of these positions, lowest position first.
  struct BitCounts {
    unsigned fraction = 0;
    unsigned field = 0;
    unsigned beyond = 0;
    unsigned sign = 0;  ///< 0 or 1
  };

  BitStep single_step(ArrayStep step);
  BitStep next_stream_step(const PositionFunctions& places, unsigned passes);
  BitStep next_field_step(ArrayStep step);
  BitStep next_two_operand_step(ArrayStep step);
  BitStep next_trial_step();

  [[nodiscard]] BitCounts bit_counts() const;
  [[nodiscard]] ArrayStep linear_step(const PositionFunctions& places) const;
  [[nodiscard]] ArrayStep field_step(const PositionFunctions& places, const BitCounts& counts) const;
  [[nodiscard]] std::uint16_t stream_width() const;
  [[nodiscard]] std::uint16_t field_address(unsigned operand) const;
  [[nodiscard]] std::uint16_t step_bits() const;
  [[nodiscard]] std::uint16_t second_bits() const;

  [[nodiscard]] ArrayStep enable_from_memory(AluFunction function) const;
  static PositionFunctions comparison_functions(AluFunction first_bit_function, AluFunction sign_function);
  static PositionFunctions load_functions(AluFunction field_function, AluFunction beyond_function);
  [[nodiscard]] PositionFunctions keep_functions(AluFunction first_bit_function, AluFunction sign_function) const;
  [[nodiscard]] ArrayStep trial_step(std::uint32_t trial_bit_index) const;
  [[nodiscard]] ArrayStep store_step(AluFunction function) const;
  [[nodiscard]] ArrayStep read_modify_write_step(AluFunction function) const;
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
  std::uint32_t trial_ = 0;  ///< index of the root bit being computed, 0 for the highest
};

}  // namespace csgsim::array

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "hw/machines/machine.h"
#include "hw/scan_line/chain.h"
#include "tests/rtl/scan_line/rtl_chain.h"

namespace csgsim::rtl {

/// Bits of a register, the least significant first.
__extension__ using Bits = unsigned __int128;

/// Holds a cell in Verilog against the SystemC, of which memory, enable, hold register and shift chain are looked at,
/// and its other registers against those of plain cells. These have operands from bit 0 on where the Verilog has them
/// as they lie in words: those of fields that are read, and F, until they are moved, then where they have come to lie,
/// and then with what the ALU has put there.
class CellCheck {
 public:
  CellCheck(std::uint32_t cell, const scan_line::CellShape& shape, const machines::Machine& machine);

  /// Lines of another width come, or the first: in Verilog packets of narrower ones were here, too.
  void begin() {
    is_cleared_ = false;
    held_ = shown_ = {};
  }

  /// `worked`: the beat that was in the cell in the clock that has been; `pixels`: of a line.
  /// Returns the first difference; empty if there is none.
  std::string compare(const scan_line::Chain& chain, const test::PlainChain& plain, const test::PlainBeat& worked,
                      std::uint32_t pixels, const ChainRegisters& registers);

 private:
  void compare_state();
  void compare_handed_on();
  void compare_refresh();
  void compare_sum();
  void compare_operands();
  void compare_alu();

  void expect(std::string_view what, Bits systemc, Bits verilog);
  /// Of a register of so many bits a cell.
  [[nodiscard]] Bits of(const Vector& registers, std::uint32_t bits) const;
  [[nodiscard]] bool bit_of(const Vector& registers) const { return of(registers, 1) != 0; }
  [[nodiscard]] std::uint32_t place_of(isa::Field field) const { return field.base % shape_.word_bits; }
  /// Clocks that the packet's work has had, and those of its moves.
  [[nodiscard]] std::uint32_t worked_clocks() const;
  [[nodiscard]] std::uint32_t move_clocks() const;
  [[nodiscard]] bool is_moved() const { return worked_clocks() >= move_clocks(); }
  /// Bits that the ALU has gone through.
  [[nodiscard]] std::uint32_t taken() const;

  const std::uint32_t cell_;
  const scan_line::CellShape shape_;
  const std::uint32_t memory_bits_;
  const unsigned degree_;
  std::uint32_t f_bits_;
  std::uint32_t x_bits_;  ///< and y's
  std::uint32_t colour_bits_;
  bool is_cleared_ = false;
  std::optional<isa::Field> held_;   ///< where the colour in the hold register lay
  std::optional<isa::Field> shown_;  ///< and those in the shift chain

  // Of the comparison that is made.
  const scan_line::Chain* chain_ = nullptr;
  const test::PlainChain* plain_ = nullptr;
  const test::PlainBeat* worked_ = nullptr;
  const ChainRegisters* registers_ = nullptr;
  std::uint32_t pixels_ = 0;
  std::string difference_;
};

}  // namespace csgsim::rtl

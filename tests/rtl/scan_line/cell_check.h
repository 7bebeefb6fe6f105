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

/// Compares a cell in Verilog with the SystemC, where memory, enable, hold register and shift chain are visible, and
/// its other registers with those of plain cells. Plain cells have operands from bit 0 on. In Verilog, fields that are
/// read, and F, are first aligned as in their words, then moved, and then replaced by the ALU's results.
class CellCheck {
 public:
  CellCheck(std::uint32_t cell, const scan_line::CellShape& shape, const machines::Machine& machine);

  /// Starts lines of another width, or the first: the Verilog cells have also seen packets of narrower lines.
  void begin() {
    is_cleared_ = false;
    held_ = shown_ = {};
  }

  /// Compares a clock: `worked` is the beat that was in the cell, `pixels` the width of the line.
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
  /// The cell's part of a register of `bits` bits per cell.
  [[nodiscard]] Bits of(const Vector& registers, std::uint32_t bits) const;
  [[nodiscard]] bool bit_of(const Vector& registers) const { return of(registers, 1) != 0; }
  [[nodiscard]] std::uint32_t place_of(isa::Field field) const { return field.base % shape_.word_bits; }
  /// Clocks spent on the packet's work, and those of its moves.
  [[nodiscard]] std::uint32_t worked_clocks() const;
  [[nodiscard]] std::uint32_t move_clocks() const;
  [[nodiscard]] bool is_moved() const { return worked_clocks() >= move_clocks(); }
  /// Number of bits processed by the ALU.
  [[nodiscard]] std::uint32_t taken() const;

  const std::uint32_t cell_;
  const scan_line::CellShape shape_;
  const std::uint32_t memory_bits_;
  const unsigned degree_;
  std::uint32_t f_bits_;
  std::uint32_t x_bits_;  ///< number of bits of the registers x and y
  std::uint32_t colour_bits_;
  bool is_cleared_ = false;
  std::optional<isa::Field> held_;   ///< the field from which the hold register was loaded
  std::optional<isa::Field> shown_;  ///< the field from which the shift chain was loaded

  // State of the current comparison.
  const scan_line::Chain* chain_ = nullptr;
  const test::PlainChain* plain_ = nullptr;
  const test::PlainBeat* worked_ = nullptr;
  const ChainRegisters* registers_ = nullptr;
  std::uint32_t pixels_ = 0;
  std::string difference_;
};

}  // namespace csgsim::rtl

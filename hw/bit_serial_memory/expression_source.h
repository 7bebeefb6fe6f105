#pragma once

#include <cstdint>
#include <span>
#include <systemc>
#include <vector>

#include "hw/bit_serial_memory/slots.h"
#include "hw/isa/instruction.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// Source of the bits of an expression, column by column.
class ExpressionBits : virtual public sc_core::sc_interface {
 public:
  /// Begins the next instruction's expression; `squares` are the quadratic terms from the preceding instruction.
  virtual void begin(const isa::Linear& linear, const isa::Linear& squares) = 0;
  /// Writes one bit of the expression for each column of a slot.
  virtual void bits(std::uint64_t slot, unsigned bit, std::span<std::uint64_t> words) = 0;
};

/// Computes A*x + B*y + C for each column, as the host or the multiplier trees do.
class ExpressionSource final : public sc_core::sc_module, public ExpressionBits {
 public:
  ExpressionSource(sc_core::sc_module_name name, const Slots& slots, std::uint32_t width)
      : sc_core::sc_module(name), slots_(slots), width_(width), values_(slots.count()) {}

  void begin(const isa::Linear& linear, const isa::Linear& squares) override;
  void bits(std::uint64_t slot, unsigned bit, std::span<std::uint64_t> words) override;

 private:
  void compute_values(std::uint64_t slot);

  const Slots slots_;
  const std::uint32_t width_;  ///< width of the picture
  isa::Linear linear_;
  isa::Linear squares_;
  std::vector<std::vector<std::uint64_t>> values_;  ///< values of each slot, computed on first use
};

}  // namespace csgsim::bit_serial_memory

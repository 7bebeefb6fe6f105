#pragma once

#include <cstdint>
#include <span>
#include <systemc>
#include <vector>

#include "hw/bit_serial_memory/slots.h"
#include "hw/isa/instruction.h"
#include "hw/machines/machine.h"

namespace csgsim::bit_serial_memory {

/// Where the bits of an expression come from, column by column.
class ExpressionBits : virtual public sc_core::sc_interface {
 public:
  /// Of the instruction to come; `squares`: what the one before it has left.
  virtual void begin(const isa::Linear& linear, const isa::Linear& squares) = 0;
  /// A bit of it in each column of a slot.
  virtual void bits(std::uint64_t slot, unsigned bit, std::span<std::uint64_t> words) = 0;
};

/// The host, or the multiplier trees, which work A*x + B*y + C out for each column of their own.
class ExpressionSource final : public sc_core::sc_module, public ExpressionBits {
 public:
  ExpressionSource(sc_core::sc_module_name name, const Slots& slots, std::uint32_t width)
      : sc_core::sc_module(name), slots_(slots), width_(width), values_(slots.count()) {}

  void begin(const isa::Linear& linear, const isa::Linear& squares) override;
  void bits(std::uint64_t slot, unsigned bit, std::span<std::uint64_t> words) override;

 private:
  void work_out(std::uint64_t slot);

  const Slots slots_;
  const std::uint32_t width_;  ///< of the picture
  isa::Linear linear_;
  isa::Linear squares_;
  std::vector<std::vector<std::uint64_t>> values_;  ///< of each slot, as far as they have been asked for
};

}  // namespace csgsim::bit_serial_memory

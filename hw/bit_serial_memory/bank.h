#pragma once

#include <cstdint>
#include <systemc>
#include <vector>

#include "hw/bit_serial_memory/account.h"
#include "hw/bit_serial_memory/expression_source.h"
#include "hw/bit_serial_memory/row_command.h"
#include "hw/bit_serial_memory/slots.h"
#include "hw/bit_serial_memory/subarray.h"

namespace csgsim::bit_serial_memory {

/// The controller's interface to a bank.
class BankPort : virtual public sc_core::sc_interface {
 public:
  /// Edge from which the bank is closed or its gates are free.
  [[nodiscard]] virtual sc_core::sc_time free() const = 0;
  /// Executes a command in one of the bank's slots; the bank is busy until the edge `until`.
  virtual void carry_out(const RowCommand& command, std::uint64_t slot, const sc_core::sc_time& until) = 0;
  /// Executes a gate command in all of the bank's slots; it takes `duration`.
  virtual void carry_out_in_all(const RowCommand& command, const sc_core::sc_time& duration) = 0;
  /// Keeps the bank busy at least until `edge`.
  virtual void hold_until(const sc_core::sc_time& edge) = 0;
  /// Delays the command in progress by `duration`.
  virtual void delay(const sc_core::sc_time& duration) = 0;
};

/// The subarrays of a bank that hold pixels, in all chips. The bank counts the commands that it executes.
class Bank final : public sc_core::sc_module, public BankPort {
 public:
  sc_core::sc_port<ExpressionBits> expression{"expression"};

  /// `number`: index of the bank; it holds the slots that are assigned to it.
  Bank(sc_core::sc_module_name name, std::uint32_t number, const Slots& slots, const RowMap& map,
       std::uint32_t picture_width);

  [[nodiscard]] sc_core::sc_time free() const override { return free_; }
  void carry_out(const RowCommand& command, std::uint64_t slot, const sc_core::sc_time& until) override;
  void carry_out_in_all(const RowCommand& command, const sc_core::sc_time& duration) override;
  void hold_until(const sc_core::sc_time& edge) override { free_ = std::max(free_, edge); }
  void delay(const sc_core::sc_time& duration) override { free_ += duration; }

  /// Begins a frame.
  void begin() { work_ = {}; }
  [[nodiscard]] const Work& work() const { return work_; }
  [[nodiscard]] const Subarray& subarray(std::uint64_t slot) const { return subarrays_[slot / slots_.banks]; }
  [[nodiscard]] bool busy() const { return free_ > sc_core::sc_time_stamp(); }

 private:
  void execute(const RowCommand& command, std::uint64_t slot);
  void write_coordinates(Subarray& subarray, std::uint64_t slot, const RowMap& map, std::uint32_t picture_width) const;

  const std::uint32_t number_;
  const Slots slots_;
  std::vector<Subarray> subarrays_;
  sc_core::sc_time free_;
  Work work_;
};

}  // namespace csgsim::bit_serial_memory

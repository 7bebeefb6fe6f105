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

/// A bank as the controller sees it.
class BankPort : virtual public sc_core::sc_interface {
 public:
  /// The edge at which the bank is closed, or its gates are free.
  [[nodiscard]] virtual sc_core::sc_time free() const = 0;
  /// One of its slots carries out a command, and the bank is busy until then.
  virtual void carry_out(const RowCommand& command, std::uint64_t slot, const sc_core::sc_time& until) = 0;
  /// All its slots carry out a command of the gates, for so long.
  virtual void carry_out_in_all(const RowCommand& command, const sc_core::sc_time& duration) = 0;
  /// Nothing is busy before then.
  virtual void hold_until(const sc_core::sc_time& edge) = 0;
  /// What it was busy with goes on later by so much.
  virtual void delay(const sc_core::sc_time& duration) = 0;
};

/// The subarrays of a bank that hold pixels, of all chips. It counts what it is told to do.
class Bank final : public sc_core::sc_module, public BankPort {
 public:
  sc_core::sc_port<ExpressionBits> expression{"expression"};

  /// `number`: of the bank; of the slots it has those that are dealt out to it.
  Bank(sc_core::sc_module_name name, std::uint32_t number, const Slots& slots, const RowMap& map,
       std::uint32_t picture_width);

  [[nodiscard]] sc_core::sc_time free() const override { return free_; }
  void carry_out(const RowCommand& command, std::uint64_t slot, const sc_core::sc_time& until) override;
  void carry_out_in_all(const RowCommand& command, const sc_core::sc_time& duration) override;
  void hold_until(const sc_core::sc_time& edge) override { free_ = std::max(free_, edge); }
  void delay(const sc_core::sc_time& duration) override { free_ += duration; }

  /// For a frame.
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

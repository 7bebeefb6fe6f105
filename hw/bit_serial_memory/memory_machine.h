#pragma once

#include <cstdint>
#include <deque>
#include <systemc>
#include <vector>

#include "hw/bit_serial_memory/bank.h"
#include "hw/bit_serial_memory/command_queue.h"
#include "hw/bit_serial_memory/completion.h"
#include "hw/bit_serial_memory/controller.h"
#include "hw/bit_serial_memory/expression_source.h"
#include "hw/bit_serial_memory/host_link.h"
#include "hw/bit_serial_memory/memory_view.h"
#include "hw/isa/program.h"
#include "hw/machines/machine.h"
#include "hw/systemc/clocked_machine.h"
#include "hw/systemc/retirement.h"

namespace csgsim::bit_serial_memory {

/// A memory that computes, with its controller and the host's end of the link.
class MemoryMachine final : public sc_core::sc_module, public systemc::ClockedMachine {
 public:
  MemoryMachine(sc_core::sc_module_name name, const machines::Machine& machine);

  systemc::RunReport run(const isa::Program& program, systemc::RunListener& listener) override;

  [[nodiscard]] std::vector<wave::Tap> taps(const isa::Program& program, const wave::Request& request) const override;

 private:
  /// Creates the banks, each with its slots in order.
  std::vector<const Bank*> make_banks();
  void check(const isa::Program& program) const;
  void collect(unsigned bit);
  [[nodiscard]] systemc::RunReport report() const;
  [[nodiscard]] Work work() const;

  const machines::Machine machine_;
  const Figures figures_;
  const Slots slots_;
  const RowMap map_;
  const sc_core::sc_time period_;
  sc_core::sc_fifo<std::uint64_t> requests_{"requests", 2};
  CommandQueue queue_;
  HostLink host_;
  ExpressionSource expression_;
  std::deque<Bank> banks_;
  const std::vector<const Bank*> bank_list_;
  const MemoryView pixels_;
  Controller controller_;
  Completion completion_;
  systemc::Retirement retirement_{"retirement"};
  std::vector<std::uint32_t> picture_;  ///< assembled from the rows received by the host
};

}  // namespace csgsim::bit_serial_memory

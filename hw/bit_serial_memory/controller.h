#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <systemc>
#include <vector>

#include "hw/bit_serial_memory/account.h"
#include "hw/bit_serial_memory/activation_guard.h"
#include "hw/bit_serial_memory/bank.h"
#include "hw/bit_serial_memory/begun_commands.h"
#include "hw/bit_serial_memory/command_queue.h"
#include "hw/bit_serial_memory/figures.h"
#include "hw/bit_serial_memory/micro_program.h"
#include "hw/isa/wire.h"

namespace csgsim::bit_serial_memory {

/// Port on which the controller reports executed commands.
class ProgressPort : virtual public sc_core::sc_interface {
 public:
  virtual void before_instruction() = 0;
  virtual void after_clear() = 0;
  /// `clocks`: without refreshes. `skipped`: number of skipped instructions after this one.
  virtual void after_instruction(std::uint64_t clocks, std::optional<bool> answer, std::uint64_t skipped) = 0;
};

/// Takes commands from the queue, translates each to row commands and issues these to the banks, one slot after
/// another, as soon as the bank is free and the guard allows an activation. Refreshes all banks once per tREFI.
class Controller final : public sc_core::sc_module {
 public:
  sc_core::sc_port<QueueOutput> queue{"queue"};
  sc_core::sc_fifo_out<std::uint64_t> requests{"requests"};
  sc_core::sc_port<BankPort, 0> banks{"banks"};
  sc_core::sc_port<ExpressionBits> expression{"expression"};
  sc_core::sc_port<ProgressPort> progress{"progress"};

  Controller(sc_core::sc_module_name name, const Figures& figures, const Slots& slots, const RowMap& map,
             unsigned link_width, const sc_core::sc_time& period);

  /// Draws the frame in the host's memory, and scans it out afterwards if `shows`. `answer` returns the OR of the
  /// enable bits at the sense amplifiers, computed by the host or the wired OR.
  void begin(bool shows, std::function<bool()> answer);

  // Results of the frame drawn last.
  [[nodiscard]] std::uint64_t clocks() const { return clocks_; }
  [[nodiscard]] std::uint64_t shown_clocks() const { return shown_clocks_; }
  [[nodiscard]] const ControllerAccount& account() const { return account_; }
  [[nodiscard]] const std::array<std::uint64_t, row_op_count>& commands() const { return commands_; }
  [[nodiscard]] std::uint64_t refreshes() const { return refreshes_; }
  /// Registers a function that is called for each row sent to the host during scan-out.
  void on_sent_row(std::function<void(unsigned bit)> call) { on_sent_row_ = std::move(call); }

  // State for waves.
  [[nodiscard]] std::string_view state() const { return state_; }
  [[nodiscard]] std::optional<std::uint64_t> ordinal() const { return ordinal_; }
  /// Whether pixel memory has been cleared for the current frame.
  [[nodiscard]] bool cleared() const { return cleared_; }
  /// Row command that the first bank executes.
  [[nodiscard]] std::string row_command() const {
    const RowCommand* const current = started_.current();
    return current == nullptr ? "" : text_of(*current);
  }

 private:
  void work();
  void draw();
  isa::Command next_command();
  void begin(const isa::SegmentStart& start);
  void begin(const isa::SegmentEnd& /*end*/) {}
  void begin(const isa::FrameEnd& end);
  void begin(const isa::Instruction& instruction);
  void answer_question(const isa::Instruction& question, std::uint64_t start_clock, std::uint64_t refreshing);
  void scan_out(isa::Field colour);

  void carry_out(const RowCommands& commands);
  void refresh_before(const RowCommand& command);
  void issue(const RowCommand& command);
  void issue_to_slot(const RowCommand& command, std::uint64_t slot);
  void activate_at(std::uint64_t slot);
  void transfer(const RowCommand& command, std::uint64_t slot);
  void refresh();
  void refresh_idle();
  void settle();

  [[nodiscard]] sc_core::sc_time all_closed() const;
  [[nodiscard]] std::uint64_t edge() const;
  [[nodiscard]] sc_core::sc_time time_of(std::uint64_t clocks) const { return static_cast<double>(clocks) * period_; }
  void wait_until(const sc_core::sc_time& edge);

  const Figures figures_;
  const Slots slots_;
  const RowMap map_;
  const sc_core::sc_time period_;
  isa::WireDecoder decoder_;
  ActivationGuard guard_{"guard", figures_.rank, period_};
  sc_core::sc_event start_{"start"};
  std::function<bool()> answer_;
  std::function<void(unsigned bit)> on_sent_row_;

  bool shows_ = false;
  bool ended_ = false;
  bool jumped_ = false;
  bool cleared_ = false;
  sc_core::sc_time origin_;  ///< time of the frame's first edge
  sc_core::sc_time due_;     ///< time of the next refresh
  sc_core::sc_time bus_;     ///< time from which the data bus is free
  std::uint64_t next_ordinal_ = 0;
  isa::Linear squares_;  ///< additional terms of the next instruction's expression
  std::uint64_t clocks_ = 0;
  std::uint64_t shown_clocks_ = 0;
  std::uint64_t refreshes_ = 0;
  ControllerAccount account_;
  std::array<std::uint64_t, row_op_count> commands_{};
  std::string_view state_;
  std::optional<std::uint64_t> ordinal_;
  StartedCommands started_;
};

}  // namespace csgsim::bit_serial_memory
